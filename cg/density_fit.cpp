#include "cg/density_fit.hpp"
#include "cg/regression.hpp"
#include "md/error.hpp"
#include <algorithm>
#include <cmath>
#include <gsl/gsl_integration.h>

namespace mesobridge::cg {
namespace {

constexpr std::size_t quadrature_points = 200;
constexpr int most_iterations = 100;

} // namespace

DensityFit::DensityFit(EntropyCurve::Basis const& basis, double U_low, double U_high) : basis_(basis) {
  auto* const table = gsl_integration_glfixed_table_alloc(quadrature_points);
  for (std::size_t k = 0; k < quadrature_points; ++k) {
    double U = 0, weight = 0;
    gsl_integration_glfixed_point(U_low, U_high, k, &U, &weight, table);
    U_.push_back(U), weight_.push_back(weight);
    functions_.push_back(basis.functions(U));
  }
  gsl_integration_glfixed_table_free(table);
}

Sums DensityFit::sums(std::span<EnergySamples const> samples, std::size_t block) const {
  Sums result;
  for (auto const& set : samples) {
    std::vector<double> of_set(basis_.order + 1, 0.0);
    of_set[0] = double(set.U[block].size());
    for (double U : set.U[block]) {
      auto const f = basis_.functions(U);
      for (std::size_t j = 0; j < basis_.order; ++j)
        of_set[j + 1] += f[j];
    }
    result.insert(result.end(), of_set.begin(), of_set.end());
  }
  return result;
}

DensityFit::Slope DensityFit::likelihood(Sums const& sums, std::vector<double> const& betas,
                                         std::vector<double> const& theta) const {
  std::size_t const m = basis_.order;
  Slope slope{
      .value = 0, .gradient = std::vector<double>(m, 0.0), .hessian = std::vector<double>(m * m, 0.0)};
  double all = 0;
  for (std::size_t k = 0; k < betas.size(); ++k)
    all += sums[k * (m + 1)];
  std::vector<double> exponent(U_.size()), S(U_.size(), 0.0);
  for (std::size_t i = 0; i < U_.size(); ++i)
    for (std::size_t j = 0; j < m; ++j)
      S[i] += theta[j] * functions_[i][j];
  for (std::size_t k = 0; k < betas.size(); ++k) {
    double const* const data = &sums[k * (m + 1)];
    for (std::size_t i = 0; i < U_.size(); ++i)
      exponent[i] = S[i] - betas[k] * U_[i];
    double const top = *std::max_element(exponent.begin(), exponent.end());
    double Z = 0;
    std::vector<double> mean(m, 0.0), square(m * m, 0.0);
    for (std::size_t i = 0; i < U_.size(); ++i) {
      double const p = weight_[i] * std::exp(exponent[i] - top);
      auto const& f = functions_[i];
      Z += p;
      for (std::size_t a = 0; a < m; ++a) {
        mean[a] += p * f[a];
        for (std::size_t b = 0; b < m; ++b)
          square[a * m + b] += p * f[a] * f[b];
      }
    }
    double const n = data[0] / all;
    slope.value -= n * (std::log(Z) + top);
    for (std::size_t a = 0; a < m; ++a) {
      slope.value += theta[a] * data[a + 1] / all;
      slope.gradient[a] += data[a + 1] / all - n * mean[a] / Z;
      for (std::size_t b = 0; b < m; ++b)
        slope.hessian[a * m + b] += n * (square[a * m + b] / Z - mean[a] * mean[b] / Z / Z);
    }
  }
  return slope;
}

std::vector<double> DensityFit::solve(Sums const& sums, std::vector<double> const& betas,
                                      std::vector<double> start) const {
  std::size_t const m = basis_.order;
  if (start.empty()) { // a molecule of constant heat capacity, at the middle of its temperatures
    start.assign(m, 0.0);
    double beta = 0;
    for (double b : betas)
      beta += b / double(betas.size());
    start[0] = beta * (basis_.U_ref - basis_.U_0) * basis_.width;
  }
  auto theta = std::move(start);
  auto slope = likelihood(sums, betas, theta);
  for (int iteration = 0; iteration < most_iterations; ++iteration) {
    auto const step = solve_symmetric(slope.hessian, slope.gradient);
    double gain = 0;
    for (std::size_t j = 0; j < m; ++j)
      gain += step[j] * slope.gradient[j];
    if (gain < 1e-20)
      return theta;
    bool accepted = false;
    for (double length = 1; length > 1e-6 && !accepted; length /= 2) {
      auto next = theta;
      for (std::size_t j = 0; j < m; ++j)
        next[j] += length * step[j];
      auto const at_next = likelihood(sums, betas, next);
      if (at_next.value >= slope.value + 1e-4 * length * gain - 1e-14) {
        theta = std::move(next);
        slope = at_next;
        accepted = true;
      }
    }
    if (!accepted)
      return theta; // round-off: no step can be told from standing still
  }
  throw PhysicsError(
      fmt::format("the fit of S(U) of order {} did not converge in {} iterations", m, most_iterations));
}

} // namespace mesobridge::cg
