#include "sdpd/make_system.hpp"
#include "sdpd/conservative/refresh.hpp"
#include "sdpd/method/settings.hpp"
#include "sdpd/state/random.hpp"
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

/// Disorder may have led some of them through a wall.
void put_before_walls(System& system) {
  for (auto const& wall : system.walls)
    for (auto& q : system.particles.q)
      if (double const depth = -wall.distance(q, 0); depth > 0)
        component(q, wall.axis) += wall.upper ? -2 * depth : 2 * depth;
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

BodyForce in_units(BodyForce force, ReducedUnits const& units) {
  force.acceleration = force.acceleration / (units.velocity() / units.time());
  return force;
}

System empty_system(SimulationSettings const& s) {
  auto parts = std::visit([&](auto const& method) { return method.parts(s); }, s.method);
  return {.box = box_of(s),
          .species = s.reduced_species(),
          .thermodynamics = std::move(parts.thermodynamics),
          .kernel = parts.kernel,
          .self_density = parts.self_density,
          .potential = std::move(parts.potential),
          .law = std::move(parts.law),
          .conduction = std::move(parts.conduction),
          .neighbours = Neighbours(box_of(s), s.range(), skin_of(s), s.threads),
          .walls = make_walls(s.faces, box_of(s).edge, s.units()),
          .body_force = in_units(s.body_force, s.units()),
          .boltzmann = parts.boltzmann,
          .seed = s.seed,
          .threads = s.threads};
}

std::unique_ptr<System> build(SimulationSettings const& s) {
  auto system = std::make_unique<System>(empty_system(s));
  system->dt = s.dt;
  system->particles.resize(s.particle_count(), s.features());
  place_on_lattice(system->particles, s);
  if (!system->species.empty())
    system->species_of_id = draw_species(system->species, s.particle_count(), s.seed);
  system->label_particles();
  put_before_walls(*system);
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
