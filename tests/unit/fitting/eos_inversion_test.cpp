#include "fitting/eos/evaluate.hpp"
#include "unit/fitting/random_states.hpp"
#include <functional>
#include <gtest/gtest.h>
#include <limits>

namespace mesobridge::fitting::test {
namespace {

constexpr int states = 2500, many_states = 1000000;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

template <class E>
void check_inversions(E const& eos, int states, std::vector<double> const& guesses_in_T) {
  std::mt19937_64 generator(2);
  double worst_T = 0, worst_guess = 0, worst_e = 0;
  int cases = 0, guesses = 0;
  double const k_m = eos.boltzmann() / eos.molecular_mass();
  for (; cases < states; ++cases) {
    auto const [rho, T] = random_state(eos, generator);
    auto const isochore = eos.isochore(rho);
    double const e = isochore.energy(T), s = isochore.entropy(T);
    worst_T = std::max(worst_T, std::abs(eos.temperature(e, rho) / T - 1));
    worst_e = std::max(worst_e, discrepancy(eos.energy_from_entropy(s, rho), e, k_m * T));
    for (double factor : guesses_in_T) {
      double const guess = factor * T;
      worst_guess = std::max(worst_guess, std::abs(isochore.temperature_from_energy(e, guess) / T - 1));
      worst_guess = std::max(worst_guess, std::abs(isochore.temperature_from_entropy(s, guess) / T - 1));
      ++guesses;
    }
  }
  std::printf("%d states, %d guesses; largest relative error: T(e) %.1e, e(s) %.1e, with bad guesses %.1e\n",
              cases, guesses, worst_T, worst_e, worst_guess);
  EXPECT_EQ(cases, states);
  EXPECT_EQ(guesses, int(guesses_in_T.size()) * states);
  EXPECT_LT(worst_T, 1e-10);
  EXPECT_LT(worst_e, 1e-10);
  EXPECT_LT(worst_guess, 1e-10);
}

/// Calls f(model) for every built-in material's.
template <class F>
void for_each_model(F const& f) {
  int models = 0;
  for (auto const& material : materials()) {
    SCOPED_TRACE(material.name);
    std::visit(f, material.eos);
    ++models;
  }
  EXPECT_GE(models, 9);
}

void return_in_every_model(int states, std::vector<double> const& guesses_in_T) {
  int models = 0;
  for (auto const& material : materials()) {
    SCOPED_TRACE(material.name);
    std::printf("%-21s ", material.name.c_str());
    std::visit([&](auto const& eos) { check_inversions(eos, states, guesses_in_T); }, material.eos);
    ++models;
  }
  EXPECT_GE(models, 9);
}

TEST(EosInversion, ReturnsTheStateInEveryModelFromAnyGuess) {
  return_in_every_model(states, {1, 0.999, 1.3, 1e-6, 1e6, 1e-300, -1, 0, nan});
}

TEST(Long_EosInversion, ReturnsTheStateInEveryModel) {
  return_in_every_model(many_states, {1.3});
}

TEST(EosInversion, RefusesStatesWithoutATemperature) {
  for_each_model([](auto const& eos) {
    double const rho = std::isfinite(eos.domain().rho_max) ? 0.5 * eos.domain().rho_max : 1000;
    double const k_m = eos.boltzmann() / eos.molecular_mass();
    EXPECT_THROW(eos.temperature(nan, rho), PhysicsError);
    EXPECT_THROW(eos.temperature(-1e6 * k_m * 1000, rho), PhysicsError);
    EXPECT_THROW(eos.energy_from_entropy(nan, rho), PhysicsError);
    EXPECT_THROW(eos.energy_from_entropy(1e6 * k_m, rho), PhysicsError);
    EXPECT_THROW(eos.energy_from_temperature(0, rho), PhysicsError);
    EXPECT_THROW(eos.energy_from_temperature(nan, rho), PhysicsError);
    for (double bad : {0.0, -1.0, nan, std::numeric_limits<double>::infinity()})
      EXPECT_THROW(eos.isochore(bad), PhysicsError);
  });
}

/// Whether f throws a PhysicsError that says both words.
bool refuses(std::function<void()> const& f, std::string const& word, std::string const& value) {
  try {
    f();
  } catch (PhysicsError const& error) {
    std::string const what = error.what();
    return what.find(word) != std::string::npos && what.find(value) != std::string::npos;
  }
  return false;
}

template <class E>
int refused_calls(E const& eos) {
  double const rho = std::isfinite(eos.domain().rho_max) ? 0.5 * eos.domain().rho_max : 1000;
  int refused = 0;
  for (auto const &call : std::vector<std::function<void(double, double)>>{
           [&](double a, double r) { eos.temperature(a, r); }, [&](double a, double r) { eos.entropy(a, r); },
           [&](double a, double r) { eos.pressure(a, r); },
           [&](double a, double r) { eos.heat_capacity(a, r); },
           [&](double a, double r) { eos.sound_speed(a, r); },
           [&](double a, double r) { eos.energy_from_entropy(a, r); }}) {
    refused += refuses([&] { call(1, -2.5); }, "density", "-2.5");
    refused += refuses([&] { call(nan, rho); }, "density", "nan");
  }
  refused += refuses([&] { eos.energy_from_temperature(1, -2.5); }, "density", "-2.5");
  refused += refuses([&] { eos.energy_from_temperature(-3.5, rho); }, "temperature", "-3.5");
  return refused;
}

TEST(EosInversion, EveryCallOutsideTheDomainIsRefusedByName) {
  for_each_model([](auto const& eos) { EXPECT_EQ(refused_calls(eos), 14); });
}

TEST(EosInversion, TheRefusalNamesTheState) {
  auto const& argon = std::get<LjBwr>(material("argon").eos);
  double const coldest = argon.energy_from_temperature(1e-9, 1150);
  EXPECT_NEAR(argon.temperature(coldest + 300, 1150) * argon.heat_capacity(coldest + 300, 1150), 300, 1e-5);
  try {
    argon.temperature(coldest - 300, 1150);
    FAIL() << "no exception";
  } catch (PhysicsError const& error) {
    std::string const what = error.what();
    EXPECT_NE(what.find("density 1150"), std::string::npos) << what;
    EXPECT_NE(what.find("energy -"), std::string::npos) << what;
    EXPECT_NE(what.find("below that of T = 0"), std::string::npos) << what;
  }
  EXPECT_THROW(argon.isochore(1.31 * argon_units.density()), PhysicsError);
  EXPECT_THROW(argon.energy_from_temperature(101 * argon_units.temperature(), 1150), PhysicsError);
  EXPECT_THROW(argon.temperature(argon.energy_from_temperature(12000, 1150) * 1.1, 1150), PhysicsError);
}

TEST(Evaluate, TheThreeWaysToAStateAgree) {
  for_each_model([](auto const& eos) {
    bool const reduced = eos.boltzmann() == 1;
    double const rho = reduced ? 0.7 : 1150, T = reduced ? 6 : 800;
    auto const from_T = state_from_temperature(eos, rho, T);
    auto const from_e = state_from_energy(eos, rho, from_T.e);
    auto const from_s = state_from_entropy(eos, rho, from_T.s);
    for (auto const& state : {from_e, from_s}) {
      EXPECT_NEAR(state.T / T, 1, 1e-12);
      EXPECT_NEAR(state.P / from_T.P, 1, 1e-12);
      EXPECT_NEAR(*state.sound_speed / *from_T.sound_speed, 1, 1e-12);
    }
    EXPECT_NEAR(*from_T.sound_speed / eos.sound_speed(from_T.e, rho), 1, 1e-12);
    EXPECT_NEAR(from_T.P / eos.pressure(from_T.e, rho), 1, 1e-12);
    EXPECT_NEAR(from_T.s / eos.entropy(from_T.e, rho), 1, 1e-12);
    EXPECT_NEAR(from_T.c_v / eos.heat_capacity(from_T.e, rho), 1, 1e-12);
    // Grueneisen by a difference of energies at constant density
    double const de = 1e-5 * from_T.c_v * T;
    double const slope = (eos.pressure(from_T.e + de, rho) - eos.pressure(from_T.e - de, rho)) / (2 * de);
    EXPECT_NEAR(from_T.gruneisen / (slope / rho), 1, 1e-8);
  });
}

} // namespace
} // namespace mesobridge::fitting::test
