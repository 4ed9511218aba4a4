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

/// What a run of the particles has kept of the molecules that they stand for.
struct KeptRun {
  CoarseRun run;
  std::vector<KeptQuantity> quantities;
  RadialEstimate g_particles;
  StructureDifference g;
  TransportResult particles;
  double cost = 0;    ///< processor time for a particle and unit of time [s]
  double seconds = 0; ///< processor time of what is sampled
};

/// What the stages have measured of the molecules, and what each run has kept of it.
struct Kept {
  RadialEstimate g_molecules;
  TransportResult molecules;
  cg::Estimate gamma_self;
  double cost_molecules = 0;    ///< processor time for a molecule and unit of time [s]
  double seconds_molecules = 0; ///< processor time of what is sampled, without the way to equilibrium
  std::vector<KeptRun> runs;    ///< as the plan has them

  KeptRun const& own() const { return runs.front(); } ///< of the model that was found here
  double speed_up(KeptRun const& of) const { return cost_molecules / of.cost; }
};

/// Reads what the stages have written. Throws InputError where something is missing or damaged.
Kept read_kept(StarToDpdePlan const& plan, std::filesystem::path const& directory, Context const& context);

} // namespace mesobridge::workflows
