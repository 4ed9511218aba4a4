#include "cg/force_matching.hpp"
#include "cg/blob_series.hpp"
#include "cg/jackknife.hpp"
#include "cg/pair_force_basis.hpp"
#include "md/error.hpp"
#include <algorithm>
#include <cmath>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_linalg.h>
#include <numbers>
#include <numeric>

namespace mesobridge::cg {
namespace {

constexpr std::size_t least_blocks = 4, most_blocks = 16;
constexpr double most_coefficients = 500;
constexpr double least_condition = 1e-10; // of the normal equations, scaled; reciprocal

using Blocks = std::vector<std::pair<std::size_t, std::size_t>>;

/// visit(a, b, R_a - R_b, distance) for all pairs of an instant nearer than the cut-off.
template <class Visit>
void for_each_pair(MoleculeForces const& forces, std::size_t instant, double cutoff, Visit const& visit) {
  std::size_t const n = forces.molecules;
  Vec3 const* const R = forces.R.data() + instant * n;
  Box const& box = forces.boxes[instant];
  for (std::size_t a = 0; a < n; ++a)
    for (std::size_t b = a + 1; b < n; ++b) {
      Vec3 const apart = box.minimum_image(R[a] - R[b]);
      if (double const r2 = norm2(apart); r2 < cutoff * cutoff && r2 > 0)
        visit(a, b, apart, std::sqrt(r2));
    }
}

std::size_t bins_within(ForceMatchingSettings const& settings) {
  return std::size_t(std::lround(settings.cutoff / settings.width));
}

void check(MoleculeForces const& forces, ForceMatchingSettings const& settings) {
  require(settings.width > 0, "bin width", settings.width, "must be > 0");
  require(settings.knots > 0, "knots", settings.knots, "must be > 0");
  require(forces.instants() >= least_blocks, "frames", forces.instants(),
          fmt::format("at least {} are needed for a standard error", least_blocks));
  double half = settings.cutoff;
  for (auto const& box : forces.boxes)
    half = std::min(half, 0.5 * box.narrowest());
  require(settings.cutoff > 0 && settings.cutoff <= half * (1 + 1e-9), "cutoff", settings.cutoff,
          fmt::format("must be above 0, and within half of the box's narrowest width, {:g}", half));
  require(bins_within(settings) >= 8, "bins within the cut-off", bins_within(settings),
          "at least 8 are needed");
  require(std::ranges::any_of(forces.F, [](Vec3 const& F) { return norm2(F) > 0; }), "forces on molecules", 0,
          "must be there: all in the file are zero");
}

/// Pairs in each bin, of each block.
std::vector<Sums> count_pairs(MoleculeForces const& forces, Blocks const& blocks, double width,
                              std::size_t bins) {
  std::vector<Sums> counts;
  for (auto const& [first, last] : blocks) {
    Sums count(bins);
    for (std::size_t k = first; k < last; ++k)
      for_each_pair(forces, k, width * double(bins), [&](std::size_t, std::size_t, Vec3 const&, double r) {
        count[std::min(bins - 1, std::size_t(r / width))] += 1;
      });
    counts.push_back(std::move(count));
  }
  return counts;
}

/// The edge from which on, up to the cut-off, every bin has pairs enough.
double first_distance(MoleculeForces const& forces, std::vector<Sums> const& counts,
                      ForceMatchingSettings const& settings) {
  double ideal = 0; // pairs per volume about a molecule, if they stood anywhere
  for (auto const& box : forces.boxes)
    ideal += 0.5 * double(forces.molecules) * double(forces.molecules - 1) / box.volume();
  std::size_t const bins = counts[0].size();
  std::size_t first = bins;
  for (; first > 0; --first) {
    std::size_t const bin = first - 1;
    double pairs = 0, blocks = 0;
    for (auto const& count : counts)
      pairs += count[bin], blocks += count[bin] > 0;
    double const r = (double(bin) + 0.5) * settings.width,
                 volume = 4 * std::numbers::pi * r * r * settings.width;
    if (pairs <= settings.least_g * ideal * volume || 2 * blocks < double(counts.size()))
      break;
  }
  require(bins - first >= 8, "bins within the cut-off that hold pairs", bins - first,
          "at least 8 are needed");
  return double(first) * settings.width;
}

/// Where the sums of a block stand: the normal equations A a = b of Eq. (C47), then the square of all forces
/// and the number of their components, pairs of each bin, and the forces along their lines.
struct Layout {
  std::size_t n, bins;
  std::size_t b() const { return n * n; }
  std::size_t square() const { return n * n + n; }
  std::size_t pairs() const { return square() + 2; }
  std::size_t along() const { return pairs() + bins; }
  std::size_t size() const { return along() + bins; }
};

/// Adds one instant.
class Gatherer {
 public:
  Gatherer(MoleculeForces const& forces, PairForceBasis const& basis, Layout const& layout, double width)
      : forces_(forces), basis_(basis), layout_(layout), width_(width), design_(layout.n * forces.molecules) {
  }

  void add(Sums& sums, std::size_t instant) {
    std::fill(design_.begin(), design_.end(), Vec3{});
    Vec3 const* const F = forces_.F.data() + instant * forces_.molecules;
    for_each_pair(
        forces_, instant, basis_.cutoff(), [&](std::size_t a, std::size_t b, Vec3 const& apart, double r) {
          Vec3 const e = apart / r;
          auto const values = basis_.forces(r);
          for (std::size_t j = 0; j < layout_.n; ++j)
            design_[a * layout_.n + j] += values[j] * e, design_[b * layout_.n + j] -= values[j] * e;
          std::size_t const bin = std::min(layout_.bins - 1, std::size_t(r / width_));
          sums[layout_.pairs() + bin] += 1;
          sums[layout_.along() + bin] += 0.5 * dot(F[a] - F[b], e);
        });
    for (std::size_t m = 0; m < forces_.molecules; ++m)
      add_equations(sums, design_.data() + m * layout_.n, F[m]);
  }

 private:
  void add_equations(Sums& sums, Vec3 const* row, Vec3 const& F) const {
    std::size_t const n = layout_.n;
    for (std::size_t j = 0; j < n; ++j) {
      if (norm2(row[j]) == 0)
        continue;
      for (std::size_t k = 0; k < n; ++k)
        sums[j * n + k] += dot(row[j], row[k]);
      sums[layout_.b() + j] += dot(row[j], F);
    }
    sums[layout_.square()] += norm2(F), sums[layout_.square() + 1] += 3;
  }

  MoleculeForces const& forces_;
  PairForceBasis const& basis_;
  Layout layout_;
  double width_;
  std::vector<Vec3> design_; ///< of each molecule, its unit vectors to others times each function
};

/// Refuses knots that are too close for what the pairs tell.
void require_told(bool told, double knots, double coefficients) {
  require(told, "knots", knots,
          fmt::format("are too close: the pairs do not tell the {:.0f} coefficients of the force; "
                      "take fewer knots, or more frames",
                      coefficients));
}

/// Before any work: fewer pairs than coefficients, or more of these than any force needs.
void check_knots(double first, std::vector<Sums> const& counts, ForceMatchingSettings const& settings) {
  double pairs = 0;
  for (auto const& count : counts)
    pairs += std::accumulate(count.begin(), count.end(), 0.0);
  double const coefficients = (settings.cutoff - first) / settings.knots + 2;
  require_told(coefficients <= std::min(pairs, most_coefficients), settings.knots, coefficients);
}

/// Solves the normal equations.
std::vector<double> coefficients(Sums const& sums, Layout const& layout, double knots) {
  std::vector<double> A(sums.begin(), sums.begin() + std::ptrdiff_t(layout.b())),
      a(sums.begin() + std::ptrdiff_t(layout.b()), sums.begin() + std::ptrdiff_t(layout.square())),
      scale(layout.n), work(3 * layout.n);
  auto matrix = gsl_matrix_view_array(A.data(), layout.n, layout.n);
  auto solution = gsl_vector_view_array(a.data(), layout.n),
       scales = gsl_vector_view_array(scale.data(), layout.n),
       space = gsl_vector_view_array(work.data(), work.size());
  auto* const quiet = gsl_set_error_handler_off();
  double condition = 0;
  int status = gsl_linalg_cholesky_decomp2(&matrix.matrix, &scales.vector);
  if (status == GSL_SUCCESS)
    status = gsl_linalg_cholesky_rcond(&matrix.matrix, &condition, &space.vector);
  if (status == GSL_SUCCESS)
    status = gsl_linalg_cholesky_svx2(&matrix.matrix, &scales.vector, &solution.vector);
  gsl_set_error_handler(quiet);
  require_told(status == GSL_SUCCESS && condition > least_condition, knots, double(layout.n));
  return a;
}

/// All numbers of the result in a row: f, u and the mean force of each bin, their square and what is
/// explained.
class Statistics {
 public:
  Statistics(PairForceBasis const& basis, Layout const& layout, double width, double knots)
      : layout_(layout), knots_(knots) {
    for (std::size_t bin = 0; bin < layout.bins; ++bin) {
      double const r = (double(bin) + 0.5) * width;
      rows_.push_back(basis.forces(r));
    }
    for (std::size_t bin = 0; bin < layout.bins; ++bin)
      rows_.push_back(basis.potentials((double(bin) + 0.5) * width));
  }

  std::vector<double> operator()(Sums const& sums) const {
    auto const a = coefficients(sums, layout_, knots_);
    std::vector<double> result;
    for (auto const& row : rows_)
      result.push_back(std::inner_product(row.begin(), row.end(), a.begin(), 0.0));
    for (std::size_t bin = 0; bin < layout_.bins; ++bin) {
      double const pairs = sums[layout_.pairs() + bin];
      result.push_back(pairs > 0 ? sums[layout_.along() + bin] / pairs : 0);
    }
    double const explained =
        std::inner_product(a.begin(), a.end(), sums.begin() + std::ptrdiff_t(layout_.b()), 0.0);
    double const square = sums[layout_.square()];
    result.push_back(square / sums[layout_.square() + 1]), result.push_back(explained / square);
    return result;
  }

 private:
  Layout layout_;
  double knots_;
  std::vector<std::vector<double>> rows_; ///< of each bin, the basis's forces, then its potentials
};

/// The sums of neighbouring blocks together.
std::vector<Sums> joined(std::vector<Sums> const& blocks) {
  std::vector<Sums> pairs;
  for (std::size_t k = 0; k + 1 < blocks.size(); k += 2) {
    pairs.push_back(blocks[k]);
    std::transform(pairs.back().begin(), pairs.back().end(), blocks[k + 1].begin(), pairs.back().begin(),
                   std::plus{});
  }
  return pairs;
}

/// How much larger errors become with longer blocks: root mean square over the potential's bins.
double growth(std::vector<Estimate> const& before, std::vector<Estimate> const& after) {
  double sum = 0, count = 0;
  for (std::size_t k = 0; k < before.size(); ++k)
    if (before[k].se > 0)
      sum += std::pow(after[k].se / before[k].se, 2), count += 1;
  return count > 0 ? std::sqrt(sum / count) : 1;
}

} // namespace

PairPotential MatchedForce::potential() const {
  PairPotential result{width, {}};
  for (auto const& value : u)
    result.u.push_back(value.mean);
  return result;
}

MatchedForce match_forces(MoleculeForces const& forces, ForceMatchingSettings const& settings,
                          std::function<void(double)> const& done) {
  check(forces, settings);
  std::size_t const bins = bins_within(settings);
  auto const blocks = time_blocks(forces.instants(), std::min(most_blocks, forces.instants()));
  auto const counts = count_pairs(forces, blocks, settings.width, bins);
  double const first = first_distance(forces, counts, settings);
  check_knots(first, counts, settings);
  PairForceBasis const basis(first, double(bins) * settings.width, settings.knots);
  Layout const layout{basis.size(), bins};
  Gatherer gatherer(forces, basis, layout, settings.width);
  std::vector<Sums> sums;
  for (auto const& [first, last] : blocks) {
    sums.emplace_back(layout.size(), 0.0);
    for (std::size_t k = first; k < last; ++k)
      gatherer.add(sums.back(), k);
    if (done)
      done(double(last) / double(forces.instants()));
  }
  Statistics const statistics(basis, layout, settings.width, settings.knots);
  auto const row = jackknife(sums, statistics);
  auto const part = [&](std::size_t from) {
    return std::vector(row.begin() + std::ptrdiff_t(from), row.begin() + std::ptrdiff_t(from + bins));
  };
  MatchedForce found{.width = settings.width, .cutoff = basis.cutoff(), .first = basis.first()};
  found.unknowns = layout.n, found.blocks = blocks.size();
  found.f = part(0), found.u = part(bins), found.mean_force = part(2 * bins), found.explained = row.back();
  found.mean_square = row[3 * bins];
  auto const whole = without_each(sums).back();
  found.pairs.assign(whole.begin() + std::ptrdiff_t(layout.pairs()),
                     whole.begin() + std::ptrdiff_t(layout.along()));
  if (!forces.independent && sums.size() >= 2 * least_blocks)
    found.longer_blocks = growth(row, jackknife(joined(sums), statistics));
  return found;
}

} // namespace mesobridge::cg
