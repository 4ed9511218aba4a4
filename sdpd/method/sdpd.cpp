#include "sdpd/method/sdpd.hpp"
#include "sdpd/method/settings.hpp"
#include "sdpd/thermodynamics/particle_eos.hpp"
#include "sdpd/thermodynamics/reacting.hpp"
#include <algorithm>

namespace mesobridge::sdpd {
namespace {

/// Without noise the centres of mass have no thermal motion that could carry anything.
CentreOfMass centre_of_mass_of(Sdpd const& fluid, SimulationSettings const& at) {
  return at.noise ? fluid.centre_of_mass : CentreOfMass::bulk;
}

SdpdFriction friction_of(Sdpd const& fluid, ReducedUnits const& units) {
  return {fluid.eta / units.viscosity(), fluid.zeta / units.viscosity()};
}

/// At the set density and temperature, in k_B. Throws PhysicsError when the model has no such state.
double heat_capacity_of_a_particle(double K, fitting::AnyEos const& any, CentreOfMass centre_of_mass,
                                   SimulationSettings const& at) {
  double const bulk = std::visit(
      [&](auto const& eos) {
        return eos.heat_capacity(eos.energy_from_temperature(at.T, at.rho), at.rho) * eos.molecular_mass() /
               eos.boltzmann();
      },
      any);
  return K * bulk - (centre_of_mass == CentreOfMass::free ? 1.5 : 0);
}

void check_size(double K, fitting::AnyEos const& eos, CentreOfMass centre_of_mass,
                SimulationSettings const& at) {
  require(Sdpd::sizes.contains(K), "particle size K", K, Sdpd::sizes.demand());
  double const C = heat_capacity_of_a_particle(K, eos, centre_of_mass, at);
  require(
      C > least_heat_capacity, "particle size K", K,
      fmt::format("is too small: a particle has the heat capacity {:.4g} k_B at rho and T{}, and above {} "
                  "k_B is needed for a positive friction (sdpd/README.md, Eq. (S15))",
                  C, centre_of_mass == CentreOfMass::free ? " without its centre of mass" : "",
                  least_heat_capacity));
}

std::unique_ptr<Thermodynamics const> thermodynamics_of(Sdpd const& fluid, SimulationSettings const& at) {
  auto const units = fluid.units(at);
  auto const centre_of_mass = centre_of_mass_of(fluid, at);
  if (fluid.reaction)
    return make_reacting_thermodynamics(
        {fluid.eos, fluid.reaction->product, fluid.reaction->additive_volumes}, units, centre_of_mass);
  if (fluid.species.empty())
    return make_thermodynamics(fluid.eos, units, centre_of_mass);
  return mixture_of(fluid.species, [&](SdpdSpecies const& of) {
    return make_thermodynamics(of.eos, units, centre_of_mass, {of.K, mass_of(of) / units.mass()});
  });
}

void check_reaction(Sdpd const& fluid, SimulationSettings const& at) {
  auto const& reaction = *fluid.reaction;
  require(fluid.species.empty(), "species of a fluid that reacts", fluid.species.size(),
          "must be one: every region has the fluid's equation of state and size");
  require(any_number.contains(reaction.heat), "heat of reaction", reaction.heat, any_number.demand());
  require(reaction.shares.contains(reaction.progress), "progress of the reaction", reaction.progress,
          reaction.shares.demand());
  thermodynamics_of(fluid, at); // which refuses what cannot be mixed, and what cannot be pure
}

std::optional<Reaction> reaction_of(Sdpd const& fluid, ReducedUnits const& units) {
  if (!fluid.reaction)
    return std::nullopt;
  auto const in_units = [&](auto const& law) { return AnyKinetics(law.in_units(units)); };
  return Reaction{std::visit(in_units, fluid.reaction->kinetics),
                  fluid.reaction->heat / units.specific_energy(), fluid.reaction->integrator};
}

} // namespace

ReducedUnits Sdpd::units(SimulationSettings const& at) const {
  return std::visit(
      [&](auto const& model) {
        return ReducedUnits{.K = K,
                            .m0 = model.molecular_mass(),
                            .density = at.rho,
                            .temperature = at.T,
                            .boltzmann = model.boltzmann()};
      },
      eos);
}

/// From the rms step of a particle, dt sqrt(3/K): fast particles want a wide skin, slow ones a narrow one.
/// The bounds and the factor were chosen by timing the ideal gas and argon at K = 100, where 0.35 ... 0.5
/// cost the same.
double Sdpd::usual_skin(SimulationSettings const& at) const {
  return std::clamp(20 * at.dt * std::sqrt(3 / K), 0.3, 0.7);
}

double Sdpd::range(SimulationSettings const& at) const {
  return h_factor * at.spacing();
}

void Sdpd::check(SimulationSettings const& at) const {
  check_size(K, eos, centre_of_mass_of(*this, at), at);
  for (auto const& of : species) {
    auto here = at;
    here.rho = of.rho > 0 ? of.rho : at.rho, here.T = of.T > 0 ? of.T : at.T;
    check_size(of.K, of.eos, centre_of_mass_of(*this, at), here);
  }
  require(supports.contains(h_factor), "kernel support h_factor", h_factor, supports.demand());
  auto const& [scale, self] = density_correction;
  require(positive.contains(scale), "density correction scale", scale, positive.demand());
  require(self < scale && self > -scale, "density correction self", self,
          "must lie between -scale and scale");
  make_kernel(kernel, h_factor);
  friction_of(*this, units(at));
  require(not_negative.contains(kappa), "thermal conductivity kappa", kappa, not_negative.demand());
  if (reaction)
    check_reaction(*this, at);
}

MethodParts Sdpd::parts(SimulationSettings const& at) const {
  ReducedUnits const reduced = units(at);
  double const k_B =
      at.noise ? 1 / K : 0; // what has no noise is the limit k_B -> 0 of friction and conduction
  AnyKernel const W = make_kernel(kernel, range(at), density_correction.scale);
  return {.thermodynamics = thermodynamics_of(*this, at),
          .kernel = W,
          .self_density = self_density(W, density_correction),
          .density_sum = density_sum,
          .potential = NoPotential{},
          .law = SdpdLaw{friction_of(*this, reduced), k_B},
          .conduction = conducts() ? AnyConduction(SdpdConduction{kappa / reduced.conductivity(), k_B})
                                   : std::monostate(),
          .boltzmann = 1 / K,
          .reaction = reaction_of(*this, reduced)};
}

} // namespace mesobridge::sdpd
