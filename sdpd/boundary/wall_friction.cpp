#include "sdpd/boundary/wall_friction.hpp"
#include "sdpd/boundary/mirror.hpp"
#include <algorithm>

namespace mesobridge::sdpd {
namespace {

/// The weight that a law of friction or conduction gives the particles i and j at a distance.
template <class Law>
PairWeights<double> weight_of(Law const& law, System const& system, Index i, Index j, double distance) {
  if constexpr (requires { law.shape; })
    return std::visit([&](auto const& shape) { return shape(distance); }, law.shape);
  else {
    auto const& of = system.particles;
    double const F =
        std::visit([&](auto const& kernel) { return kernel.F(distance, 1 / distance); }, system.kernel);
    return {of.mass_of(i) * of.mass_of(j) * F / (of.rho[i] * of.rho[j]), 0};
  }
}

/// What is left of a friction coefficient between a particle at the wall's temperature and the wall.
template <class Law>
double gamma_over_a(Law const& law, double T) {
  if constexpr (requires { law.template bath<double>(); })
    return law.template bath<double>().gamma_over_a;
  else
    return law.bath(PairTemperatures<double>{T, T, 0, 0}).gamma_over_a;
}

/// Of both directions by one law (Eq. (S50)).
template <class Law>
WallWeights friction_weights(Law const& law, System const& system, Wall const& wall, std::size_t k) {
  Index const i = wall.layer.particles[k];
  double const distance = wall.distance(system.particles.q[i], system.wall_time),
               scale = wall.friction.strength * gamma_over_a(law, wall.friction.temperature);
  WallWeights sum;
  wall.layer.for_each_image(k, [&](Index j, Vec3 const& r) {
    double const both = std::abs(component(r, wall.axis)), apart = norm(r);
    if (!(both > 0))
      return; // it sits on the wall
    auto const [par, perp] = law.coefficients(weight_of(law, system, i, j, apart));
    double const across = both * both / (apart * apart), factor = scale * both / distance;
    sum.normal += factor * (par * across + perp * (1 - across));
    sum.along += factor * 0.5 * (par * (1 - across) + perp * (1 + across));
  });
  return sum;
}

template <class Law>
double heat_weight(Law const& law, System const& system, Wall const& wall, std::size_t k) {
  Index const i = wall.layer.particles[k];
  double const distance = wall.distance(system.particles.q[i], system.wall_time);
  double sum = 0;
  wall.layer.for_each_image(k, [&](Index j, Vec3 const& r) {
    if (double const both = std::abs(component(r, wall.axis)); both > 0)
      sum += weight_of(law, system, i, j, norm(r)).par * both / distance;
  });
  return sum;
}

/// Adds up in the order of the layer what f(k) says of its k-th particle.
template <class F>
void give(System const& system, Wall& wall, F const& f) {
  thread_local std::vector<GivenByWall> of_caller; // kept so that no step allocates
  auto& given = of_caller;                         // the same for all threads of the loop below
  given.resize(wall.layer.particles.size());
  for_each_index(given.size(), threads_for(system, wall.layer), [&](std::size_t k) { given[k] = f(k); });
  for (auto const& [impulse, work, heat] : given)
    wall.drag += impulse, wall.work += work, wall.heat += heat;
}

Vec3 gaussian_vector(NoiseSource const& source, std::uint32_t id, Wall const& wall) {
  auto const [x, y, z] = gaussians_reference(source, id, wall.number);
  return {x, y, z};
}

bool has_bath(Wall const& wall) {
  return wall.friction.bath;
}

/// The exact Ornstein-Uhlenbeck step of a velocity about the wall's (Eq. (S51)). Compiled once, so that it
/// has the same bits on one thread and on several.
[[gnu::noinline]] GivenByWall rub(System& system, Wall const& wall, std::size_t k, double dt,
                                  NoiseSource const& source) {
  auto& particles = system.particles;
  Index const i = wall.layer.particles[k];
  auto const weights = wall_weights(system, wall, k);
  double const m = particles.mass_of(i), thermal = noise_boltzmann(system) * wall.friction.temperature / m;
  Vec3 const of_wall = wall_velocity(system, wall), before = particles.p[i] / m - of_wall,
             G = gaussian_vector(source, particles.id[i], wall);
  Vec3 after = before;
  for (int axis = 0; axis < 3; ++axis) {
    double const decay = std::expm1(-dt / m * (axis == wall.axis ? weights.normal : weights.along));
    component(after, axis) +=
        decay * component(before, axis) + std::sqrt(thermal * -decay * (2 + decay)) * component(G, axis);
  }
  Vec3 const impulse = m * (after - before);
  particles.p[i] += impulse;
  return {impulse, dot(impulse, of_wall), 0.5 * m * (norm2(after) - norm2(before))};
}

/// Takes the heat u, unless there is no such state.
double take_heat(System& system, Index i, double u) {
  auto& particles = system.particles;
  auto const& caloric = particles.caloric[i];
  try {
    double const T = caloric.in_reach(u) ? caloric.T(u)
                                         : system.thermodynamics->state(particles, i, particles.eps[i] + u).T;
    if (!(T > 0))
      return 0;
    particles.eps[i] += u, particles.T[i] = T;
    return u;
  } catch (PhysicsError const&) {
    return 0;
  }
}

/// The step of conduction at frozen heat capacity and noise, with the wall as a particle of infinite heat
/// capacity (Eq. (S53)).
template <class Law>
[[gnu::noinline]] GivenByWall warm(System& system, Law const& law, Wall const& wall, std::size_t k, double dt,
                                   NoiseSource const& source) {
  auto const& particles = system.particles;
  Index const i = wall.layer.particles[k];
  PairTemperatures<double> const at{particles.T[i], wall.friction.temperature,
                                    particles.caloric[i].inverse_C_0, 0};
  auto const [mean, variance] = law.step(heat_weight(law, system, wall, k), dt, at, at.T_i - at.T_j);
  double const u = mean + std::sqrt(variance) * gaussian_vector(source, particles.id[i], wall).x;
  return {{}, 0, take_heat(system, i, u)};
}

void warm(System& system, Wall& wall, double dt, NoiseSource const& source) {
  std::visit(
      [&](auto const& law) {
        if constexpr (requires { law.boltzmann; })
          give(system, wall, [&](std::size_t k) { return warm(system, law, wall, k, dt, source); });
      },
      system.conduction);
}

} // namespace

bool has_rough_walls(System const& system) {
  return std::ranges::any_of(system.walls, [](Wall const& wall) { return wall.friction.acts; });
}

double noise_boltzmann(System const& system) {
  return std::visit([](auto const& law) { return law.boltzmann; }, system.law);
}

Vec3 wall_velocity(System const& system, Wall const& wall) {
  Vec3 velocity = system.walls_held ? Vec3{} : wall.friction.slide_at(system.wall_time);
  component(velocity, wall.axis) = system.walls_held ? 0 : wall.motion.velocity_at(system.wall_time);
  return velocity;
}

WallWeights wall_weights(System const& system, Wall const& wall, std::size_t k) {
  return std::visit([&](auto const& law) { return friction_weights(law, system, wall, k); }, system.law);
}

WallWeights wall_weights(System const& system, Wall const& wall, std::size_t k, double T) {
  auto const [normal, along] = wall_weights(system, wall, k);
  double const of_T = std::visit(
      [&](auto const& law) { return gamma_over_a(law, T) / gamma_over_a(law, wall.friction.temperature); },
      system.law);
  return {of_T * normal, of_T * along};
}

SubStep wall_friction(System const& system, double dt, bool second) {
  using enum Conserved;
  bool const conducts = !std::holds_alternative<std::monostate>(system.conduction);
  bool const all_baths = std::ranges::all_of(system.walls, has_bath);
  SubStep step{.name = "friction and heat of the walls",
               .conserves = {positions, momentum, energy},
               .noise = {wall_friction_noise.of(second)},
               .run = {}};
  if (conducts || !all_baths) // there the noise of conduction serves for acceptance
    step.noise.push_back(wall_heat_noise.of(second));
  else
    step.conserves.insert(step.conserves.end(), {internal_energies, entropies});
  step.run = [=](System& on) {
    NoiseSource const of_friction(on.seed, wall_friction_noise.of(second), on.step),
        of_heat(on.seed, wall_heat_noise.of(second), on.step);
    for (auto& wall : on.walls)
      if (wall.friction.acts && wall.friction.bath) {
        give(on, wall, [&](std::size_t k) { return rub(on, wall, k, dt, of_friction); });
        if (conducts)
          warm(on, wall, dt, of_heat);
      } else if (wall.friction.acts)
        give(on, wall,
             [&](std::size_t k) { return rub_without_bath(on, wall, k, dt, of_friction, of_heat); });
  };
  return step;
}

} // namespace mesobridge::sdpd
