#include "sdpd/make_system.hpp"
#include "sdpd/conservative/refresh.hpp"
#include "sdpd/method/settings.hpp"
#include "sdpd/state/random.hpp"
#include "sdpd/thermodynamics/mixture.hpp"
#include <algorithm>

namespace mesobridge::sdpd {
namespace {

/// Positions on a simple cubic lattice whose spacing is the mean distance between particles, with Gaussian
/// displacements, ids in its order.
void place_on_lattice(Particles& particles, SimulationSettings const& settings) {
  NoiseSource const source(settings.seed, Stream::initial_positions, 0);
  double const spacing = settings.spacing();
  auto const [n_x, n_y, n_z] = settings.lattice;
  std::uint32_t id = 0;
  for (std::uint32_t z = 0; z < n_z; ++z)
    for (std::uint32_t y = 0; y < n_y; ++y)
      for (std::uint32_t x = 0; x < n_x; ++x, ++id) {
        auto const G = gaussians_reference(source, id, 0);
        particles.id[id] = id;
        particles.q[id] =
            spacing * (Vec3{x + 0.5, y + 0.5, z + 0.5} + settings.disorder * Vec3{G[0], G[1], G[2]});
      }
}

/// Maxwell velocities at T = 1 whose sum is zero and whose kinetic energy is exactly (3/2)(N-1) k_B T.
void draw_momenta(Particles& particles, double boltzmann, std::uint64_t seed) {
  NoiseSource const source(seed, Stream::initial_velocities, 0);
  Vec3 sum{};
  double mass = 0;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    auto const G = gaussians_reference(source, particles.id[i], 0);
    double const m = particles.mass_of(i);
    sum += particles.p[i] = std::sqrt(m) * Vec3{G[0], G[1], G[2]}, mass += m;
  }
  double const count = static_cast<double>(particles.size());
  double square = 0;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    double const m = particles.mass_of(i);
    square += norm2(particles.p[i] -= m * (sum / mass)) / m;
  }
  double const scale = std::sqrt(3 * (count - 1) * boltzmann / square);
  for (auto& p : particles.p)
    p *= scale;
}

/// Boltzmann's constant of friction and conduction: what has no noise is the limit k_B -> 0.
double noise_boltzmann(SimulationSettings const& s) {
  return s.noise ? 1 / s.K : 0;
}

AnyConduction conduction_of(SimulationSettings const& s) {
  if (s.kappa == 0)
    return std::monostate();
  return SdpdConduction{s.kappa / s.units().conductivity(), noise_boltzmann(s)};
}

template <class AnySpecies, class Make>
std::unique_ptr<Thermodynamics const> mixture_of(std::vector<AnySpecies> const& species, Make const& make) {
  std::vector<std::unique_ptr<Thermodynamics const>> parts;
  for (auto const& of : species)
    parts.push_back(make(of));
  return make_mixture(std::move(parts));
}

std::unique_ptr<Thermodynamics const> sdpd_thermodynamics(SimulationSettings const& s) {
  if (s.species.empty())
    return make_thermodynamics(s.eos, s.units(), centre_of_mass_of(s));
  return mixture_of(s.species, [&](SdpdSpecies const& of) {
    return make_thermodynamics(of.eos, s.units(), centre_of_mass_of(s),
                               {of.K, mass_of(of) / s.units().mass()});
  });
}

std::unique_ptr<Thermodynamics const> pair_thermodynamics(PairFluid const& fluid, ReducedUnits const& units) {
  if (!fluid.follows_energy())
    return nullptr;
  if (fluid.species.empty())
    return make_thermodynamics(*fluid.internal_energy, units);
  return mixture_of(fluid.species,
                    [&](PairSpecies const& of) { return make_thermodynamics(*of.internal_energy, units); });
}

System sdpd_system(SimulationSettings const& s) {
  ReducedUnits const units = s.units();
  AnyKernel const kernel = make_kernel(s.kernel, s.range(), s.density_correction.scale);
  return {
      .box = box_of(s),
      .species = s.reduced_species(),
      .thermodynamics = sdpd_thermodynamics(s),
      .kernel = kernel,
      .self_density = self_density(kernel, s.density_correction),
      .potential = NoPotential{},
      .law = SdpdLaw{SdpdFriction(s.eta / units.viscosity(), s.zeta / units.viscosity()), noise_boltzmann(s)},
      .conduction = conduction_of(s),
      .neighbours = Neighbours(box_of(s), s.range(), skin_of(s), s.threads),
      .boltzmann = 1 / s.K,
      .seed = s.seed,
      .threads = s.threads};
}

System pair_fluid_system(SimulationSettings const& s) {
  ReducedUnits const units = s.units();
  auto const& fluid = *s.pair_fluid;
  return {.box = box_of(s),
          .species = s.reduced_species(),
          .thermodynamics = pair_thermodynamics(fluid, units),
          .kernel = CubicKernel(s.range()),
          .self_density = 0,
          .potential = fluid.reduced_potential(units),
          .law = fluid.law(units),
          .conduction = fluid.reduced_conduction(units),
          .neighbours = Neighbours(box_of(s), s.range(), skin_of(s), s.threads),
          .boltzmann = 1,
          .seed = s.seed,
          .threads = s.threads};
}

std::unique_ptr<System> build(SimulationSettings const& s) {
  auto system = std::make_unique<System>(s.pair_fluid ? pair_fluid_system(s) : sdpd_system(s));
  system->dt = s.dt;
  system->particles.resize(s.particle_count(), s.features());
  place_on_lattice(system->particles, s);
  if (!system->species.empty())
    system->species_of_id = draw_species(system->species, s.particle_count(), s.seed);
  system->label_particles();
  if (s.noise)
    draw_momenta(system->particles, system->boltzmann, s.seed);
  std::fill(system->particles.T.begin(), system->particles.T.end(), 1.0);
  return system;
}

} // namespace

std::unique_ptr<System> make_system(SimulationSettings const& settings) {
  check(settings);
  auto system = build(settings);
  set_energies_from_temperatures(*system);
  refresh(*system);
  return system;
}

} // namespace mesobridge::sdpd
