#pragma once
#include "fitting/eos/evaluate.hpp"
#include "workflows/size_study/study.hpp"

namespace mesobridge::workflows {

/// The sizes, and the steps of one calibration and of one run.
struct SizeRunLength {
  std::vector<double> sizes;
  std::uint64_t calibrate, settle, sample;
  double settle_per_size; ///< at least this time (reduced) for each atom of a particle
};

/// Argon at the study's state.
sdpd::SimulationSettings fluid(std::string const& kernel, double K, std::uint64_t seed);

/// The equation of state at the settings' density and temperature.
fitting::EosState eos_state(sdpd::SimulationSettings const& settings);

/// Settles and samples a fluid. Throws Interrupted.
FluidRun run_fluid(sdpd::SimulationSettings const& settings, Treatment treatment,
                   SizeRunLength const& run_length);

/// g(r) of a settled fluid. Throws Interrupted.
Structure find_structure(std::string const& kernel, double K, std::uint64_t seed,
                         SizeRunLength const& run_length);

} // namespace mesobridge::workflows
