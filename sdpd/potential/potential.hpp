#pragma once
#include "sdpd/potential/exp6.hpp"
#include "sdpd/potential/lennard_jones.hpp"
#include "sdpd/potential/soft_potential.hpp"
#include "sdpd/potential/tabulated_potential.hpp"
#include <variant>

namespace mesobridge::sdpd {

/// Particles that exert no conservative force on each other.
struct NoPotential {
  NoPotential in_units(double, double) const { return {}; }
  static constexpr double cutoff() { return 0; }
};

/// Every pair potential of DPD and DPDE; the force loop chooses once, outside.
using AnyPotential = std::variant<NoPotential, SoftPotential, LennardJones, Exp6, TabulatedPotential>;

} // namespace mesobridge::sdpd
