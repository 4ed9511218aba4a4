#include "reactor.hpp"
#include "sdpd/kinetics/list.hpp"
#include <cmath>
#include <gtest/gtest.h>
#include <set>

namespace mesobridge::sdpd {
namespace {

// Pairs that burn: d lambda/dt = (1 - lambda)^2, ten steps of 0.1. That of euler stands in the design of the
// integrators; that of midpoint is ten lines by hand,
//     m = 1 - (1 - l) exp(-A h/2), A = 1 - m, l = 1 - (1 - l) exp(-A h), at first A = 1 - l;
// 0.499721 with A = 1 - l in every step.
TEST(Kinetics, OfSecondOrderFollowTheIntegratorsNumbers) {
  auto settings = uniform_reactor(0.1, 0);
  reaction_of(settings).integrator = RateIntegrator::euler;
  EXPECT_NEAR(progress_after(settings, 10), 0.508952, 1e-6);
  reaction_of(settings).integrator = RateIntegrator::midpoint;
  EXPECT_NEAR(progress_after(settings, 10), 0.499443, 1e-6);
}

TEST(Kinetics, ConvergeToTheExactSolutionWithTheirOrder) {
  auto const error = [](RateIntegrator integrator, int steps) {
    auto settings = uniform_reactor(2.0 / steps, 0.2);
    reaction_of(settings).integrator = integrator;
    return std::abs(progress_after(settings, steps) - (1 - 1 / (1 / 0.8 + 2)));
  };
  EXPECT_NEAR(error(RateIntegrator::euler, 20) / error(RateIntegrator::euler, 40), 2, 0.1);
  EXPECT_NEAR(error(RateIntegrator::midpoint, 20) / error(RateIntegrator::midpoint, 40), 4, 0.3);
}

// The thesis's weights leave out the particle itself: Sum W_ij = rho/rho_mean - W(0).
TEST(Kinetics, WithTheWeightsOfTheKernelLackTheParticleItself) {
  auto settings = uniform_reactor(0.001, 0);
  reaction_of(settings).kinetics = SecondOrder{{1 / settings.units().time(), 0}, {}};
  Simulation const simulation(settings);
  double const own =
      std::visit([](auto const& kernel) { return kernel.W(0.0); }, make_kernel("wendland-c4", 2.5));
  double const sum = simulation.snapshot().rho[0] - own;
  EXPECT_NEAR(progress_after(settings, 1000), 1 - 1 / (1 + sum), 1e-6);
}

// exact for any time step: d lambda/dt = K (1 - lambda) - K' lambda
TEST(Kinetics, OfFirstOrderAreExactAtAnyTimeStep) {
  for (double const dt : {0.01, 1.0, 30.0}) {
    auto settings = uniform_reactor(dt, 0.1);
    double const K = 1 / settings.units().time();
    reaction_of(settings).kinetics = FirstOrder{{K, 0}, {0.5 * K, 0}};
    double const steady = 2.0 / 3;
    EXPECT_NEAR(progress_after(settings, 2), steady + (0.1 - steady) * std::exp(-1.5 * 2 * dt), 1e-12) << dt;
  }
}

TEST(Kinetics, KeepTheProgressBetweenZeroAndOne) {
  int laws = 0;
  for (auto const weights : {NeighbourWeights::kernel, NeighbourWeights::normalised})
    for (double const back : {0.0, 3.0}) {
      auto settings = uniform_reactor(1e3, 0.4);
      double const K = 1 / settings.units().time();
      reaction_of(settings).kinetics = SecondOrder{{K, 0}, {back * K, 0}, weights};
      for (int const steps : {1, 2, 5}) {
        double const progress = progress_after(settings, steps);
        EXPECT_GE(progress, 0);
        EXPECT_LE(progress, 1);
        ++laws;
      }
    }
  EXPECT_EQ(laws, 12);
}

TEST(Kinetics, ByPressureAreTheFormula) {
  auto settings = uniform_reactor(0.1, 0);
  auto const units = settings.units();
  PressureBurn const law{.I = 2 / units.time(),
                         .a = 0.1,
                         .b = 0.5,
                         .x = 2,
                         .G = 3 / units.time(),
                         .P_ref = 2 * units.pressure(),
                         .c = 1.5,
                         .d = 0.25,
                         .y = 2};
  auto const rates = law.in_units(units).rates({.progress = 0.36, .T = 1, .P = 3, .rho = 1.4});
  EXPECT_NEAR(rates.forward * 0.64, 2 * 0.8 * 0.09 + 3 * 0.512 * std::pow(0.36, 0.25) * 2.25, 1e-12);
  EXPECT_EQ(rates.backward, 0);
  auto const in_tension = law.in_units(units).rates({.progress = 0.36, .T = 1, .P = -3, .rho = 1.05});
  EXPECT_EQ(in_tension.forward, 0);
  EXPECT_EQ(law.in_units(units).rates({.progress = 1, .T = 1, .P = 3, .rho = 1.4}).forward, 0);
}

// A front that passes lattice planes one after the other, whatever they are.
TEST(Kinetics, ThatArePrescribedFollowTheFront) {
  auto settings = uniform_reactor(0.1, 0);
  auto const units = settings.units();
  reaction_of(settings).kinetics =
      PrescribedBurn{2 * units.velocity(), 0.5 * units.length(), 2 * units.length()};
  Simulation simulation(settings);
  simulation.advance(10); // the front is at 0.5 + 2 and burns all before 0.5
  auto const now = simulation.snapshot();
  int burning = 0;
  for (std::size_t i = 0; i < now.q.size(); ++i) {
    double const expected = std::clamp((2.5 - now.q[i].z) / 2, 0.0, 1.0);
    EXPECT_NEAR(now.progress[i], expected, 1e-12);
    burning += expected > 0 && expected < 1;
  }
  EXPECT_EQ(burning, 36); // at 1.5
}

TEST(Kinetics, AreKnownByNamesOfTheirOwn) {
  std::set<std::string_view> names;
  for (auto const& law : kinetics()) {
    EXPECT_TRUE(names.insert(law.name).second) << law.name;
    EXPECT_EQ(&kinetics_named(law.name), &law);
    std::vector<double> const values(law.parameters.size(), 1.5);
    EXPECT_NO_THROW(law.make(values));
    for (std::size_t k = 0; k < values.size(); ++k)
      if (!law.parameters[k].range.contains(-1)) {
        auto wrong = values;
        wrong[k] = -1;
        EXPECT_THROW(law.make(wrong), InputError) << law.name << " " << law.parameters[k].name;
      }
  }
  EXPECT_EQ(names.size(), 6u);
  EXPECT_THROW(kinetics_named("third-order"), InputError);
}

} // namespace
} // namespace mesobridge::sdpd
