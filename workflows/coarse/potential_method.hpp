#pragma once
#include "workflows/coarse/potential_search.hpp"
#include "workflows/command.hpp"
#include "workflows/report/report.hpp"
#include "workflows/star/blob_file.hpp"

namespace mesobridge::workflows {

/// What the user asks of `cg potential`; a method takes those options that it names.
struct PotentialWishes {
  std::filesystem::path input;
  double width = 0.2;
  std::optional<double> cutoff;
  PotentialSearch search = {.inversion = {.share = 1}};
  bool pressure = false;
  std::optional<double> knots;
  std::optional<std::filesystem::path> beside; ///< another potential, r and u
};

/// What a method finds, and how it is told.
struct FoundPotential {
  BlobFileHead head;
  cg::PairPotential potential;
  Json json;
  std::string text;
  Report report;
};

/// A way from molecules to a pair potential.
struct PotentialMethod {
  std::string name, summary;
  std::vector<std::string> options; ///< that it takes, beside those of all methods
  FoundPotential (*find)(PotentialWishes const& wishes, std::string const& method, Context const& context);
};

/// Each is a file of this folder, and a line of this list.
std::vector<PotentialMethod> const& potential_methods();

/// How particles are to be run with a potential that gives them the molecules' structure.
PotentialSearch search_for(PotentialWishes const& wishes, CoarseStructure const& structure,
                           Context const& context);

} // namespace mesobridge::workflows
