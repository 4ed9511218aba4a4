#include "md/error.hpp"
#include "sdpd/simulation.hpp"
#include <array>
#include <cmath>

namespace mesobridge::sdpd {
namespace {

struct MeanTemperatures {
  double T_kin = 0, T_int = 0;
};

void stop_if_asked(std::uint64_t step, std::function<bool()> const& keep_going) {
  if (step % 32 == 0 && !keep_going())
    throw Interrupted("stopped while the system came to equilibrium");
}

void run_in_bath(Simulation& simulation, std::uint64_t steps, std::function<bool()> const& keep_going) {
  for (std::uint64_t k = 0; k < steps; ++k) {
    simulation.advance(1);
    simulation.couple_to_bath();
    stop_if_asked(k, keep_going);
  }
}

/// With `quench`, kinetic energy that the settling structure sets free is taken out on the way: a structure
/// of large particles falls from one arrangement to the next, and each fall is worth many of their k_B T.
MeanTemperatures run_and_average(Simulation& simulation, std::uint64_t steps, bool quench,
                                 std::function<bool()> const& keep_going) {
  constexpr double too_hot = 1.2;
  constexpr std::uint64_t quench_every = 8;
  MeanTemperatures sum;
  for (std::uint64_t k = 0; k < steps; ++k) {
    simulation.advance(1);
    Observation const now = simulation.observe();
    if (quench && k % quench_every == 0 && now.T_kin > too_hot)
      simulation.scale_momenta(1 / std::sqrt(now.T_kin));
    sum.T_kin += now.T_kin, sum.T_int += now.T_int;
    stop_if_asked(k, keep_going);
  }
  return {sum.T_kin / static_cast<double>(steps), sum.T_int / static_cast<double>(steps)};
}

} // namespace

void equilibrate(Simulation& simulation, std::uint64_t steps, std::function<bool()> const& keep_going) {
  if (simulation.has_thermostat()) {
    if (steps > 0)
      run_and_average(simulation, steps, false, keep_going);
    return;
  }
  // Runs of 1/32, 1/32, 1/16, 1/8, 1/4 and 1/2 of the steps.
  std::array<double, 6> const shares{0.03125, 0.03125, 0.0625, 0.125, 0.25, 0.5};
  std::uint64_t done = 0;
  double share_done = 0;
  for (double const share : shares) {
    share_done += share;
    auto const end = static_cast<std::uint64_t>(share_done * static_cast<double>(steps));
    if (end == done)
      continue;
    if (simulation.bath_rate() > 0 && share < 0.5) {
      run_in_bath(simulation, end - done, keep_going);
      done = end;
      continue;
    }
    auto const mean = run_and_average(simulation, end - done, share < 0.5, keep_going);
    done = end;
    if (!simulation.has_noise()) { // nothing but heat is there to be set
      simulation.heat(1 - mean.T_int);
      continue;
    }
    // Weighted with the heat capacities, most of the exchange between the two kinds of energy, which makes
    // each temperature fluctuate, cancels.
    double const kinetic_share =
        1.5 * (static_cast<double>(simulation.size()) - 1) / simulation.heat_capacity();
    double const missing = 1 - kinetic_share * mean.T_kin - (1 - kinetic_share) * mean.T_int;
    simulation.heat(missing / (1 - kinetic_share));
    // Large particles exchange their little kinetic energy slowly; it is brought to the set temperature
    // directly while the disorder of the start decays.
    if (share < 0.5)
      simulation.scale_momenta(1 / std::sqrt(mean.T_kin));
    // While the structure settles, densities change at constant entropies and leave every particle with a
    // temperature of its own, which large particles would keep for very long.
    if (share < 0.25)
      simulation.draw_temperatures();
  }
}

} // namespace mesobridge::sdpd
