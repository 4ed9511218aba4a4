#include "sdpd/boundary/wall_friction.hpp"
#include <optional>

namespace mesobridge::sdpd {
namespace {

/// The exact Ornstein-Uhlenbeck step at a frozen temperature, of the three components.
struct RubbingStep {
  std::array<double, 3> decay{}, variance{}; ///< exp(-Gamma dt/m) - 1; of the noise
};

RubbingStep step_at(System const& system, Wall const& wall, std::size_t k, double dt, double T) {
  double const m = system.particles.mass_of(wall.layer.particles[k]);
  auto const weights = wall_weights(system, wall, k, T);
  RubbingStep step;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    bool const normal = static_cast<int>(axis) == wall.axis;
    double const decay = std::expm1(-dt / m * (normal ? weights.normal : weights.along));
    step.decay[axis] = decay;
    step.variance[axis] = noise_boltzmann(system) * T / m * -decay * (2 + decay);
  }
  return step;
}

/// Of the step back from `after` to `before` against the one there, with the change of the invariant measure
/// (Eq. (S57)).
double log_acceptance(System const& system, RubbingStep const& there, RubbingStep const& back,
                      Vec3 const& before, Vec3 const& after, std::array<double, 3> const& G,
                      ThermalState const& now, ThermalState const& then) {
  double a = (then.S - now.S) / noise_boltzmann(system);
  if (std::visit([](auto const& law) { return law.measure_over_T; }, system.law))
    a -= std::log(then.T / now.T);
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (back.variance[axis] > 0 && there.variance[axis] > 0) {
      int const at = static_cast<int>(axis);
      double const rest = component(before, at) - (1 + back.decay[axis]) * component(after, at);
      a += 0.5 * (G[axis] * G[axis] - rest * rest / back.variance[axis] +
                  std::log(there.variance[axis] / back.variance[axis]));
    }
  return a;
}

/// Nothing where the equation of state has no such state.
std::optional<ThermalState> state_at(System const& system, Index i, double eps) {
  try {
    auto const state = system.thermodynamics->state(system.particles, i, eps);
    return state.T > 0 ? std::optional(state) : std::nullopt;
  } catch (PhysicsError const&) {
    return std::nullopt;
  }
}

/// In (0, 1), of the particle and the wall.
double uniform_number(NoiseSource const& source, std::uint32_t id, Wall const& wall) {
  auto const word =
      Philox4x32::generate({id, wall.number, source.step_low, source.step_high_and_stream}, source.key)[0];
  return (word + 0.5) / 4294967296.0;
}

} // namespace

[[gnu::noinline]] GivenByWall rub_without_bath(System& system, Wall const& wall, std::size_t k, double dt,
                                               NoiseSource const& of_friction,
                                               NoiseSource const& of_acceptance) {
  auto& particles = system.particles;
  Index const i = wall.layer.particles[k];
  auto const now = state_at(system, i, particles.eps[i]);
  if (!now)
    return {}; // the temperatures that follow say what is wrong
  double const m = particles.mass_of(i);
  auto const there = step_at(system, wall, k, dt, now->T);
  Vec3 const of_wall = wall_velocity(system, wall), before = particles.p[i] / m - of_wall;
  auto const G = gaussians_reference(of_friction, particles.id[i], wall.number);
  Vec3 change;
  for (int axis = 0; axis < 3; ++axis) {
    auto const at = static_cast<std::size_t>(axis);
    component(change, axis) =
        there.decay[at] * component(before, axis) + std::sqrt(there.variance[at]) * G[at];
  }
  Vec3 const after = before + change;
  double const heat = -0.5 * m * dot(change, before + after);
  auto const then = state_at(system, i, particles.eps[i] + heat);
  if (!then)
    return {};
  if (noise_boltzmann(system) > 0) {
    auto const back = step_at(system, wall, k, dt, then->T);
    double const a = log_acceptance(system, there, back, before, after, G, *now, *then);
    if (!(std::log(uniform_number(of_acceptance, particles.id[i], wall)) < a))
      return {};
  }
  Vec3 const impulse = m * change;
  particles.p[i] += impulse, particles.eps[i] += heat;
  return {impulse, dot(impulse, of_wall), 0};
}

} // namespace mesobridge::sdpd
