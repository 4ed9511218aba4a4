#include "sdpd/method/settings.hpp"
#include <algorithm>

namespace mesobridge::sdpd {

namespace {

template <class AnySpecies>
std::vector<Species> in_units_of(double mass, std::vector<AnySpecies> const& species) {
  std::vector<Species> reduced;
  for (auto const& of : species)
    reduced.push_back({of.name, of.share, mass_of(of) / mass});
  return reduced;
}

} // namespace

std::size_t SimulationSettings::particle_count() const {
  return std::size_t{lattice[0]} * lattice[1] * lattice[2];
}

std::vector<Species> SimulationSettings::reduced_species() const {
  double const mass = units().mass();
  return pair_fluid ? in_units_of(mass, pair_fluid->species) : in_units_of(mass, species);
}

double SimulationSettings::spacing() const {
  double const of_unit_mass = pair_fluid ? std::cbrt(pair_fluid->mass / rho) / units().length() : 1;
  return of_unit_mass * std::cbrt(mean_mass(reduced_species(), particle_count()));
}

double SimulationSettings::range() const {
  return pair_fluid ? pair_fluid->range() / units().length() : h_factor * spacing();
}

Features SimulationSettings::features() const {
  return {.energies = !pair_fluid || pair_fluid->follows_energy(),
          .densities = !pair_fluid,
          .masses = !(pair_fluid ? pair_fluid->species.empty() : species.empty())};
}

bool SimulationSettings::conducts() const {
  return pair_fluid ? pair_fluid->conduction.has_value() : kappa > 0;
}

ReducedUnits SimulationSettings::units() const {
  if (pair_fluid)
    return pair_fluid->units(T);
  return std::visit(
      [this](auto const& model) {
        return ReducedUnits{.K = K,
                            .m0 = model.molecular_mass(),
                            .density = rho,
                            .temperature = T,
                            .boltzmann = model.boltzmann()};
      },
      eos);
}

Box box_of(SimulationSettings const& s) {
  return {s.spacing() * Vec3{double(s.lattice[0]), double(s.lattice[1]), double(s.lattice[2])}};
}

/// Skin of the neighbour lists, from the rms step of a particle, dt sqrt(3/K): fast particles want a wide
/// skin, slow ones a narrow one. The bounds and the factor were chosen by timing the ideal gas and argon at
/// K = 100, where 0.35 ... 0.5 cost the same, and DPDE fluids at dt = 0.01, which want 0.6 of the particles'
/// distance: 0.36 ranges with 20 neighbours, 0.24 with 62.
double skin_of(SimulationSettings const& s) {
  if (s.pair_fluid && s.skin == 0)
    return s.spacing() * std::clamp(35 * s.dt * std::sqrt(3.0), 0.4, 0.75);
  return s.skin > 0 ? s.skin : std::clamp(20 * s.dt * std::sqrt(3 / s.K), 0.3, 0.7);
}

/// Without noise the centres of mass have no thermal motion that could carry anything.
CentreOfMass centre_of_mass_of(SimulationSettings const& s) {
  return s.noise ? s.centre_of_mass : CentreOfMass::bulk;
}

} // namespace mesobridge::sdpd
