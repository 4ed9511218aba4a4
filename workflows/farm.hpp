#pragma once
#include "workflows/command.hpp"
#include <span>

namespace mesobridge::workflows {

/// A call of this program, or of another, that is made as a process of its own on one core.
struct FarmedRun {
  std::vector<std::string> argv;          ///< argv[0] is the program; it must print no result
  double work = 0;                        ///< > 0, in the same unit for all: the most work is begun first
  std::function<void(double)> ended = {}; ///< told the processor time that it took [s], once it has done well
};

/// Whether independent runs end sooner as processes of one core each than one after the other on all cores.
bool farming_pays(std::span<double const> work, int cores);

/// Makes the runs, so many at once, and shows how far they are all together by what their Progress reports.
/// An interrupt is passed on; so is a stop once a run has failed, since the others would be waited for in
/// vain. Throws, when all have ended: Interrupted; AlreadyReported with the exit code of the run that failed
/// first (it has told why); EnvironmentError when a signal ended one.
void farm(std::string const& title, std::vector<FarmedRun> runs, int at_once, Context const& context);

} // namespace mesobridge::workflows
