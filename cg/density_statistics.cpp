#include "cg/density_statistics.hpp"
#include "cg/jackknife.hpp"
#include <algorithm>
#include <cmath>
#include <numeric>

namespace mesobridge::cg {
namespace {

/// The sums of a block over all molecules, then those of each bin of the density.
enum : std::size_t { count, rho, rho2, U, U2, sum_W, rhoU, rhoW, scalars };
enum : std::size_t { in_bin, U_in_bin, W_in_bin, rho_in_bin, of_bin };

} // namespace

void density_results_into(BlobSeries const& series, std::vector<double> const& W,
                          std::vector<double> const& densities, CorrelationSettings const& settings,
                          std::vector<std::pair<std::size_t, std::size_t>> const& blocks, Correlations& out) {
  std::size_t const n = series.molecules, bins = settings.density_bins;
  double const U_mean = std::accumulate(series.U.begin(), series.U.end(), 0.0) / double(series.U.size());
  auto sorted = densities;
  std::sort(sorted.begin(), sorted.end());
  std::vector<double> borders; // bins of equally many samples
  for (std::size_t k = 1; k < bins; ++k)
    borders.push_back(sorted[k * sorted.size() / bins]);
  double const centre = std::accumulate(sorted.begin(), sorted.end(), 0.0) / double(sorted.size());
  std::vector<Sums> sums;
  for (auto const& [first, last] : blocks) {
    Sums s(scalars + of_bin * bins, 0.0);
    std::size_t const stride = settings.pair_stride;
    for (std::size_t look = (first + stride - 1) / stride; look * stride < last; ++look)
      for (std::size_t m = 0; m < n; ++m) {
        std::size_t const k = look * stride * n + m;
        double const density = densities[look * n + m], d = density - centre, e = series.U[k] - U_mean,
                     w = W[k] - U_mean;
        s[count] += 1, s[rho] += d, s[rho2] += d * d, s[U] += e, s[U2] += e * e, s[sum_W] += w;
        s[rhoU] += d * e, s[rhoW] += d * w;
        double* const bin =
            &s[scalars + of_bin * std::size_t(std::upper_bound(borders.begin(), borders.end(), density) -
                                              borders.begin())];
        bin[in_bin] += 1, bin[U_in_bin] += e, bin[W_in_bin] += w, bin[rho_in_bin] += d;
      }
    sums.push_back(std::move(s));
  }
  auto const estimates = jackknife(sums, [&](Sums const& s) {
    double const c = s[count], mean_d = s[rho] / c, mean_e = s[U] / c, mean_w = s[sum_W] / c;
    double const var_d = s[rho2] / c - mean_d * mean_d, var_e = s[U2] / c - mean_e * mean_e;
    double const norm = std::sqrt(var_d * var_e);
    std::vector<double> result{(s[rhoU] / c - mean_d * mean_e) / norm, (s[rhoW] / c - mean_d * mean_w) / norm,
                               mean_d + centre, var_d};
    for (std::size_t k = 0; k < bins; ++k) {
      double const* const bin = &s[scalars + of_bin * k];
      double const samples = std::max(1.0, bin[in_bin]);
      result.push_back((bin[U_in_bin] / samples - mean_e) / (U_mean + mean_e));
      result.push_back((bin[W_in_bin] / samples - mean_w) / (U_mean + mean_w));
      result.push_back(bin[rho_in_bin] / samples + centre);
    }
    return result;
  });
  auto next = estimates.begin();
  out.C_UD = *next++, out.configurational.C_UD = *next++;
  out.density_mean = *next++, out.density_variance = *next++;
  for (std::size_t k = 0; k < bins; ++k) {
    out.U_of_density.y.push_back(*next++);
    out.configurational.U_of_density.y.push_back(*next++);
    out.U_of_density.x.push_back((*next++).mean);
  }
  out.configurational.U_of_density.x = out.U_of_density.x;
}

} // namespace mesobridge::cg
