#include "cg/estimate.hpp"
#include "pair_fluid_fixtures.hpp"
#include "sdpd/make_system.hpp"
#include "sdpd/scheme/list.hpp"
#include "sdpd/scheme/scheme.hpp"
#include "sdpd/system/system.hpp"
#include "sdpd/system/total_energy.hpp"
#include <gtest/gtest.h>
#include <numbers>

namespace mesobridge::sdpd {
namespace {

constexpr double gamma = 0.04, dt = 0.25, hot = 16, n = 3;
constexpr int steps = 80;

/// An ideal gas with friction (1 - r)^2 gamma, n particles of the mass 1 in a volume r_c^3, whose bath has
/// the temperature 1. They are so hot that two of them meet for about one step: what friction has done to a
/// pair is forgotten before the same two meet again.
SimulationSettings gas(std::string const& pairs, std::uint64_t seed) {
  auto settings = dpd_fluid(dt);
  settings.as<Dpd>().potential = NoPotential{}, settings.as<Dpd>().friction = PowerFriction(gamma, 0, 1, 2);
  settings.lattice = {12, 12, 12}, settings.disorder = 0.5, settings.seed = seed;
  settings.scheme.pairs = pairs;
  return settings;
}

double temperature(System const& system) {
  double twice_kinetic = 0;
  for (auto const& p : system.particles.p)
    twice_kinetic += norm2(p);
  return twice_kinetic / (3 * static_cast<double>(system.size() - 1));
}

/// The rate at which the temperature of one gas, which begins hot, goes to 1.
double measured_rate(std::string const& pairs, std::uint64_t seed) {
  auto const settings = gas(pairs, seed);
  auto const system = make_system(settings);
  for (auto& p : system->particles.p)
    p *= std::sqrt(hot);
  auto const flight = conservative_integrator("verlet").steps(dt);
  auto const whole = sub_steps(settings.scheme, *system, dt);
  for (int k = 0; k < 20; ++k) // away from the lattice
    step(*system, flight);
  EXPECT_NEAR(temperature(*system), hot, 1e-9);
  for (int k = 0; k < steps; ++k)
    step(*system, whole);
  return std::log((hot - 1) / (temperature(*system) - 1)) / (steps * dt);
}

/// (n/3) times the integral over space of chance(gamma w(r) dt)/(2 dt).
template <class Chance>
double rate(Chance const& chance) {
  constexpr int intervals = 1000;
  double integral = 0;
  for (int k = 0; k < intervals; ++k) {
    double const r = (k + 0.5) / intervals;
    integral += 4 * std::numbers::pi * r * r * chance(gamma * (1 - r) * (1 - r) * dt) / (2 * dt) / intervals;
  }
  return n / 3 * integral;
}

struct Case {
  std::string pairs;
  double expected;
};

class IdealGasInABath : public ::testing::TestWithParam<Case> {};

// The relative velocity of two particles along their line of centres has the variance 2 k_B T. Drawn anew, it
// brings them (k_B/2) (T_0 - T) in the mean; one of the n/2 pairs of a particle in each volume is drawn with
// the chance 1 - exp(-2 gamma w dt), and a particle has the energy 3/2 k_B T: the temperature relaxes at the
// rate (n/3) times the integral of gamma w. An exact step leaves exp(-4 gamma w dt) of T - T_0: twice the
// rate.
TEST_P(IdealGasInABath, ReachesItsTemperatureAtTheRateOfItsFriction) {
  std::vector<double> rates;
  for (std::uint64_t seed = 1; seed <= 24; ++seed)
    rates.push_back(measured_rate(GetParam().pairs, seed));
  auto const measured = cg::estimate_mean(rates);
  double const expected = GetParam().expected;
  RecordProperty("rate", std::to_string(measured.mean / expected) + " +- " +
                             std::to_string(measured.se / expected) + " of the expected one");
  EXPECT_LT(measured.se, 0.015 * expected);
  EXPECT_LT(std::abs(measured.mean - expected), 3.5 * measured.se);
  EXPECT_GT(std::abs(measured.mean - 1.1 * expected), 4 * measured.se); // 10 % off fails
}

INSTANTIATE_TEST_SUITE_P(
    Schemes, IdealGasInABath,
    ::testing::Values(Case{"lowe-andersen", rate([](double x) { return -std::expm1(-2 * x); })},
                      Case{"ssa", rate([](double x) { return -std::expm1(-4 * x); })}),
    [](auto const& info) { return info.param.pairs == "ssa" ? "Exact" : "LoweAndersen"; });

TEST(FrictionOfAnIdealGas, HasTheIntegralOfItsFrictionAsTheRateOfShortSteps) {
  EXPECT_NEAR(rate([](double x) { return 2 * x; }), gamma * 4 * std::numbers::pi / 30, 1e-6); // by hand
}

} // namespace
} // namespace mesobridge::sdpd
