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

/// The start that leaves the most independent samples. The marginal standard error rule is the second
/// opinion: it is followed where its further cut moves the mean by more than two standard errors, not where
/// it only loses samples.
std::size_t stationary_from(std::span<double const> series) {
  std::size_t const start = detect_equilibration(series).start;
  auto const kept = series.subspan(start);
  if (kept.size() < 80)
    return start;
  std::size_t const further = marginal_standard_error_start(kept);
  bool const moves_the_mean = !agrees(estimate_mean(kept), estimate_mean(kept.subspan(further)).mean, 2);
  return moves_the_mean ? start + further : start;
}

/// Fewer do not tell their own error. Their number allows for its uncertainty (cg/README.md, Eq. (C51)):
/// short states of copper that had ten and more by (C50) alone have 5.5 and 9.3.
constexpr double least_independent = 5;

[[noreturn]] void throw_too_short(double rho, double T, double independent) {
  throw PhysicsError(fmt::format("the state rho* = {}, T* = {} has only {:.1f} independent samples after its "
                                 "equilibration was cut; at least {:g} are needed: sample it longer",
                                 rho, T, independent, least_independent));
}

} // namespace

StatePoint analyse_state(double rho, double T, int atoms, std::span<md::ThermoSample const> samples) {
  require(rho > 0 && std::isfinite(rho), "density", rho, "must be > 0");
  require(T > 0 && std::isfinite(T), "temperature", T, "must be > 0");
  require(atoms > 0, "atoms", atoms, "must be > 0");
  Columns const columns(rho, T, samples);
  std::size_t const start = std::max(stationary_from(columns.U), stationary_from(columns.P));
  if (columns.U.size() - start < 16)
    throw_too_short(rho, T, double(columns.U.size() - start));
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
  if (!(independent >= least_independent))
    throw_too_short(rho, T, independent);
  point.cov_UP = covariance_of_means(U, P);
  // <dE^2> = k_B T^2 C_V of the whole box. The positions give this part; the momenta add 3/2 exactly.
  auto const variance = estimate_variance(U);
  double const scale = atoms / (T * T);
  point.c_v = {1.5 + scale * variance.mean, scale * variance.se, variance.n_eff};
  return point;
}

} // namespace mesobridge::cg
