#include "workflows/coarse/force_matching_output.hpp"
#include "workflows/coarse/potential_method.hpp"
#include <spdlog/logger.h>

namespace mesobridge::workflows {

/// By least squares of the forces on the molecules; one run of particles tells their structure.
FoundPotential matched_potential(PotentialWishes const& wishes, std::string const&, Context const& context) {
  check_search(wishes.search); // before any work
  auto data = read_forces(wishes.input, wishes.width);
  auto const search = search_for(wishes, data.structure, context);
  auto progress = context.progress("Forces", 1);
  auto const found = cg::match_forces(data.forces,
                                      {.cutoff = search.inversion.cutoff,
                                       .width = data.structure.g.width,
                                       .knots = wishes.knots.value_or(2 * data.structure.g.width)},
                                      [&](double done) { progress.update(done); });
  progress.finish();
  data.forces = {};
  std::optional<PotentialBeside> beside;
  if (wishes.beside)
    beside = potential_beside(found, *wishes.beside);
  auto const trial = try_potential(found.potential(), data.structure, search);
  ForceMatch const match{data, found, trial, beside};
  for (auto const& warning : force_match_warnings(match))
    context.log->warn("{}", warning);
  return {.head = data.head,
          .potential = found.potential(),
          .json = force_match_json(match),
          .text = force_match_text(match),
          .report = force_match_report(match)};
}

} // namespace mesobridge::workflows
