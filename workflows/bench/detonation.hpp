#pragma once
#include "sdpd/method/settings.hpp"
#include "workflows/command.hpp"

namespace mesobridge::workflows {

/// What a step of a detonation costs beside one of the plain ideal gas in a periodic box, beside one of a
/// wide ideal gas, whose support is so much wider that its particles have as many neighbours as the
/// detonation's, and beside one of a fluid whose particles are all mixtures. The detonation is that of
/// workflows/scenes/detonation-nitromethane.toml, before its piston and with its other wall, in a box of
/// `across`^2 `along` mean distances of unburnt particles; timed when its front is in the middle. In each of
/// the `repeats` times every one goes on for `steps` steps, one after the other.
///
/// Json: an array of {fluid, us_per_particle_step, ratio, ratio_se, ratio_to_wide, ratio_to_wide_se,
/// neighbours, mixtures}; ratios are to the first, or the second, of the same repeat, their mean with its
/// standard error; `mixtures` is the mean share of the
/// particles whose progress lies within 10^-4 ... 1 - 10^-6. Processor time of the calling thread.
struct DetonationTiming {
  std::uint32_t across = 14, along = 172;
  int steps = 20, repeats = 5, threads = 1;
};
Json time_detonation(sdpd::SimulationSettings const& ideal_gas, sdpd::SimulationSettings const& all_mixtures,
                     DetonationTiming const& timing);

/// The same as lines of text.
std::string detonation_times_text(Json const& rows);

} // namespace mesobridge::workflows
