#include "md/error.hpp"
#include "workflows/coarse/potential_method.hpp"
#include "workflows/coarse/potential_output.hpp"
#include "workflows/coarse/structure_of_blobs.hpp"

namespace mesobridge::workflows {

/// By iterative inversion of the structure, which the particles then have.
FoundPotential inverted_potential(PotentialWishes const& wishes, std::string const& method,
                                  Context const& context) {
  auto const data = read_blobs(wishes.input);
  refuse_walls(data.head, wishes.input, "a potential");
  check_search(wishes.search); // before any work
  auto structure = structure_of(data, wishes.width);
  auto search = search_for(wishes, structure, context);
  if (method == "hnc")
    search.inversion.density = structure.density;
  auto const P = structure.P;
  require(P || !wishes.pressure, "--pressure", wishes.input.string(),
          "holds no pressures, as blobs of a trajectory do not: it cannot be kept");
  if (!wishes.pressure)
    structure.P.reset(); // it is shown, not kept
  auto progress = context.progress("Potential", 1);
  auto const trials = search_potential(structure, search, [&](int done) {
    progress.update(double(done) / search.iterations, fmt::format("trial {}", done));
  });
  progress.finish();
  structure.P = P;
  return {.head = data.head,
          .potential = best(trials).potential,
          .json = potential_json(structure, trials),
          .text = potential_text(structure, trials),
          .report = potential_report(structure, trials, data.head.name, units_text(data.head))};
}

} // namespace mesobridge::workflows
