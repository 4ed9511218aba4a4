#pragma once
#include "sdpd/state/parameter.hpp"
#include <span>
#include <vector>

namespace mesobridge::sdpd {

/// Parameters that several potentials have.
inline constexpr Parameter potential_depth{"epsilon", Dimension::energy,
                                           "depth of the minimum, before a shift", positive};
inline constexpr Parameter potential_minimum{"r_m", Dimension::length, "distance of the minimum", positive};
inline constexpr Parameter potential_end{"cutoff", Dimension::length,
                                         "where the potential ends and is shifted to zero", positive};

/// A pair potential as scenes know it: each class of potentials lists its own in kinds().
template <class Potential>
struct PotentialKind {
  std::string_view name;    ///< in scenes
  std::string_view summary; ///< a few words, or none where the name says it
  std::vector<Parameter> parameters;
  Potential (*make)(std::span<double const>); ///< of the parameters in their order; throws InputError
};

} // namespace mesobridge::sdpd
