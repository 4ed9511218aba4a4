#include "cg/pair_statistics.hpp"
#include "cg/density_statistics.hpp"
#include "md/error.hpp"
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
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

/// What is summed of each radial bin: pairs and products of energies.
enum Radial : std::size_t { pairs, UU, WW, radial };

double mean_of(std::vector<double> const& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / double(values.size());
}

double shell(double inner, double outer) {
  return 4 * std::numbers::pi / 3 * (outer * outer * outer - inner * inner * inner);
}

} // namespace

PairStatistics::PairStatistics(BlobSeries const& series, CorrelationSettings const& settings)
    : series_(series), settings_(settings) {
  require(settings.pair_stride > 0, "frames between those whose pairs are looked at", settings.pair_stride,
          "must be > 0");
  require(settings.bin_width > 0, "bin width of g(r)", settings.bin_width, "must be > 0");
  double half_edge = std::numeric_limits<double>::infinity();
  for (auto const& box : series.boxes)
    half_edge = std::min(half_edge, box.narrowest() / 2);
  require(settings.h > 0 && settings.h <= half_edge, "range h of the density", settings.h,
          fmt::format("must be in (0, {:.4g}], half the box", half_edge));
  r_max_ = std::floor(std::min(farthest, half_edge) / settings.bin_width) * settings.bin_width;
  volume_ = series.boxes.front().volume();
  U_mean_ = mean_of(series.U);
  double const kinetic = mean_of(series.U_kin);
  for (std::size_t k = 0; k < series.U.size(); ++k)
    W_.push_back(series.U[k] - series.U_kin[k] + kinetic);
  for (std::size_t frame = 0; frame < series.frames(); frame += settings.pair_stride)
    look_at(frame);
}

std::size_t PairStatistics::radial_bins() const {
  return std::size_t(std::lround(r_max_ / settings_.bin_width));
}

void PairStatistics::look_at(std::size_t frame) {
  std::size_t const n = series_.molecules, first = frame * n;
  Box const& box = series_.boxes[frame];
  double const reach = std::max(r_max_, settings_.h), per_bin = 1 / settings_.bin_width;
  double const per_U2 = 1 / (U_mean_ * U_mean_);
  std::vector<double> sums(radial * radial_bins(), 0.0), density(n, 0.0);
  for (std::size_t a = first; a < first + n; ++a)
    for (std::size_t b = a + 1; b < first + n; ++b) {
      double const r2 = norm2(box.minimum_image(series_.R[a] - series_.R[b]));
      if (r2 >= reach * reach)
        continue;
      double const r = std::sqrt(r2);
      double const w = series_.mass * lucy(r, settings_.h);
      density[a - first] += w, density[b - first] += w;
      if (r >= r_max_)
        continue;
      double* const bin = &sums[radial * std::min(radial_bins() - 1, std::size_t(r * per_bin))];
      bin[pairs] += 1;
      bin[UU] += series_.U[a] * series_.U[b] * per_U2;
      bin[WW] += W_[a] * W_[b] * per_U2;
    }
  frames_.push_back(std::move(sums));
  densities_.insert(densities_.end(), density.begin(), density.end());
}

std::vector<std::size_t> PairStatistics::joined_bins() const {
  std::vector<std::size_t> ends;
  double seen = 0;
  for (std::size_t bin = 0; bin < radial_bins(); ++bin) {
    for (auto const& frame : frames_)
      seen += frame[radial * bin + pairs];
    if (seen >= fewest_pairs) {
      ends.push_back(bin + 1);
      seen = 0;
    }
  }
  return ends;
}

std::size_t PairStatistics::bins_in_contact(std::vector<Sums> const& sums,
                                            std::vector<std::size_t> const& ends,
                                            std::vector<double> const& ideal) const {
  Sums whole(sums[0].size(), 0.0);
  for (auto const& block : sums)
    std::transform(whole.begin(), whole.end(), block.begin(), whole.begin(), std::plus{});
  double const frames = whole[radial * radial_bins()];
  std::size_t joined = 0;
  for (std::size_t bin = 0; joined < ends.size(); ++joined) {
    double seen = 0;
    for (; bin < ends[joined]; ++bin)
      seen += whole[radial * bin + pairs];
    if (seen / (frames * ideal[joined]) >= contact_g)
      break;
  }
  return std::max<std::size_t>(1, joined);
}

void PairStatistics::radial_into(std::vector<Sums> const& sums, Correlations& out) const {
  auto const ends = joined_bins();
  if (ends.empty())
    throw PhysicsError("too few pairs of molecules were seen to measure g(r): sample longer");
  double const n = double(series_.molecules);
  std::vector<double> ideal; // pairs of an ideal gas in each bin and frame
  for (std::size_t k = 0, begin = 0; k < ends.size(); begin = ends[k++]) {
    double const inner = double(begin) * settings_.bin_width, outer = double(ends[k]) * settings_.bin_width;
    ideal.push_back(n * (n - 1) / 2 * shell(inner, outer) / volume_);
    for (Profile* profile : {&out.g, &out.u, &out.u_minus_g, &out.pair_energy, &out.configurational.u_minus_g,
                             &out.configurational.pair_energy})
      profile->x.push_back((inner + outer) / 2);
  }
  std::size_t const in_contact = bins_in_contact(sums, ends, ideal);
  auto const estimates = jackknife(sums, [&](Sums const& s) {
    // <U> and <W> of the same samples, so that its error cancels between the pairs' energies and the norm.
    double const* const totals = &s[radial * radial_bins()];
    double const frames = totals[0], U2 = std::pow(totals[1] / (frames * n), 2),
                 W2 = std::pow(totals[2] / (frames * n), 2);
    std::vector<double> result;
    std::array<double, radial> contact{};
    for (std::size_t k = 0, bin = 0; k < ends.size(); ++k) {
      std::array<double, radial> joined{};
      for (; bin < ends[k]; ++bin)
        for (std::size_t what = 0; what < radial; ++what)
          joined[what] += s[radial * bin + what];
      double const g = joined[pairs] / (frames * ideal[k]), u = joined[UU] / (frames * ideal[k] * U2),
                   w = joined[WW] / (frames * ideal[k] * W2);
      result.insert(result.end(), {g, u, u - g, g > 0 ? u / g : 1, w - g, g > 0 ? w / g : 1});
      for (std::size_t what = 0; what < radial && k < in_contact; ++what)
        contact[what] += joined[what];
    }
    result.push_back(contact[pairs] > 0 ? contact[UU] / (contact[pairs] * U2) : 1);
    result.push_back(contact[pairs] > 0 ? contact[WW] / (contact[pairs] * W2) : 1);
    return result;
  });
  auto next = estimates.begin();
  for (std::size_t k = 0; k < ends.size(); ++k)
    for (Profile* profile : {&out.g, &out.u, &out.u_minus_g, &out.pair_energy, &out.configurational.u_minus_g,
                             &out.configurational.pair_energy})
      profile->y.push_back(*next++);
  out.contact_energy = *next++;
  out.configurational.contact_energy = *next;
  out.contact = double(ends[in_contact - 1]) * settings_.bin_width;
}

void PairStatistics::results_into(std::vector<std::pair<std::size_t, std::size_t>> const& blocks,
                                  Correlations& out) const {
  std::vector<Sums> rings;
  for (auto const& [first, last] : blocks) {
    Sums sums(radial * radial_bins() + 3, 0.0); // then the frames and the sums of U/<U> and W/<U>
    double* const totals = &sums[radial * radial_bins()];
    std::size_t const stride = settings_.pair_stride, n = series_.molecules;
    for (std::size_t look = (first + stride - 1) / stride; look * stride < last; ++look) {
      std::transform(frames_[look].begin(), frames_[look].end(), sums.begin(), sums.begin(), std::plus{});
      totals[0] += 1;
      for (std::size_t k = look * stride * n; k < (look * stride + 1) * n; ++k)
        totals[1] += series_.U[k] / U_mean_, totals[2] += W_[k] / U_mean_;
    }
    rings.push_back(std::move(sums));
  }
  radial_into(rings, out);
  density_results_into(series_, W_, densities_, settings_, blocks, out);
}

} // namespace mesobridge::cg
