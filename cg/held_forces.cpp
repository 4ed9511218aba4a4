#include "cg/held_forces.hpp"
#include <algorithm>
#include <bit>
#include <gsl/gsl_fft_halfcomplex.h>
#include <gsl/gsl_fft_real.h>

namespace mesobridge::cg {

ForceSpectra::ForceSpectra(HeldConfiguration const& configuration, std::size_t last)
    : configuration_(configuration), molecules_(configuration.R.size()),
      frames_(configuration.F.size() / molecules_), last_(last), padded_(std::bit_ceil(frames_ + last + 1)),
      numbers_(3 * molecules_ * padded_) {
  for (std::size_t m = 0; m < molecules_; ++m)
    for (int axis = 0; axis < 3; ++axis) {
      double* const x = numbers_.data() + (3 * m + std::size_t(axis)) * padded_;
      double mean = 0;
      for (std::size_t k = 0; k < frames_; ++k) {
        x[k] = component(configuration.F[k * molecules_ + m], axis);
        mean += x[k] / double(frames_);
      }
      for (std::size_t k = 0; k < frames_; ++k)
        x[k] -= mean;
      gsl_fft_real_radix2_transform(x, 1, padded_);
    }
}

void ForceSpectra::correlate(double* products, double* correlations) const {
  for (std::size_t k = 1; k < padded_ / 2; ++k)
    products[k] += products[padded_ - k], products[padded_ - k] = 0;
  gsl_fft_halfcomplex_radix2_inverse(products, 1, padded_);
  for (std::size_t lag = 0; lag <= last_; ++lag)
    correlations[lag] = products[lag] / double(frames_ - lag);
}

std::vector<double> ForceSpectra::self() const {
  std::vector<double> products(padded_), correlations(last_ + 1);
  for (std::size_t m = 0; m < molecules_; ++m)
    for (int axis = 0; axis < 3; ++axis)
      for (std::size_t k = 0; k < padded_; ++k)
        products[k] += of(m, axis)[k] * of(m, axis)[k] / double(3 * molecules_);
  correlate(products.data(), correlations.data());
  return correlations;
}

PairCorrelations ForceSpectra::pairs(double bin_width, std::size_t bins) const {
  PairCorrelations found{.bins = bins, .lags = last_ + 1, .along = {}, .whole = {}, .count = {}};
  found.along.resize(bins * found.lags), found.whole.resize(bins * found.lags);
  found.count.resize(bins * PairCorrelations::fine);
  std::vector<double> along(bins * padded_), whole(bins * padded_);
  double const part = bin_width / double(PairCorrelations::fine);
  for (std::size_t a = 0; a < molecules_; ++a)
    for (std::size_t b = a + 1; b < molecules_; ++b) {
      Vec3 const apart = configuration_.box.minimum_image(configuration_.R[a] - configuration_.R[b]);
      double const r = norm(apart);
      auto const piece = std::size_t(r / part), bin = piece / PairCorrelations::fine;
      if (bin >= bins)
        continue;
      found.count[piece] += 1;
      Vec3 const e = apart / r;
      double const *const ax = of(a, 0), *const ay = of(a, 1), *const az = of(a, 2), *const bx = of(b, 0),
                          *const by = of(b, 1), *const bz = of(b, 2);
      double *const sum_along = along.data() + bin * padded_, *const sum_whole = whole.data() + bin * padded_;
      for (std::size_t k = 0; k < padded_; ++k) {
        sum_along[k] += (e.x * ax[k] + e.y * ay[k] + e.z * az[k]) * (e.x * bx[k] + e.y * by[k] + e.z * bz[k]);
        sum_whole[k] += ax[k] * bx[k] + ay[k] * by[k] + az[k] * bz[k];
      }
    }
  for (std::size_t bin = 0; bin < bins; ++bin) {
    correlate(along.data() + bin * padded_, found.along.data() + bin * found.lags);
    correlate(whole.data() + bin * padded_, found.whole.data() + bin * found.lags);
  }
  return found;
}

} // namespace mesobridge::cg
