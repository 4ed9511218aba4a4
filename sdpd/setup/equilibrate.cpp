#include "md/error.hpp"
#include "sdpd/observe/runaway.hpp"
#include "sdpd/observe/set_energy.hpp"
#include "sdpd/setup/equilibration.hpp"
#include <array>
#include <cmath>

namespace mesobridge::sdpd {
namespace {

constexpr double last_share = last_share_of_equilibration;
constexpr std::array<double, 6> shares{0.03125, 0.03125, 0.0625, 0.125, 0.25, last_share};

} // namespace

Equilibration::Equilibration(Simulation& simulation, std::uint64_t steps,
                             EquilibrationProgress const& progress)
    : simulation_(simulation), steps_(steps), progress_(progress) {
  simulation_.hold_walls(!is_done());
}

/// The run that the next step belongs to; a thermostat needs only one.
Equilibration::Part Equilibration::part() const {
  if (simulation_.has_thermostat())
    return {0, steps_, last_share};
  Part part{0, 0, 0};
  double share_done = 0;
  for (double const share : shares) {
    share_done += share;
    part = {part.end, static_cast<std::uint64_t>(share_done * static_cast<double>(steps_)), share};
    if (progress_.done < part.end)
      break;
  }
  return part;
}

void Equilibration::advance() {
  auto const now = part();
  simulation_.advance(1);
  bool const in_bath = !simulation_.has_thermostat() && simulation_.bath_rate() > 0 && now.share < last_share;
  if (in_bath)
    simulation_.couple_to_bath();
  else
    observe(now);
  ++progress_.done;
  if (progress_.done < now.end)
    return;
  if (!in_bath && !simulation_.has_thermostat())
    finish(now);
  progress_.sum_T_kin = progress_.sum_T_int = 0;
  simulation_.hold_walls(!is_done());
}

/// Kinetic energy that the settling structure sets free is taken out on the way, but for the last run: a
/// structure of large particles falls from one arrangement to the next, and each fall is worth many of their
/// k_B T.
void Equilibration::observe(Part const& part) {
  constexpr double too_hot = 1.2;
  constexpr std::uint64_t quench_every = 8;
  Observation const now = simulation_.observe();
  if (part.share < last_share && (progress_.done - part.begin) % quench_every == 0 && now.T_kin > too_hot)
    simulation_.scale_momenta(1 / std::sqrt(now.T_kin));
  progress_.sum_T_kin += now.T_kin, progress_.sum_T_int += now.T_int;
}

void Equilibration::finish(Part const& part) {
  auto const length = static_cast<double>(part.end - part.begin);
  double const T_kin = progress_.sum_T_kin / length, T_int = progress_.sum_T_int / length;
  if (!simulation_.has_noise()) { // nothing but heat is there to be set
    simulation_.heat(1 - T_int);
    return;
  }
  if (!(T_kin < absurd_temperature(simulation_.units().K)))
    throw PhysicsError(
        fmt::format("step {}: while the system came to equilibrium, the kinetic temperature has "
                    "grown to {:.3g} times the set one: the motion is unstable; take a shorter "
                    "time step or, for large particles of SDPD, which a lattice heats as it falls apart, "
                    "particles.start = \"melted\"",
                    simulation_.step(), T_kin));
  // Weighted with the heat capacities, most of the exchange between the two kinds of energy, which makes
  // each temperature fluctuate, cancels.
  double const kinetic_share =
      1.5 * (static_cast<double>(simulation_.size()) - 1) / simulation_.heat_capacity();
  double const missing = 1 - kinetic_share * T_kin - (1 - kinetic_share) * T_int;
  simulation_.heat(missing / (1 - kinetic_share));
  // Large particles exchange their little kinetic energy slowly; it is brought to the set temperature
  // directly while the disorder of the start decays.
  if (part.share < last_share)
    simulation_.scale_momenta(1 / std::sqrt(T_kin));
  // While the structure settles, densities change at constant entropies and leave every particle with a
  // temperature of its own, which large particles would keep for very long.
  if (part.share < 0.25)
    simulation_.draw_temperatures();
}

void equilibrate(Simulation& simulation, std::uint64_t steps, std::function<bool()> const& keep_going) {
  constexpr std::uint64_t steps_between_questions = 32;
  Equilibration equilibration(simulation, steps);
  while (!equilibration.is_done()) {
    equilibration.advance();
    if (equilibration.progress().done % steps_between_questions == 1 && !keep_going())
      throw Interrupted("stopped while the system came to equilibrium");
  }
}

} // namespace mesobridge::sdpd
