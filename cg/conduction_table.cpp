#include "cg/energy_exchange.hpp"
#include "cg/nonnegative_squares.hpp"
#include "md/error.hpp"
#include <algorithm>
#include <array>
#include <cmath>

namespace mesobridge::cg {
namespace {

/// (1 - r/r_c)^n of these: sums of them with coefficients >= 0 fall from any core to zero at r_c.
constexpr std::array powers{2.0, 3.0, 4.0, 6.0, 9.0, 13.0, 20.0};
constexpr std::size_t points = 60;

} // namespace

ConductionTable conduction_table(std::vector<double> const& r, std::vector<Estimate> const& kappa,
                                 double cutoff) {
  require(r.size() >= 4 && kappa.size() == r.size(), "distances", r.size(), "at least 4 are needed");
  constexpr std::size_t n = powers.size();
  std::vector<double> A(n * n, 0.0), b(n, 0.0);
  double chi2_of_none = 0;
  for (std::size_t k = 0; k < r.size(); ++k) {
    require(kappa[k].se > 0, "standard error of the conduction", kappa[k].se, "must be > 0");
    double const weight = 1 / (kappa[k].se * kappa[k].se), left = std::max(0.0, 1 - r[k] / cutoff);
    chi2_of_none += weight * kappa[k].mean * std::abs(kappa[k].mean);
    for (std::size_t i = 0; i < n; ++i) {
      b[i] += weight * kappa[k].mean * std::pow(left, powers[i]);
      for (std::size_t j = 0; j < n; ++j)
        A[i * n + j] += weight * std::pow(left, powers[i] + powers[j]);
    }
  }
  if (!(chi2_of_none > 9))
    throw PhysicsError("no exchange of energy between neighbours can be told from noise: make a longer run");
  double const trace = A[0];
  for (std::size_t i = 0; i < n; ++i)
    A[i * n + i] += 1e-10 * trace; // neighbouring powers are nearly one
  auto const coefficients = nonnegative_squares(A, b);
  ConductionTable table;
  for (std::size_t k = 0; k <= points; ++k) {
    double const at = cutoff * double(k) / points;
    double value = 0;
    for (std::size_t i = 0; i < n; ++i)
      value += coefficients[i] * std::pow(1 - at / cutoff, powers[i]);
    table.r.push_back(at), table.kappa.push_back(k == points ? 0 : value);
  }
  return table;
}

} // namespace mesobridge::cg
