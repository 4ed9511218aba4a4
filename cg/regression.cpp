#include "cg/regression.hpp"
#include "md/error.hpp"
#include <cmath>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_linalg.h>

namespace mesobridge::cg {

void add_sample(Sums& sums, std::vector<double> const& x, double y) {
  std::size_t const m = x.size();
  for (std::size_t a = 0; a < m; ++a) {
    for (std::size_t b = 0; b < m; ++b)
      sums[a * m + b] += x[a] * x[b];
    sums[m * m + a] += x[a] * y;
  }
}

Sums kinetic_sums(EntropyCurve::Basis const& basis, std::span<EnergySamples const> samples, std::size_t block,
                  int atoms) {
  require(atoms >= 3, "atoms of a molecule", atoms, "at least 3 are needed for <1/E_kin> to have an error");
  double const factor = (3 * atoms - 3) / 2.0 - 1;
  std::size_t const m = basis.order;
  Sums sums(m * m + m, 0.0);
  for (auto const& set : samples)
    for (std::size_t i = 0; i < set.U[block].size(); ++i)
      add_sample(sums, basis.slopes(set.U[block][i]), factor / set.U_kin[block][i]);
  return sums;
}

std::vector<double> solve_regression(Sums const& sums, std::size_t order) {
  auto const middle = sums.begin() + std::ptrdiff_t(order * order);
  return solve_symmetric({sums.begin(), middle}, {middle, sums.end()});
}

std::vector<double> solve_symmetric(std::vector<double> const& A, std::vector<double> const& b) {
  auto factors = A;
  auto x = b;
  auto* const quiet = gsl_set_error_handler_off();
  auto matrix = gsl_matrix_view_array(factors.data(), b.size(), b.size());
  auto vector = gsl_vector_view_array(x.data(), b.size());
  int status = gsl_linalg_cholesky_decomp1(&matrix.matrix);
  if (status == GSL_SUCCESS)
    status = gsl_linalg_cholesky_svx(&matrix.matrix, &vector.vector);
  gsl_set_error_handler(quiet);
  if (status != GSL_SUCCESS)
    throw PhysicsError(
        "the samples do not determine the entropy curve (their normal equations are singular): "
        "lower the order, or sample more");
  return x;
}

} // namespace mesobridge::cg
