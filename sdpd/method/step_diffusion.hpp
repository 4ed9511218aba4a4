#pragma once
#include "cg/estimate.hpp"
#include "sdpd/method/settings.hpp"

namespace mesobridge::sdpd {

/// The rate at which friction makes a particle's velocity forget in a fluid without structure, reduced (the
/// omega of sdpd/README.md, Eq. (S55)). Of one species; 0 without friction.
double velocity_decay_rate(SimulationSettings const& settings);

/// By which share a step between two of friction, of this reduced length, makes self-diffusion too large
/// (sdpd/README.md, Eq. (S92)).
double diffusion_excess(double rate, double step);

/// The step that makes it too large by the share > 0; infinite without friction.
double step_of_diffusion_excess(double rate, double share);

/// What runs at several steps say of the excess (S92): their diffusion is D_0 (1 + share * excess)
/// (sdpd/README.md, Eq. (S93)).
struct DiffusionAgainstStep {
  cg::Estimate D_0, share; ///< se = 0: not known; n_eff counts the steps that they rest on

  bool known() const { return share.se > 0; }
  /// The largest share, of either sign, that a standard error allows: at most 1, which holds for a particle
  /// alone, unless the runs surely say more.
  double at_most() const;
};

/// Weighted least squares; the longest steps are left out while the line does not hold (chi^2 of a
/// probability below 1 %). `excess`: of (S92), in ascending order. Not known() by fewer than three diffusions
/// with errors, or where no three follow a line whose D_0 is above two standard errors.
DiffusionAgainstStep diffusion_against_step(std::span<double const> excess, std::span<cg::Estimate const> D);

} // namespace mesobridge::sdpd
