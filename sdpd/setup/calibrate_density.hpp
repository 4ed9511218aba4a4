#pragma once
#include "cg/estimate.hpp"
#include "sdpd/simulation.hpp"

namespace mesobridge::sdpd {

/// What fixes the scale of the densities; their self term is fixed by the mean density in either case.
enum class ScaleCondition {
  pressure, ///< the mean pressure of the fluid is that of the equation of state
  response  ///< the mean density follows an affine compression; for fluids almost without pressure
};

/// The constants of the densities that a fluid needs, found on itself.
struct DensityCalibration {
  DensityCorrection constants;
  double scale_se = 0, self_se = 0;
  /// Of the last stage, which ran with constants that were one improvement short of these; reduced.
  cg::Estimate rho, P;
  double P_eos = 0; ///< reduced
  std::size_t particles = 0;
  std::uint64_t steps = 0; ///< made in all
};

/// Throws InputError when the pressure cannot fix the scale, because it is small against the fluid's
/// stiffness.
void check_calibration(SimulationSettings const& settings, ScaleCondition condition);

/// How many particles a calibration runs.
double calibrated_particles(SimulationSettings const& settings);

/// The condition for that fluid: the pressure where it is large enough against the fluid's stiffness to fix
/// the scale, else the response; none where the fluid is under tension, which tears its particles' order
/// apart.
std::optional<ScaleCondition> suitable_condition(SimulationSettings const& settings);

/// Finds the constants c and epsilon of DensityCorrection with which the fluid of `settings` at its size K
/// has the mean density rho and the pressure of its equation of state (or the response): stages of growing
/// length, each at equilibrium at the set temperature, after which both conditions are solved with the
/// structure that was found; the last stage makes half of the `steps`. The box is the scene's, or one of
/// about a thousand particles if that is smaller. Constants that the settings have are where it begins.
///
/// The sum over the neighbours, <S>, and the response, <c B>, say that
///   c <S> + (c - epsilon) W(0) = 1  and  (P - n k_B T)(rho) c'/c = P_eos - n k_B T  (or <c B> = 1).
/// Throws InputError as check_calibration; PhysicsError when the run fails or no constants are found;
/// Interrupted.
DensityCalibration calibrate_density(SimulationSettings settings, ScaleCondition condition,
                                     std::uint64_t steps, std::function<bool()> const& keep_going);

} // namespace mesobridge::sdpd
