#pragma once
#include "workflows/coarse/star_to_dpde.hpp"
#include "workflows/coarse/structure_comparison.hpp"
#include "workflows/transport/beside.hpp"

namespace mesobridge::workflows {

/// A quantity of both fluids, and how far they may be apart: by that share, or by chance.
struct KeptQuantity {
  std::string key, what; ///< in summary.json and for people
  cg::Estimate molecules, particles;
  double share = 0; ///< of the molecules' value

  bool kept() const; ///< within the share, or within three combined standard errors
};

/// What the stages have measured of the molecules and of the particles that stand for them.
struct Kept {
  std::vector<KeptQuantity> quantities;
  RadialEstimate g_molecules, g_particles;
  StructureDifference g;
  TransportResult molecules, particles;
  cg::Estimate gamma_self;
  double cost_molecules = 0, cost_particles = 0; ///< processor time for a molecule and unit of time [s]
  double speed_up() const { return cost_molecules / cost_particles; }
};

/// Reads what the stages have written. Throws InputError where something is missing or damaged.
Kept read_kept(StarToDpdePlan const& plan, std::filesystem::path const& directory, Context const& context);

} // namespace mesobridge::workflows
