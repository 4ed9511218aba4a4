#include "cg/pair_force_basis.hpp"
#include <algorithm>
#include <cmath>

namespace mesobridge::cg {
namespace {

std::size_t intervals(double length, double knots) {
  return std::max<std::size_t>(2, std::size_t(std::ceil(length / knots - 1e-6)));
}

} // namespace

PairForceBasis::PairForceBasis(double first, double cutoff, double knots)
    : splines_(first, cutoff, intervals(cutoff - first, knots)),
      interval_((cutoff - first) / double(splines_.size() - 3)) {}

std::vector<double> PairForceBasis::forces(double r) const {
  auto const all = splines_(r);
  std::vector<double> values(all.begin(), all.end() - 1);
  if (r < first())
    for (double& value : values)
      value *= r / first();
  return values;
}

std::vector<double> PairForceBasis::potentials(double r) const {
  std::vector<double> sums(size());
  auto const add = [&](double at, double weight) {
    auto const all = splines_(at);
    for (std::size_t j = 0; j < sums.size(); ++j)
      sums[j] += weight * all[j];
  };
  if (r < first())
    add(first(), (first() * first() - r * r) / (2 * first()));
  double const begin = std::max(r, first()), node = 1 / std::sqrt(3.0); // Gauss: exact for cubics
  for (std::size_t k = 0; k < splines_.size() - 3; ++k) {
    double const a = std::max(begin, first() + double(k) * interval_),
                 b = first() + double(k + 1) * interval_, half = 0.5 * (b - a);
    if (half > 0)
      add(a + half * (1 - node), half), add(a + half * (1 + node), half);
  }
  return sums;
}

} // namespace mesobridge::cg
