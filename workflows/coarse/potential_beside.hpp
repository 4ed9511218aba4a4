#pragma once
#include "cg/force_matching.hpp"
#include "workflows/command.hpp"

namespace mesobridge::workflows {

/// Another potential in the middles of the bins of one by force matching, as far as both have values and
/// pairs were seen.
struct PotentialBeside {
  std::string name;               ///< of its file
  std::size_t first_bin = 0;      ///< of ours, from which on all are compared
  std::vector<double> r, u, f;    ///< what the other one says
  std::vector<double> u_se, f_se; ///< ours less the other's, in our standard errors
  cg::Estimate u_apart; ///< root mean square over the pairs, of u; its error is what ours alone makes it
  cg::Estimate f_apart;
};

/// Of a file with columns r, u and maybe f; beyond its last row it is zero. Throws InputError as
/// read_columns, and for tables that are no potential.
PotentialBeside potential_beside(cg::MatchedForce const& ours, std::filesystem::path const& file);

Json beside_json(PotentialBeside const& beside);
std::string beside_text(PotentialBeside const& beside);

} // namespace mesobridge::workflows
