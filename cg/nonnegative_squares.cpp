#include "cg/nonnegative_squares.hpp"
#include "cg/regression.hpp"
#include "md/error.hpp"
#include <algorithm>
#include <cmath>
#include <numeric>

namespace mesobridge::cg {
namespace {

/// The solution with only the coefficients of `free`; the others are 0.
std::vector<double> solution_of(std::vector<double> const& A, std::vector<double> const& b,
                                std::vector<std::size_t> const& free) {
  std::size_t const n = b.size();
  std::vector<double> part, right, x(n, 0.0);
  for (std::size_t const i : free) {
    right.push_back(b[i]);
    for (std::size_t const j : free)
      part.push_back(A[i * n + j]);
  }
  auto const found = solve_symmetric(part, right);
  for (std::size_t k = 0; k < free.size(); ++k)
    x[free[k]] = found[k];
  return x;
}

/// From x, where none is negative, towards `goal` until the first is; those that are 0 there are free no
/// more.
void step_towards(std::vector<double>& x, std::vector<double> const& goal, std::vector<std::size_t>& free) {
  double way = 1;
  std::size_t first = free.front();
  for (std::size_t const j : free)
    if (goal[j] <= 0 && x[j] / (x[j] - goal[j]) <= way)
      way = x[j] / (x[j] - goal[j]), first = j;
  for (std::size_t const j : free)
    x[j] += way * (goal[j] - x[j]);
  x[first] = 0;
  std::erase_if(free, [&](std::size_t j) { return x[j] <= 0; });
  for (double& value : x)
    value = std::max(value, 0.0); // round-off
}

} // namespace

std::vector<double> nonnegative_squares(std::vector<double> const& A, std::vector<double> const& b) {
  std::size_t const n = b.size();
  std::vector<double> x(n, 0.0);
  std::vector<std::size_t> free;
  double const tolerance =
      1e-14 * std::transform_reduce(
                  b.begin(), b.end(), 0.0, [](double p, double q) { return std::max(p, q); },
                  [](double value) { return std::abs(value); });
  for (std::size_t round = 0; round < 30 * n; ++round) {
    std::size_t best = n;
    double gain = tolerance;
    for (std::size_t i = 0; i < n; ++i) {
      double const slope =
          b[i] - std::inner_product(x.begin(), x.end(), A.begin() + std::ptrdiff_t(i * n), 0.0);
      if (std::ranges::find(free, i) == free.end() && slope > gain)
        best = i, gain = slope;
    }
    if (best == n)
      return x;
    free.push_back(best);
    for (;;) {
      auto const goal = solution_of(A, b, free);
      if (std::ranges::all_of(free, [&](std::size_t j) { return goal[j] > 0; })) {
        x = goal;
        break;
      }
      step_towards(x, goal, free);
      if (free.empty())
        break;
    }
  }
  throw PhysicsError("least squares of coefficients >= 0 found no end");
}

std::vector<double> nonnegative_squares(std::vector<double> const& A, std::vector<double> const& b,
                                        std::vector<double> const& c, double d) {
  constexpr double weight = 1e6; // of the condition, which a common factor then makes exact
  std::size_t const n = b.size();
  double of_A = 0, of_c = 0;
  for (std::size_t i = 0; i < n; ++i)
    of_A += A[i * n + i], of_c += c[i] * c[i];
  double const w = weight * of_A / of_c;
  auto with_A = A;
  auto with_b = b;
  for (std::size_t i = 0; i < n; ++i) {
    with_b[i] += w * d * c[i];
    for (std::size_t j = 0; j < n; ++j)
      with_A[i * n + j] += w * c[i] * c[j];
  }
  auto x = nonnegative_squares(with_A, with_b);
  double const sum = std::inner_product(x.begin(), x.end(), c.begin(), 0.0);
  for (double& value : x)
    value *= d / sum;
  return x;
}

} // namespace mesobridge::cg
