#include "sdpd/make_system.hpp"
#include "sdpd/conservative/refresh.hpp"
#include "sdpd/conservative/relaxation.hpp"
#include "sdpd/method/settings.hpp"
#include "sdpd/start/place.hpp"
#include "sdpd/state/random.hpp"
#include <algorithm>

namespace mesobridge::sdpd {
namespace {

/// Standard deviation of the displacements, in spacings, that leaves exp(-(2 pi 0.6)^2) = 7e-7 of a lattice's
/// peaks: less than S = 1 up to a million particles.
constexpr double melting_disorder = 0.6;

/// Positions on a simple cubic lattice whose spacing is the mean distance between particles, with Gaussian
/// displacements, ids in its order.
void place_on_lattice(Particles& particles, SimulationSettings const& settings) {
  double const disorder = settings.melted ? melting_disorder : settings.disorder;
  NoiseSource const source(settings.seed, Stream::initial_positions, 0);
  double const spacing = settings.spacing();
  auto const [n_x, n_y, n_z] = settings.lattice;
  std::uint32_t id = 0;
  for (std::uint32_t z = 0; z < n_z; ++z)
    for (std::uint32_t y = 0; y < n_y; ++y)
      for (std::uint32_t x = 0; x < n_x; ++x, ++id) {
        auto const G = gaussians_reference(source, id, 0);
        particles.id[id] = id;
        particles.q[id] = spacing * (Vec3{x + 0.5, y + 0.5, z + 0.5} + disorder * Vec3{G[0], G[1], G[2]});
      }
}

/// Disorder may have led some of them through a wall.
void put_before_walls(System& system) {
  for (auto const& wall : system.walls)
    for (auto& q : system.particles.q)
      if (double const depth = -wall.distance(q, 0); depth > 0)
        component(q, wall.axis) += wall.upper ? -2 * depth : 2 * depth;
}

BodyForce in_units(BodyForce force, ReducedUnits const& units) {
  force.acceleration = force.acceleration / (units.velocity() / units.time());
  return force;
}

System empty_system(SimulationSettings const& s) {
  auto walls = make_walls(s.faces, box_of(s).edge, s.units());
  auto corners = make_corners(walls);
  auto parts = std::visit([&](auto const& method) { return method.parts(s); }, s.method);
  return {.box = box_of(s),
          .species = s.reduced_species(),
          .thermodynamics = std::move(parts.thermodynamics),
          .kernel = parts.kernel,
          .self_density = parts.self_density,
          .density_sum = parts.density_sum,
          .potential = std::move(parts.potential),
          .law = std::move(parts.law),
          .conduction = std::move(parts.conduction),
          .neighbours = Neighbours(box_of(s), s.range(), skin_of(s), s.threads, open_axes(s.faces)),
          .walls = std::move(walls),
          .corners = std::move(corners),
          .body_force = in_units(s.body_force, s.units()),
          .reaction = std::move(parts.reaction),
          .particles = {},
          .boltzmann = parts.boltzmann,
          .seed = s.seed,
          .threads = s.threads};
}

/// One fluid at rest on a lattice; of several species, which are where the seed draws them.
void fill(System& system, SimulationSettings const& s) {
  auto& particles = system.particles;
  place_on_lattice(particles, s);
  if (!system.species.empty())
    system.species_of_id = draw_species(system.species, s.particle_count(), s.seed);
  system.label_particles();
  std::fill(particles.T.begin(), particles.T.end(), 1.0);
  if (system.reaction)
    std::fill(particles.progress.begin(), particles.progress.end(), s.as<Sdpd>().reaction->progress);
  put_before_walls(system);
  if (s.melted)
    relax(system);
  if (s.noise)
    draw_momenta(particles, {}, system.boltzmann, s.seed);
}

std::vector<double> temperatures_of(Layout const& layout) {
  std::vector<double> T;
  for (auto const& region : layout.regions())
    T.push_back(region.T);
  return T;
}

/// The regions of a layout.
void fill(System& system, SimulationSettings const& s, Layout const& layout) {
  auto& particles = system.particles;
  auto const regions = place(particles, layout, s.disorder, s.seed);
  if (!system.species.empty())
    for (auto const region : regions)
      system.species_of_id.push_back(layout.regions()[region].species);
  system.label_particles();
  if (system.reaction)
    for (std::size_t i = 0; i < regions.size(); ++i)
      particles.progress[i] = layout.regions()[regions[i]].progress;
  let_flow(particles, layout, regions);
  put_before_walls(system);
  if (s.noise)
    draw_momenta(particles, {regions, temperatures_of(layout)}, system.boltzmann, s.seed);
}

std::unique_ptr<System> build(SimulationSettings const& s) {
  auto system = std::make_unique<System>(empty_system(s));
  system->dt = s.dt;
  system->particles.resize(s.particle_count(), s.features());
  if (s.layout)
    fill(*system, s, *s.layout);
  else
    fill(*system, s);
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
