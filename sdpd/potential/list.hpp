#pragma once
#include "sdpd/potential/exp6.hpp"
#include "sdpd/potential/lennard_jones.hpp"
#include "sdpd/potential/morse.hpp"
#include "sdpd/potential/soft_potential.hpp"
#include "sdpd/potential/tabulated_potential.hpp"
#include <functional>
#include <variant>

namespace mesobridge::sdpd {

/// Particles that exert no conservative force on each other.
struct NoPotential {
  static std::vector<PotentialKind<NoPotential>> kinds() {
    return {{"none", "", {}, [](auto) { return NoPotential{}; }}};
  }
  NoPotential in_units(double, double) const { return {}; }
  static constexpr double cutoff() { return 0; }
};

/// Every pair potential of DPD and DPDE; the force loop chooses once, outside. A new one is a file and a line
/// here; scenes and tests know it by its kinds().
using AnyPotential = std::variant<NoPotential, SoftPotential, LennardJones, Exp6, Morse, TabulatedPotential>;

/// A potential by its name in scenes.
struct NamedPotential {
  std::string_view name, summary;
  std::vector<Parameter> parameters;
  std::function<AnyPotential(std::span<double const>)> make;
};

/// All potentials that are made of parameters (not those from tables), in the order of AnyPotential.
std::vector<NamedPotential> const& potentials();

} // namespace mesobridge::sdpd
