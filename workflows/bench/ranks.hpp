#pragma once
#include "sdpd/method/settings.hpp"
#include "workflows/command.hpp"

namespace mesobridge::workflows {

/// What a step costs inside LAMMPS on the command's ranks, beside one of the built-in engine on the settings'
/// threads: the same settled fluid goes on for `steps` steps by either, one after the other, in each of the
/// `repeats`. Time on the wall, without what brings the particles to the ranks and back. Json: an array of
/// {engine, us_per_particle_step, ratio, ratio_se, neighbours}; ratios are to the built-in engine in the same
/// repeat, their mean with its standard error. On ranks but the first, and where the ranks are still to be
/// started, an empty result: another process tells it. Throws InputError for what does not run there.
struct RanksTiming {
  std::string method, scheme; ///< as they are named, for the result
  int steps = 20, repeats = 5;
};
Result time_on_ranks(sdpd::SimulationSettings const& settings, RanksTiming const& timing,
                     Context const& context);

} // namespace mesobridge::workflows
