#pragma once
#include "sdpd/method/settings.hpp"
#include "workflows/command.hpp"

namespace mesobridge::workflows {

/// What a step costs in boxes of other faces, beside the periodic one: two walls at rest; two open faces;
/// open faces of a box ten times as long, of which the fluid fills a tenth. Each begins from the same settled
/// fluid before each of the `repeats` times in which `steps` steps are timed, box after box. Json: an array
/// of {box, us_per_particle_step, ratio, ratio_se, neighbours, list_renewals_per_step, without_renewals};
/// ratios are to the periodic box of the same repeat, their mean with its standard error. What a face costs
/// and what the flow through it costs, by which lists last for fewer steps, are apart in `without_renewals`:
/// {us_per_particle_step, ratio, ratio_se} of the steps that renew no lists, where every repeat has some. The
/// faces are those across z, the times processor time of the calling thread.
struct FacesTiming {
  int steps = 20, repeats = 5;
};
Json time_faces(sdpd::SimulationSettings const& periodic, FacesTiming const& timing);

/// The same as lines of text.
std::string faces_text(Json const& rows);

} // namespace mesobridge::workflows
