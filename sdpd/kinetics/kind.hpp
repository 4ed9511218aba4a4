#pragma once
#include "sdpd/state/parameter.hpp"
#include "sdpd/state/units.hpp"
#include <span>
#include <vector>

namespace mesobridge::sdpd {

/// How fast a particle reacts: d lambda/dt = forward (1 - lambda) - backward lambda (sdpd/README.md, Eq.
/// (S61)). Both are >= 0.
struct Rates {
  double forward = 0, backward = 0;
};

/// What a law sees of a particle that reacts by itself.
struct LocalState {
  double progress, T, P, rho;
};

/// A law of kinetics as scenes know it: each class of laws lists its own in kinds().
template <class Law>
struct KineticsKind {
  std::string_view name;    ///< in scenes
  std::string_view summary; ///< a few words
  std::vector<Parameter> parameters;
  Law (*make)(std::span<double const>); ///< of the parameters in their order; throws InputError
};

/// The largest change of lambda over which the rates of a law may be taken as constant where no temperature
/// drives them.
inline constexpr double usual_change = 0.05;

} // namespace mesobridge::sdpd
