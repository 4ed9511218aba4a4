#include "cg/state_grid.hpp"
#include "cg/equilibration.hpp"
#include "md/error.hpp"
#include <algorithm>
#include <cmath>

namespace mesobridge::cg {
namespace {

/// The columns of the samples, with the noise of the measured kinetic energy taken out of U and P: in the
/// canonical ensemble the momenta are independent of the positions and their part of each mean is known
/// exactly.
struct Columns {
  std::vector<double> T_kin, U, P;

  Columns(double rho, double T, std::span<md::ThermoSample const> samples) {
    for (auto const& sample : samples) {
      T_kin.push_back(sample.T);
      U.push_back(sample.U - 1.5 * (sample.T - T));
      P.push_back(sample.P - rho * (sample.T - T));
    }
  }
};

std::size_t stationary_from(std::span<double const> series) {
  return std::max(detect_equilibration(series).start, marginal_standard_error_start(series));
}

} // namespace

StatePoint analyse_state(double rho, double T, int atoms, std::span<md::ThermoSample const> samples) {
  require(rho > 0 && std::isfinite(rho), "density", rho, "must be > 0");
  require(T > 0 && std::isfinite(T), "temperature", T, "must be > 0");
  require(atoms > 0, "atoms", atoms, "must be > 0");
  Columns const columns(rho, T, samples);
  std::size_t const start = std::max(stationary_from(columns.U), stationary_from(columns.P));
  auto const T_kin = std::span(columns.T_kin).subspan(start);
  auto const U = std::span(columns.U).subspan(start), P = std::span(columns.P).subspan(start);

  StatePoint point;
  point.rho = rho, point.T = T, point.atoms = atoms;
  point.T_kin = estimate_mean(T_kin);
  point.U = estimate_mean(U);
  point.P = estimate_mean(P);
  point.tau_U = autocorrelation_time(U).tau;
  point.tau_P = autocorrelation_time(P).tau;
  point.samples = U.size();
  point.discarded = start;
  double const independent = std::min(point.U.n_eff, point.P.n_eff);
  if (!(independent >= 10))
    throw PhysicsError(fmt::format(
        "the state rho* = {}, T* = {} has only {:.1f} independent samples after its equilibration "
        "was cut; at least 10 are needed: sample it longer",
        rho, T, independent));
  point.cov_UP = covariance_of_means(U, P);
  // <dE^2> = k_B T^2 C_V of the whole box. The positions give this part; the momenta add 3/2 exactly.
  auto const variance = estimate_variance(U);
  double const scale = atoms / (T * T);
  point.c_v = {1.5 + scale * variance.mean, scale * variance.se, variance.n_eff};
  return point;
}

} // namespace mesobridge::cg
