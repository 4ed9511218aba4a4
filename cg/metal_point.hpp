#pragma once
#include "cg/estimate.hpp"
#include "md/metal.hpp"
#include <span>
#include <string_view>

namespace mesobridge::cg {

/// Whether the atoms kept their places or diffused.
enum class Phase { solid, liquid };
std::string_view name_of(Phase phase);

/// What one NVT run of a metal tells of its state, in SI.
struct MetalPoint {
  md::MetalState state;
  Estimate T_kin;    ///< measured kinetic temperature [K]
  Estimate P;        ///< [Pa]
  Estimate e;        ///< specific energy above the perfect crystal of zero pressure at rest [J/kg]
  Estimate c_v;      ///< from the fluctuations of e, classical [J/(kg K)]
  double cov_eP = 0; ///< covariance of the two means (they come from one run)
  Phase phase = Phase::solid;
  double displacement_2 = 0; ///< by how much the mean squared displacement grew in the second half of the
                             ///< samples, in squares of the nearest neighbours' distance
  md::MetalEnd end;
  std::size_t samples = 0;   ///< kept
  std::size_t discarded = 0; ///< cut as equilibration
};

/// Detects and cuts the equilibration, then estimates each quantity with its standard error; the kinetic
/// parts of e and P are put in exactly. The metal is called a liquid when the mean squared displacement grew
/// by more than 0.15 squared neighbour distances over the second half of the samples: in a crystal it does
/// not grow and even at the limit of superheating its whole is below 0.1. Throws InputError for fewer than 40
/// samples, PhysicsError when fewer than 10 independent samples remain.
MetalPoint analyse_metal(md::MetalState state, md::MetalSettings const& settings,
                         std::span<md::MetalSample const> samples, md::MetalEnd const& end);

} // namespace mesobridge::cg
