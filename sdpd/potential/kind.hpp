#pragma once
#include "sdpd/state/parameter.hpp"
#include <span>
#include <vector>

namespace mesobridge::sdpd {

/// Parameters that several potentials have.
inline constexpr Parameter potential_depth{.name = "epsilon",
                                           .unit = Parameter::Unit::energy,
                                           .meaning = "depth of the minimum, before a shift",
                                           .above = true};
inline constexpr Parameter potential_end{.name = "cutoff",
                                         .unit = Parameter::Unit::length,
                                         .meaning = "where the potential ends and is shifted to zero",
                                         .above = true};

/// A pair potential as scenes know it: each class of potentials lists its own in kinds().
template <class Potential>
struct PotentialKind {
  std::string_view name;    ///< in scenes
  std::string_view summary; ///< a few words, or none where the name says it
  std::vector<Parameter> parameters;
  Potential (*make)(std::span<double const>); ///< of the parameters in their order; throws InputError
};

} // namespace mesobridge::sdpd
