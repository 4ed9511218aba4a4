#pragma once
#include "fitting/fit_lj_bwr.hpp"
#include "workflows/sdpd/run_scene.hpp"

namespace mesobridge::workflows {

/// What the chain has found: the input of its figures, its summary and its report.
struct ChainResults {
  cg::StateGrid grid;
  std::string md_description; ///< how the states were sampled, one line
  fitting::LjBwrFit fit;
  std::vector<RunResult> fluid, published, ideal, drift;
  struct Seconds {
    double md = 0, fit = 0, sdpd = 0;
  } seconds;
};

/// alpha = C dt^n through the drift rates of one particle size.
struct DriftLaw {
  double K;
  std::vector<double> dt, rate, se; ///< all runs of that size
  std::size_t used = 0;             ///< rates that are resolved: > 2 standard errors
  cg::Estimate exponent, prefactor; ///< without errors when fewer than 3 rates are resolved
};

/// The power laws through the drift runs, one for each size in their order. Weighted least squares in
/// logarithms.
std::vector<DriftLaw> drift_laws(std::vector<RunResult> const& runs);

/// Kolmogorov-Smirnov test of an ideal-gas run's internal energies against the Gamma law of
/// sdpd/README.md, Eq. (S19).
struct GammaTest {
  double distance, p_value;
  std::size_t samples;
};
GammaTest gamma_test(RunResult const& run);

/// The thesis's Table 5.1 at size K: means of energy [k_B T per molecule], density [kg/m^3], pressure [GPa].
struct ThesisMeans {
  double energy, density, pressure;
};
ThesisMeans thesis_means(double K);

/// Its variances: of energy [(k_B T)^2 per K^2], density [(kg/m^3)^2], pressure [GPa^2].
ThesisMeans thesis_variances(double K);

} // namespace mesobridge::workflows
