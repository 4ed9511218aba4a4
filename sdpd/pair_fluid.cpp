#include "sdpd/pair_fluid.hpp"

namespace mesobridge::sdpd {

double PairFluid::friction_cutoff() const {
  return std::visit([](auto const& of) { return of.cutoff(); }, friction);
}

double PairFluid::range() const {
  return std::max(friction_cutoff(), std::visit([](auto const& of) { return of.cutoff(); }, potential));
}

ReducedUnits PairFluid::units(double T) const {
  double const r_c = friction_cutoff();
  return {.K = 1, .m0 = mass, .density = mass / (r_c * r_c * r_c), .temperature = T, .boltzmann = boltzmann};
}

AnyPairLaw PairFluid::law(ReducedUnits const& units) const {
  double const coefficient = units.mass() / units.time(), k_B = 1; // energies count in k_B T
  AnyFrictionShape const shape = std::visit(
      [&](auto const& of) -> AnyFrictionShape { return of.in_units(units.length(), coefficient); }, friction);
  bool const across = std::visit([](auto const& of) { return of.has_across(); }, friction);
  if (follows_energy())
    return across ? AnyPairLaw(DpdeLaw<Across::own>{shape, k_B}) : DpdeLaw<Across::none>{shape, k_B};
  return across ? AnyPairLaw(DpdLaw<Across::own>{shape, k_B}) : DpdLaw<Across::none>{shape, k_B};
}

AnyPotential PairFluid::reduced_potential(ReducedUnits const& units) const {
  return std::visit(
      [&](auto const& of) -> AnyPotential { return of.in_units(units.length(), units.energy()); }, potential);
}

void check(PairFluid const& fluid) {
  require(fluid.mass > 0 && std::isfinite(fluid.mass), "particle mass", fluid.mass, "must be > 0 and finite");
  require(fluid.boltzmann > 0 && std::isfinite(fluid.boltzmann), "Boltzmann constant", fluid.boltzmann,
          "must be > 0 and finite");
}

} // namespace mesobridge::sdpd
