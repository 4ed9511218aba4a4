#include "workflows/sdpd/settings.hpp"
#include "fitting/model_file.hpp"
#include "sdpd/method/mean_field_viscosity.hpp"
#include "workflows/processors.hpp"
#include "workflows/sdpd/layout_of.hpp"
#include "workflows/sdpd/method_of.hpp"
#include "workflows/sdpd/piston_shock.hpp"
#include "workflows/sdpd/piston_table.hpp"
#include "workflows/text_file.hpp"
#include <algorithm>
#include <numbers>

namespace mesobridge::workflows {

namespace {

fitting::EosModel eos_model_of(Scene const& scene, std::string const& eos) {
  auto model = fitting::load_eos(eos, [](std::string const& file) { return read_text_file(file); });
  if (eos == "ideal-gas" && scene.fluid.m0)
    model.eos = fitting::IdealGas(*scene.fluid.m0);
  return model;
}

} // namespace

fitting::EosModel eos_model_of(Scene const& scene) {
  return eos_model_of(scene, scene.fluid.eos);
}

fitting::AnyEos product_of(Scene const& scene) {
  return eos_model_of(scene, scene.reaction.product.value()).eos;
}

fitting::AnyEos eos_of(Scene const& scene) {
  return eos_model_of(scene).eos;
}

namespace {

constexpr std::int64_t most_particles = 4'000'000'000; ///< ids and indices have 32 bits

} // namespace

std::array<std::uint32_t, 3> lattice_of(std::int64_t N) {
  require(N >= 1 && N <= most_particles, "particles.N", N, fmt::format("must be 1 ... {}", most_particles));
  std::array<std::int64_t, 3> best{1, 1, N};
  for (std::int64_t a = 1; a * a * a <= N; ++a)
    if (N % a == 0)
      for (std::int64_t b = a; b * b <= N / a; ++b)
        if ((N / a) % b == 0 && N / a / b - a < best[2] - best[0])
          best = {a, b, N / a / b};
  auto const side = std::llround(std::cbrt(static_cast<double>(N)));
  require(best[2] <= 3 * best[0], "particles.N", N,
          fmt::format("the initial lattice needs three similar factors, such as those of {} or {}",
                      side * side * side, side * side * (side + 1)));
  return {static_cast<std::uint32_t>(best[0]), static_cast<std::uint32_t>(best[1]),
          static_cast<std::uint32_t>(best[2])};
}

sdpd::Scheme scheme_of(Scene const& scene) {
  auto const& of = scene.scheme;
  return {.pairs = of.name,
          .verlet_steps = static_cast<std::uint32_t>(of.fluctuate_every),
          .splitting = of.splitting == "strang" ? sdpd::Splitting::strang : sdpd::Splitting::lie_trotter,
          .conservative = of.conservative,
          .keep_energy = of.energy == "kept"};
}

sdpd::DensityCorrection density_correction_of(Scene const& scene) {
  auto const& particles = scene.particles;
  if (particles.density_scale && particles.density_self)
    return {.scale = *particles.density_scale, .self = *particles.density_self};
  if (particles.density == "glass")
    return sdpd::glass_correction(particles.kernel, neighbours_of(particles.h_factor));
  return {};
}

int moving_axis(Scene const& scene) {
  auto const& box = scene.box;
  return box.moving ? box.moving->front() - 'x' : box.x == "walls" ? 0 : box.y == "walls" ? 1 : 2;
}

FlowAxes flow_axes(Scene const& scene) {
  auto const& box = scene.box;
  int const along = box.flow              ? box.flow->front() - 'x'
                    : box.x == "periodic" ? 0
                    : box.y == "periodic" ? 1
                                          : 2;
  if (scene.features().walls)
    return {along, moving_axis(scene)};
  return {along, along == 2 ? 0 : 2};
}

double neighbours_of(double h_factor) {
  return 4 * std::numbers::pi / 3 * std::pow(h_factor, 3);
}

namespace {

std::array<std::uint32_t, 3> particles_along_edges(Scene const& scene) {
  auto const& given = scene.box.lattice;
  if (given.empty())
    return scene.particles.N > 0 ? lattice_of(scene.particles.N) : std::array<std::uint32_t, 3>{1, 1, 1};
  return {static_cast<std::uint32_t>(given.at(0)), static_cast<std::uint32_t>(given.at(1)),
          static_cast<std::uint32_t>(given.at(2))};
}

/// The piston's ramp where the scene says nothing: 8 l/v_S, by the equation of state (sdpd/README.md, Eq.
/// (S43)).
double usual_ramp(sdpd::SimulationSettings const& settings, double velocity) {
  constexpr double spacings = 8;
  if (velocity <= 0)
    return 0;
  try {
    auto const shock = piston_shock(settings, velocity);
    return shock ? spacings * settings.spacing() * settings.units().length() / shock->v_S : 0;
  } catch (PhysicsError const& error) {
    throw InputError(
        fmt::format("box.piston = {:g}: {}; box.ramp has no default then: give it", velocity, error.what()));
  }
}

sdpd::Faces faces_of(Scene const& scene, sdpd::SimulationSettings const& settings) {
  auto const& box = scene.box;
  sdpd::Faces faces{};
  for (auto const& [axis, kind] : {std::pair(0u, box.x), {1u, box.y}, {2u, box.z}})
    for (auto& face : faces[axis])
      face.kind = kind == "walls"  ? sdpd::FaceKind::wall
                  : kind == "open" ? sdpd::FaceKind::open
                                   : sdpd::FaceKind::periodic;
  auto& [of_piston, of_slide] = faces[static_cast<std::size_t>(moving_axis(scene))];
  if (box.piston)
    of_piston.motion = {*box.piston, box.ramp ? *box.ramp : usual_ramp(settings, *box.piston), {}};
  else
    of_piston.motion = piston_table(scene);
  double const friction = box.slip != "none"  ? 1
                          : box.wall_friction ? *box.wall_friction
                                              : sdpd::usual_wall_friction(settings);
  if (box.slip == "none")
    for (auto& [lower, upper] : faces)
      for (auto* face : {&lower, &upper})
        if (face->kind == sdpd::FaceKind::wall) {
          face->friction = {.acts = true,
                            .temperature = box.wall_temperature.value_or(scene.fluid.T),
                            .strength = friction,
                            .bath = box.wall_heat == "bath"};
          if (face == &of_slide && box.slide) {
            component(face->friction.slide, flow_axes(scene).along) = *box.slide;
            face->friction.slide_ramp = box.slide_ramp.value_or(0);
          }
        }
  return faces;
}

sdpd::BodyForce body_force_of(Scene const& scene) {
  auto const [along, across] = flow_axes(scene);
  sdpd::BodyForce force{.acceleration = {}, .across = across, .waves = static_cast<int>(scene.box.waves)};
  component(force.acceleration, along) = scene.box.body_force.value_or(0);
  return force;
}

} // namespace

sdpd::SimulationSettings settings_of(Scene const& scene, int threads) {
  sdpd::SimulationSettings settings{
      .method = method_of(scene),
      .rho = scene.fluid.rho,
      .T = scene.fluid.T,
      .lattice = particles_along_edges(scene),
      .disorder = scene.particles.disorder,
      .melted = scene.particles.start == "melted",
      .noise = scene.noise(),
      .dt = scene.scheme.dt.value,
      .scheme = scheme_of(scene),
      .bath_rate = scene.run.thermostat == "langevin" ? scene.run.bath_rate : 0,
      .seed = static_cast<std::uint64_t>(scene.run.seed),
      .threads = threads,
  };
  if (!scene.scheme.dt.reduced)
    settings.dt /= settings.units().time();
  settings.faces = faces_of(scene, settings);
  if (has_layout(scene))
    lay_out(scene, settings);
  settings.body_force = body_force_of(scene);
  return settings;
}

std::int64_t particles_of(Scene const& scene) {
  return has_layout(scene) ? static_cast<std::int64_t>(settings_of(scene, 1).particle_count())
                           : scene.particles.N;
}

std::int64_t instants_every(Scene::Run const& run) {
  constexpr std::int64_t instants = 40;
  return run.instant_every > 0 ? run.instant_every : std::max<std::int64_t>(1, run.steps / instants);
}

std::int64_t film_every(Scene const& scene) {
  constexpr std::int64_t parts = 5;
  if (!scene.film.quantity)
    return 0;
  return scene.film.every > 0 ? scene.film.every : std::max<std::int64_t>(1, scene.run.steps / parts);
}

int available_threads() {
  return available_processors();
}

OutputUnits::OutputUnits(sdpd::ReducedUnits const& reduced, UnitSystem system)
    : time(reduced.time()), length(reduced.length()), velocity(reduced.velocity()), energy(reduced.energy()),
      specific_energy(reduced.specific_energy()), entropy(reduced.energy() / reduced.temperature),
      temperature(reduced.temperature), pressure(reduced.pressure()), density(reduced.density),
      momentum(reduced.mass() * reduced.velocity()) {
  if (system == UnitSystem::lj)
    return;
  entropy_key = "_J_K", time_key = "_s", length_key = "_m", velocity_key = "_m_s", energy_key = "_J",
  specific_energy_key = "_J_kg", temperature_key = "_K", pressure_key = "_Pa";
  density_key = "_kg_m3", momentum_key = "_kg_m_s";
}

std::pair<double, std::string> OutputUnits::of(Dimension dimension) const {
  struct Unit {
    Dimension dimension;
    double value;
    std::string const& key;
  };
  static std::string const none;
  for (auto const& unit :
       {Unit{Dimension::number, 1, none}, Unit{Dimension::time, time, time_key},
        Unit{Dimension::length, length, length_key}, Unit{Dimension::velocity, velocity, velocity_key},
        Unit{Dimension::momentum, momentum, momentum_key}, Unit{Dimension::energy, energy, energy_key},
        Unit{Dimension::density, density, density_key}, Unit{Dimension::entropy, entropy, entropy_key},
        Unit{Dimension::temperature, temperature, temperature_key},
        Unit{Dimension::pressure, pressure, pressure_key}})
    if (unit.dimension == dimension)
      return {unit.value, unit.key};
  throw std::logic_error("nothing that a run writes has this dimension");
}

} // namespace mesobridge::workflows
