#include "cg/pair_statistics.hpp"
#include "cg/jackknife.hpp"
#include "md/error.hpp"
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace mesobridge::cg {
namespace {

/// g(r) is followed to this distance, where the box allows it.
constexpr double farthest = 12;
/// The innermost bin is widened until it holds this many pairs.
constexpr double fewest_pairs = 400;
/// Pairs nearer than where g(r) first reaches this are in contact.
constexpr double contact_g = 0.5;

double shell(double inner, double outer) {
  return 4 * std::numbers::pi / 3 * (outer * outer * outer - inner * inner * inner);
}

} // namespace

PairStatistics::PairStatistics(BlobSeries const& series, CorrelationSettings const& settings)
    : series_(series), settings_(settings) {
  require(settings.pair_stride > 0, "frames between those whose pairs are looked at", settings.pair_stride,
          "must be > 0");
  require(settings.bin_width > 0, "bin width of g(r)", settings.bin_width, "must be > 0");
  double half_edge = farthest;
  for (auto const& box : series.boxes)
    half_edge = std::min({half_edge, box.edge.x / 2, box.edge.y / 2, box.edge.z / 2});
  require(settings.h > 0 && settings.h <= half_edge, "range h of the density", settings.h,
          fmt::format("must be in (0, {:.4g}], half the box", half_edge));
  r_max_ = std::floor(half_edge / settings.bin_width) * settings.bin_width;
  volume_ = series.boxes.front().volume();
  U_mean_ = std::accumulate(series.U.begin(), series.U.end(), 0.0) / double(series.U.size());
  for (std::size_t frame = 0; frame < series.frames(); frame += settings.pair_stride)
    look_at(frame);
}

std::size_t PairStatistics::radial_bins() const {
  return std::size_t(std::lround(r_max_ / settings_.bin_width));
}

void PairStatistics::look_at(std::size_t frame) {
  std::size_t const n = series_.molecules, first = frame * n;
  Box const& box = series_.boxes[frame];
  double const r2_max = r_max_ * r_max_, per_bin = 1 / settings_.bin_width;
  std::vector<double> sums(2 * radial_bins(), 0.0), density(n, 0.0);
  for (std::size_t a = 0; a < n; ++a)
    for (std::size_t b = a + 1; b < n; ++b) {
      double const r2 = norm2(box.minimum_image(series_.R[first + a] - series_.R[first + b]));
      if (r2 >= r2_max)
        continue;
      double const r = std::sqrt(r2);
      auto const bin = std::min(radial_bins() - 1, std::size_t(r * per_bin));
      sums[2 * bin] += 1;
      sums[2 * bin + 1] += series_.U[first + a] * series_.U[first + b] / (U_mean_ * U_mean_);
      double const w = series_.mass * lucy(r, settings_.h);
      density[a] += w, density[b] += w;
    }
  frames_.push_back(std::move(sums));
  densities_.insert(densities_.end(), density.begin(), density.end());
}

std::vector<std::size_t> PairStatistics::joined_bins() const {
  std::vector<std::size_t> ends;
  double pairs = 0;
  for (std::size_t bin = 0; bin < radial_bins(); ++bin) {
    for (auto const& frame : frames_)
      pairs += frame[2 * bin];
    if (pairs >= fewest_pairs) {
      ends.push_back(bin + 1);
      pairs = 0;
    }
  }
  return ends;
}

void PairStatistics::radial_into(std::vector<std::vector<double>> const& sums, Correlations& out) const {
  auto const ends = joined_bins();
  if (ends.empty())
    throw PhysicsError("too few pairs of molecules were seen to measure g(r): sample longer");
  double const n = double(series_.molecules);
  std::vector<double> ideal; // pairs of an ideal gas in each bin and frame
  for (std::size_t k = 0, begin = 0; k < ends.size(); begin = ends[k++]) {
    double const inner = double(begin) * settings_.bin_width, outer = double(ends[k]) * settings_.bin_width;
    ideal.push_back(n * (n - 1) / 2 * shell(inner, outer) / volume_);
    for (Profile* profile : {&out.g, &out.u, &out.u_minus_g, &out.pair_energy})
      profile->x.push_back((inner + outer) / 2);
  }
  Sums whole(sums[0].size(), 0.0);
  for (auto const& block : sums)
    std::transform(whole.begin(), whole.end(), block.begin(), whole.begin(), std::plus{});
  std::size_t in_contact = 0; // joined bins
  for (std::size_t bin = 0; in_contact < ends.size(); ++in_contact) {
    double pairs = 0;
    for (; bin < ends[in_contact]; ++bin)
      pairs += whole[2 * bin];
    if (pairs / (whole[whole.size() - 2] * ideal[in_contact]) >= contact_g)
      break;
  }
  in_contact = std::max<std::size_t>(1, in_contact);
  auto const estimates = jackknife(sums, [&](Sums const& s) {
    // <U> of the same samples, so that its error cancels between the pairs' energies and the norm.
    double const frames = s[s.size() - 2], scale = std::pow(s.back() / (frames * n), 2);
    std::vector<double> result;
    double near_pairs = 0, near_energies = 0;
    for (std::size_t k = 0, bin = 0; k < ends.size(); ++k) {
      double pairs = 0, energies = 0;
      for (; bin < ends[k]; ++bin)
        pairs += s[2 * bin], energies += s[2 * bin + 1] / scale;
      double const g = pairs / (frames * ideal[k]), u = energies / (frames * ideal[k]);
      result.insert(result.end(), {g, u, u - g, pairs > 0 ? energies / pairs : 1});
      if (k < in_contact)
        near_pairs += pairs, near_energies += energies;
    }
    result.push_back(near_pairs > 0 ? near_energies / near_pairs : 1);
    return result;
  });
  for (std::size_t k = 0; k < ends.size(); ++k) {
    out.g.y.push_back(estimates[4 * k]);
    out.u.y.push_back(estimates[4 * k + 1]);
    out.u_minus_g.y.push_back(estimates[4 * k + 2]);
    out.pair_energy.y.push_back(estimates[4 * k + 3]);
  }
  out.contact_energy = estimates.back();
  out.contact = double(ends[in_contact - 1]) * settings_.bin_width;
}

void PairStatistics::density_into(std::vector<std::pair<std::size_t, std::size_t>> const& blocks,
                                  Correlations& out) const {
  std::size_t const n = series_.molecules, bins = settings_.density_bins;
  auto sorted = densities_;
  std::sort(sorted.begin(), sorted.end());
  std::vector<double> borders; // bins of equally many samples
  for (std::size_t k = 1; k < bins; ++k)
    borders.push_back(sorted[k * sorted.size() / bins]);
  double const centre = std::accumulate(sorted.begin(), sorted.end(), 0.0) / double(sorted.size());
  enum : std::size_t { count, rho, rho2, U, U2, rhoU, scalars };
  std::vector<Sums> sums;
  for (auto const& [first, last] : blocks) {
    Sums s(scalars + 3 * bins, 0.0);
    std::size_t const stride = settings_.pair_stride;
    for (std::size_t look = (first + stride - 1) / stride; look * stride < last; ++look)
      for (std::size_t m = 0; m < n; ++m) {
        double const density = densities_[look * n + m], d = density - centre,
                     e = series_.U[look * stride * n + m] - U_mean_;
        s[count] += 1, s[rho] += d, s[rho2] += d * d, s[U] += e, s[U2] += e * e, s[rhoU] += d * e;
        auto const bin =
            std::size_t(std::upper_bound(borders.begin(), borders.end(), density) - borders.begin());
        s[scalars + 3 * bin] += 1, s[scalars + 3 * bin + 1] += e, s[scalars + 3 * bin + 2] += d;
      }
    sums.push_back(std::move(s));
  }
  auto const estimates = jackknife(sums, [&](Sums const& s) {
    double const c = s[count], mean_d = s[rho] / c, mean_e = s[U] / c;
    double const var_d = s[rho2] / c - mean_d * mean_d, var_e = s[U2] / c - mean_e * mean_e;
    std::vector<double> result{(s[rhoU] / c - mean_d * mean_e) / std::sqrt(var_d * var_e), mean_d + centre,
                               var_d};
    for (std::size_t bin = 0; bin < bins; ++bin) {
      double const in_bin = std::max(1.0, s[scalars + 3 * bin]);
      result.push_back((s[scalars + 3 * bin + 1] / in_bin - mean_e) / (U_mean_ + mean_e));
      result.push_back(s[scalars + 3 * bin + 2] / in_bin + centre);
    }
    return result;
  });
  out.C_UD = estimates[0], out.density_mean = estimates[1], out.density_variance = estimates[2];
  for (std::size_t bin = 0; bin < bins; ++bin) {
    out.U_of_density.y.push_back(estimates[3 + 2 * bin]);
    out.U_of_density.x.push_back(estimates[4 + 2 * bin].mean);
  }
}

void PairStatistics::results_into(std::vector<std::pair<std::size_t, std::size_t>> const& blocks,
                                  Correlations& out) const {
  std::vector<Sums> radial;
  for (auto const& [first, last] : blocks) {
    Sums sums(2 * radial_bins() + 2, 0.0); // then the frames and the sum of U/<U>
    std::size_t const stride = settings_.pair_stride;
    for (std::size_t look = (first + stride - 1) / stride; look * stride < last; ++look) {
      std::transform(frames_[look].begin(), frames_[look].end(), sums.begin(), sums.begin(), std::plus{});
      sums[2 * radial_bins()] += 1;
      for (std::size_t m = 0; m < series_.molecules; ++m)
        sums.back() += series_.U[look * stride * series_.molecules + m] / U_mean_;
    }
    radial.push_back(std::move(sums));
  }
  radial_into(radial, out);
  density_into(blocks, out);
}

} // namespace mesobridge::cg
