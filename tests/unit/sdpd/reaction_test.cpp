#include "fitting/eos/mixture.hpp"
#include "reactor.hpp"
#include "same_bits.hpp"
#include "sdpd/make_system.hpp"
#include "sdpd/reaction/reaction.hpp"
#include "sdpd/system/conservation.hpp"
#include "sdpd/system/sum_over_particles.hpp"
#include "sdpd/system/total_energy.hpp"
#include <cmath>
#include <gtest/gtest.h>

namespace mesobridge::sdpd {
namespace {

std::vector<double> state_of(Simulation const& simulation) {
  auto const now = simulation.snapshot();
  auto numbers = now.progress;
  for (auto const* more : {&now.eps, &now.T, &now.P, &now.rho})
    numbers.insert(numbers.end(), more->begin(), more->end());
  return flat(now.q, flat(now.p, numbers));
}

SimulationSettings burning(double progress = 0.3) {
  auto settings = burning_nitromethane(100, 0.02, progress);
  settings.lattice = {8, 8, 8};
  settings.disorder = 0.05;
  return settings;
}

TEST(Reaction, HasTheSameBitsOnAnyNumberOfThreadsAndAfterARestart) {
  for (char const* scheme : {"ssa", "ems"}) {
    auto settings = burning(0.02);
    settings.scheme.pairs = scheme;
    expect_same_bits(settings, 13, 17, state_of);
  }
  auto strang = burning(5e-5); // many become mixtures on the way
  strang.scheme.splitting = Splitting::strang;
  expect_same_bits(strang, 5, 9, state_of);
}

// The chemical energy goes to the internal energies, to round-off; nothing else changes.
TEST(Reaction, ConservesTheEnergyWithTheChemicalOne) {
  for (double const progress : {0.0, 0.3, 0.9}) {
    auto const system = make_system(burning(progress));
    double const before = total_energy(*system), chemical = chemical_energy(*system);
    auto const q = system->particles.q, p = system->particles.p;
    auto const sub_step = reaction(*system, 0.02);
    EXPECT_NO_THROW(run_and_check(sub_step, *system));
    EXPECT_LT(chemical_energy(*system), chemical);
    EXPECT_NEAR(total_energy(*system), before, 1e-13 * std::abs(before));
    for (std::size_t i = 0; i < q.size(); ++i)
      EXPECT_EQ(norm2(q[i] - system->particles.q[i]) + norm2(p[i] - system->particles.p[i]), 0);
  }
}

TEST(Reaction, KeepsEnergyAndMomentumOverARun) {
  Simulation simulation(burning());
  double const begin = simulation.observe().energy(), chemical = simulation.observe().chemical;
  simulation.advance(200);
  auto const now = simulation.observe();
  EXPECT_LT(now.chemical, 0.5 * chemical); // most of it has gone
  EXPECT_NEAR(now.energy(), begin, 2e-3 * chemical);
  EXPECT_LT(norm(now.momentum), 1e-11);
}

double total_entropy(System const& system) {
  return sum_over_particles(system, [&](std::size_t i) { return system.particles.S[i]; });
}

TEST(Reaction, ThatGoesOneWayRaisesTheEntropy) {
  auto const system = make_system(burning());
  auto const sub_step = reaction(*system, 0.01);
  double before = total_entropy(*system);
  for (int k = 0; k < 20; ++k) {
    sub_step.run(*system);
    Failure failure;
    system->thermodynamics->from_energy(system->particles, {0, system->size()}, failure);
    ASSERT_FALSE(failure.any());
    double const now = total_entropy(*system);
    EXPECT_GT(now, before);
    before = now;
  }
}

// At constant volume all of the heat goes to the products.
TEST(Reaction, EndsInTheStateOfItsProducts) {
  auto settings = uniform_reactor(20, 0);
  auto& reaction = reaction_of(settings);
  reaction.heat = 4.7159e6;
  reaction.kinetics = FirstOrder{{1e14, 3e-19}, {}};
  Simulation simulation(settings);
  auto const start = simulation.snapshot();
  double const energy = simulation.observe().energy();
  simulation.advance(40);
  auto const end = simulation.snapshot();
  auto const units = settings.units();
  fitting::Jwl const product(fitting::nitromethane_products_parameters);
  for (std::size_t i = 0; i < end.eps.size(); ++i) {
    EXPECT_EQ(end.progress[i], 1);
    double const e = start.eps[i] * units.specific_energy() + reaction.heat, rho = end.rho[i] * units.density;
    EXPECT_NEAR(end.eps[i] * units.specific_energy(), e, 1e-9 * e);
    EXPECT_NEAR(end.T[i] * units.temperature, product.temperature(e, rho), 1e-6);
    EXPECT_NEAR(end.P[i] * units.pressure(), product.pressure(e, rho), 1e3);
  }
  EXPECT_NEAR(simulation.observe().energy(), energy, 1e-12 * std::abs(energy));
  EXPECT_NEAR(simulation.observe().progress, 1, 1e-14);
  EXPECT_NEAR(simulation.observe().chemical, 0, 1e-12);
}

/// lambda after the time of an adiabatic reactor of constant volume that burns by the power of 1 - lambda, by
/// Runge and Kutta's fourth order.
double exact_progress(double rho, double e_0, double q, Arrhenius const& rate, double power, double time) {
  fitting::Mixture const mixture(fitting::Hz(fitting::nitromethane_parameters),
                                 fitting::Jwl(fitting::nitromethane_products_parameters));
  std::optional<fitting::MixtureSplit> guess;
  auto const slope = [&](double lambda) {
    auto const state = mixture.state(lambda, rho, e_0 + q * lambda, guess);
    guess = state.split;
    return rate(state.T) * std::pow(1 - lambda, power);
  };
  double lambda = 0.05;
  e_0 -= q * lambda;
  int const steps = 4000;
  for (int k = 0; k < steps; ++k) {
    double const h = time / steps, a = slope(lambda), b = slope(lambda + 0.5 * h * a),
                 c = slope(lambda + 0.5 * h * b), d = slope(lambda + h * c);
    lambda += h / 6 * (a + 2 * b + 2 * c + d);
  }
  return lambda;
}

/// Hot nitromethane that explodes within about 1800 reduced times, in one step of `time`, or several.
struct Explosion {
  SimulationSettings settings = uniform_reactor(1, 0.05);
  Arrhenius rate{30 / settings.units().time(), 3e-19 / k_B};
  double power, heat; ///< of 1 - lambda; of a kilogram

  explicit Explosion(bool of_pairs, double heat = 4.7159e6) : power(of_pairs ? 2 : 1), heat(heat) {
    settings.T = 1500;
    auto& reaction = reaction_of(settings);
    reaction.heat = heat;
    if (of_pairs)
      reaction.kinetics = SecondOrder{{rate.Z, 3e-19}, {}, NeighbourWeights::normalised};
    else
      reaction.kinetics = FirstOrder{{rate.Z, 3e-19}, {}};
  }
  double exact(double time) const {
    auto const units = settings.units();
    auto const start = Simulation(settings).snapshot();
    return exact_progress(start.rho[0] * units.density, start.eps[0] * units.specific_energy(), heat, rate,
                          power, time * units.time());
  }
  double progress(double time, int steps) {
    settings.dt = time / steps;
    return progress_after(settings, steps);
  }
};

// The heat of a thermal explosion drives its rate: a step that is too long for it is made in parts.
TEST(Reaction, FollowsAThermalExplosionInOneStep) {
  for (bool const of_pairs : {false, true})
    for (double const share : {0.3, 0.8, 1.0}) {
      Explosion explosion(of_pairs);
      double const time = share * 1800, exact = explosion.exact(time);
      EXPECT_NEAR(explosion.progress(time, 1), exact, 0.02 * exact) << of_pairs << " " << exact;
    }
}

// Pairs have their rates found once a part: what leads to its middle are those of the part before.
TEST(Reaction, OfPairsFollowsItsHeatToSecondOrder) {
  Explosion explosion(true, 1e6); // so little that no step has parts
  double const time = 1000, exact = explosion.exact(time);
  auto const error = [&](int steps) { return explosion.progress(time, steps) - exact; };
  double const coarse = error(20);
  EXPECT_GT(std::abs(coarse), 1e-5);
  EXPECT_NEAR(coarse / error(40), 4, 0.3) << exact << " " << coarse;
}

// Rates of the step before say nothing where a shock has come since.
TEST(Reaction, SeesThatAShockHasComeSinceTheLastStep) {
  Explosion cold(true);
  cold.settings.T = 700;
  auto const heated = [&](int cold_steps) {
    auto const system = make_system(cold.settings);
    auto const step = reaction(*system, 300);
    for (int k = 0; k < cold_steps; ++k)
      step.run(*system);
    EXPECT_LT(system->particles.progress[0], 0.0501);
    Failure failure;
    std::ranges::fill(system->particles.T, 2.5); // 1750 K
    system->thermodynamics->energy_from_temperature(system->particles, {0, system->size()}, failure);
    EXPECT_FALSE(failure.any());
    step.run(*system);
    return system->particles.progress[0];
  };
  double const without = heated(0), with = heated(2);
  EXPECT_GT(without, 0.1);
  EXPECT_NEAR(with, without, 0.02 * without);
}

// The images behind a wall react with the particles before it.
TEST(Reaction, IsTheSameBeforeAWall) {
  auto settings = uniform_reactor(0.1, 0);
  settings.faces = walls_along(2);
  EXPECT_NEAR(progress_after(settings, 10), 0.499443, 1e-6);
}

TEST(Reaction, WaitsWhileWallsAreHeld) {
  auto settings = uniform_reactor(0.1, 0.2);
  Simulation simulation(settings);
  simulation.hold_walls(true);
  simulation.advance(3);
  EXPECT_EQ(simulation.snapshot().progress[5], 0.2);
  simulation.hold_walls(false);
  simulation.advance(1);
  EXPECT_GT(simulation.snapshot().progress[5], 0.2);
}

// What does not burn is the reactant alone, within round-off.
TEST(Reaction, LeavesColdParticlesAsTheyAre) {
  auto cold = burning(0);
  cold.T = 400, cold.rho = 1200;
  auto plain = cold;
  plain.as<Sdpd>().reaction.reset();
  Simulation one(cold), other(plain);
  one.advance(10), other.advance(10);
  auto const a = one.snapshot(), b = other.snapshot();
  for (std::size_t i = 0; i < a.q.size(); ++i) {
    EXPECT_LT(norm(a.q[i] - b.q[i]), 1e-9);
    EXPECT_NEAR(a.T[i], b.T[i], 1e-8);
    EXPECT_LT(a.progress[i], 1e-12);
  }
}

TEST(Reaction, RefusesWhatMakesNoSense) {
  auto settings = burning();
  reaction_of(settings).progress = 1.5;
  EXPECT_THROW(Simulation{settings}, InputError);
  settings = burning();
  reaction_of(settings).heat = std::nan("");
  EXPECT_THROW(Simulation{settings}, InputError);
  settings = burning();
  settings.as<Sdpd>().species = {{"a", 0.5, 100, settings.as<Sdpd>().eos},
                                 {"b", 0.5, 100, settings.as<Sdpd>().eos}};
  EXPECT_THROW(Simulation{settings}, InputError);
  settings = burning();
  Simulation simulation(settings);
  auto checkpoint = simulation.checkpoint();
  checkpoint.particles.progress[2] = 1.5;
  EXPECT_THROW(simulation.restore(checkpoint), InputError);
  checkpoint = simulation.checkpoint();
  checkpoint.reaction.clear();
  EXPECT_THROW(simulation.restore(checkpoint), InputError);
}

} // namespace
} // namespace mesobridge::sdpd
