#pragma once
#include "sdpd/pair/exp6.hpp"
#include "sdpd/pair/lennard_jones.hpp"
#include "sdpd/pair/soft_potential.hpp"
#include "sdpd/pair/tabulated_potential.hpp"
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
