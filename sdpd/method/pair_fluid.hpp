#pragma once
#include "sdpd/method/parts.hpp"

namespace mesobridge::sdpd {

struct SimulationSettings;

/// What the particles of DPD and DPDE share: pair forces and friction. In the units of the settings (SI, or
/// any set of units with k_B = 1), in which rho is the mass per volume.
struct PairFluid {
  double mass;          ///< of a particle, > 0; with several species the unit of mass
  double boltzmann = 1; ///< k_B
  AnyPotential potential;
  AnyWeightFunction friction; ///< friction coefficients at the set temperature

  static constexpr bool reacts() { return false; }
  double friction_cutoff() const;
  /// The customary units of DPD: m, the friction's cut-off and k_B T are one.
  ReducedUnits units(SimulationSettings const& at) const;
  double unit_spacing(SimulationSettings const& at) const; ///< of particles of the unit of mass
  double range(SimulationSettings const& at) const;        ///< of the potential and the friction
  double usual_skin(SimulationSettings const& at) const;
  void check(SimulationSettings const& at) const;

 protected:
  /// The parts that do not depend on whether there are internal energies; `Law` is DpdLaw or DpdeLaw.
  template <template <Transverse> class Law>
  MethodParts parts_with(SimulationSettings const& at) const {
    auto const shape = reduced_friction(at);
    bool const across = std::visit([](auto const& of) { return of.has_across(); }, friction);
    return parts_with(
        across ? AnyPairLaw(Law<Transverse::own>{shape, k_B}) : Law<Transverse::none>{shape, k_B}, at);
  }

 private:
  static constexpr double k_B = 1; // energies count in k_B T
  AnyWeightFunction reduced_friction(SimulationSettings const& at) const;
  MethodParts parts_with(AnyPairLaw law, SimulationSettings const& at) const;
};

} // namespace mesobridge::sdpd
