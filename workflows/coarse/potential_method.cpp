#include "workflows/coarse/potential_method.hpp"
#include "workflows/coarse/structure_of_blobs.hpp"
#include "workflows/sdpd/settings.hpp"
#include <algorithm>
#include <cmath>

namespace mesobridge::workflows {

FoundPotential inverted_potential(PotentialWishes const&, std::string const&, Context const&);
FoundPotential matched_potential(PotentialWishes const&, std::string const&, Context const&);

std::vector<PotentialMethod> const& potential_methods() {
  static std::vector<std::string> const of_search{"--share", "--iterations", "--enough", "--pressure"};
  static std::vector<PotentialMethod> const methods{
      {"hnc", "the structure, by steps that count neighbours' neighbours", of_search, inverted_potential},
      {"boltzmann", "the structure, by steps of k_BT ln g", of_search, inverted_potential},
      {"force-matching", "the forces on the molecules", {"--knots", "--beside"}, matched_potential}};
  return methods;
}

PotentialSearch search_for(PotentialWishes const& wishes, CoarseStructure const& structure,
                           Context const& context) {
  auto search = wishes.search;
  auto& inversion = search.inversion;
  inversion.kT = structure.kT;
  inversion.least_pairs = 5e-4;
  inversion.cutoff = wishes.cutoff.value_or(usual_cutoff(structure.g, wishes.pressure));
  inversion.knots = std::max(inversion.knots, 2 * structure.g.width);
  double const reach = structure.g.width * double(structure.g.g.size());
  search.lattice =
      std::max(search.lattice, std::uint32_t(std::ceil(2 * reach * std::cbrt(structure.density))) + 1);
  search.seed = context.options.seed.value_or(1);
  search.threads = context.options.threads.value_or(available_threads());
  return search;
}

} // namespace mesobridge::workflows
