#pragma once
#include "sdpd/simulation.hpp"
#include "workflows/scene/scene.hpp"
#include "workflows/sdpd/engine.hpp"

namespace mesobridge::workflows {

/// What a scene will take, before anything is run.
struct CostEstimate {
  double neighbours;          ///< of a particle, (4 pi/3) (range / mean distance)^3
  double seconds;             ///< in all
  double calibration_seconds; ///< of these, for the constants of the densities
  double viscosity_seconds;   ///< of these, for trials of the viscosity
  double study_seconds;       ///< and for the study of an automatic time step
  double bytes;               ///< of memory, of all ranks, as measured on one
};

/// From the number of pairs: the time by the cost of a pair that `bench engine` finds on one core of the
/// machines of 2026 (within a factor of two elsewhere), the memory by what the engine stores.
/// Ranks are those of LAMMPS, for the run alone: all else is the built-in engine's on the threads of the
/// first.
CostEstimate estimate_cost(Scene const& scene, int threads, Engine engine = Engine::built_in, int ranks = 1);

/// "3.2 GB".
std::string bytes_text(double bytes);

} // namespace mesobridge::workflows
