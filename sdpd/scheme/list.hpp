#pragma once
#include "sdpd/fluctuation/pair_scheme.hpp"
#include "sdpd/scheme/scheme.hpp"
#include <string>
#include <string_view>
#include <vector>

namespace mesobridge::sdpd {

/// A way to integrate fluctuation and dissipation, by its name in scenes and options.
struct NamedPairScheme {
  std::string name;
  PairScheme scheme;
  std::string summary; ///< what it does with a pair, a few words
};

/// Every pair scheme: scenes, options and studies take their names from here.
std::vector<NamedPairScheme> const& pair_schemes();

std::vector<std::string> pair_scheme_names();

/// Throws InputError that lists the names.
PairScheme pair_scheme(std::string_view name);

/// An integrator of the conservative forces by its name.
struct NamedConservative {
  std::string name;
  Conservative integrator;
  std::string summary;
};

std::vector<NamedConservative> const& conservative_integrators();

std::vector<std::string> conservative_names();

/// Throws InputError that lists the names.
Conservative conservative_integrator(std::string_view name);

} // namespace mesobridge::sdpd
