#include "sdpd/method/pair_fluid.hpp"
#include <algorithm>

namespace mesobridge::sdpd {

namespace {

template <class Variant>
double cutoff_of(Variant const& any) {
  return std::visit([](auto const& of) { return of.cutoff(); }, any);
}

AnyFrictionShape in_units(AnyFrictionShape const& shape, double length, double coefficient) {
  return std::visit([&](auto const& of) -> AnyFrictionShape { return of.in_units(length, coefficient); },
                    shape);
}

} // namespace

double PairFluid::friction_cutoff() const {
  return cutoff_of(friction);
}

double PairFluid::range() const {
  return std::max({friction_cutoff(), cutoff_of(potential), conduction ? cutoff_of(*conduction) : 0});
}

ReducedUnits PairFluid::units(double T) const {
  double const r_c = friction_cutoff();
  return {.K = 1, .m0 = mass, .density = mass / (r_c * r_c * r_c), .temperature = T, .boltzmann = boltzmann};
}

AnyPairLaw PairFluid::law(ReducedUnits const& units) const {
  double const k_B = 1; // energies count in k_B T
  AnyFrictionShape const shape = in_units(friction, units.length(), units.mass() / units.time());
  bool const across = std::visit([](auto const& of) { return of.has_across(); }, friction);
  if (follows_energy())
    return across ? AnyPairLaw(DpdeLaw<Across::own>{shape, k_B}) : DpdeLaw<Across::none>{shape, k_B};
  return across ? AnyPairLaw(DpdLaw<Across::own>{shape, k_B}) : DpdLaw<Across::none>{shape, k_B};
}

AnyPotential PairFluid::reduced_potential(ReducedUnits const& units) const {
  return std::visit(
      [&](auto const& of) -> AnyPotential { return of.in_units(units.length(), units.energy()); }, potential);
}

AnyConduction PairFluid::reduced_conduction(ReducedUnits const& units) const {
  if (!conduction)
    return std::monostate();
  double const coefficient = units.energy() * units.temperature / units.time(), k_B = 1;
  return DpdeConduction{in_units(*conduction, units.length(), coefficient), k_B};
}

void check(PairFluid const& fluid) {
  require(fluid.mass > 0 && std::isfinite(fluid.mass), "particle mass", fluid.mass, "must be > 0 and finite");
  require(fluid.boltzmann > 0 && std::isfinite(fluid.boltzmann), "Boltzmann constant", fluid.boltzmann,
          "must be > 0 and finite");
  for (auto const& [name, share, mass, internal_energy] : fluid.species) {
    require(mass > 0 && std::isfinite(mass), fmt::format("mass of species '{}'", name), mass,
            "must be > 0 and finite");
    require(internal_energy.has_value() == fluid.follows_energy(), fmt::format("species '{}'", name),
            internal_energy ? "an internal energy" : "none",
            "must have an internal energy in DPDE, and none in DPD");
  }
  if (fluid.conduction && !fluid.follows_energy())
    throw InputError("heat conduction: DPD has no internal energies that could be exchanged; take DPDE");
}

} // namespace mesobridge::sdpd
