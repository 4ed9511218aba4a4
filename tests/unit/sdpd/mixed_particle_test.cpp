#include "sdpd/thermodynamics/reacting.hpp"
#include "sdpd_fixtures.hpp"
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace mesobridge::sdpd {
namespace {

ReactingModels const models{fitting::material("nitromethane").eos,
                            fitting::material("nitromethane-products").eos};

ReducedUnits units(double K = 100) {
  return burning_nitromethane(K, 0.01).units();
}

struct State {
  double lambda, rho, e, T, P, C; ///< SI
};
// Solved for this test by a code of its own.
State const states[] = {{0.3, 1700, 3.0e6, 3001.025732, 11.9003922e9, 1677.060},
                        {0.9, 1500, 6.0e6, 4732.394922, 12.8834850e9, 2609.000}};

TEST(MixedParticle, HasTheStatesOfTheMixture) {
  auto const of = units();
  MixedParticle const mixed(models, of, CentreOfMass::bulk);
  for (auto const& [lambda, rho, e, T, P, C] : states) {
    auto const state =
        mixed.from_energy(lambda, rho / of.density, e / of.specific_energy(), {T * 0.98 / of.temperature, 0});
    auto const response = mixed.response(lambda, rho / of.density, state.split);
    EXPECT_NEAR(state.split.T * of.temperature, T, 1e-5);
    EXPECT_NEAR(response.P * of.pressure(), P, 1e2);
    EXPECT_NEAR(of.specific_entropy() / response.caloric.inverse_C_0, C, 2e-3);
  }
}

class EveryCentreOfMass : public ::testing::TestWithParam<CentreOfMass> {};
INSTANTIATE_TEST_SUITE_P(MixedParticle, EveryCentreOfMass,
                         ::testing::Values(CentreOfMass::free, CentreOfMass::bulk));

// T, P and C are the slopes of the entropy, of small particles whose centre of mass matters, too.
TEST_P(EveryCentreOfMass, IsWhatItsEntropySays) {
  auto const of = units(5);
  MixedParticle const mixed(models, of, GetParam());
  for (double const lambda : {0.01, 0.3, 0.9, 0.999}) {
    double const rho = 1.02, h = 1e-4;
    double const eps = mixed.energy_from_temperature(lambda, rho, 1.1);
    auto const at = [&](double d_eps, double d_rho) {
      return mixed.from_energy(lambda, rho * (1 + d_rho), eps * (1 + d_eps), {1.1, 0});
    };
    auto const state = at(0, 0);
    auto const response = mixed.response(lambda, rho, state.split);
    EXPECT_NEAR(state.split.T, 1.1, 1e-9);
    double const T = 2 * h * eps / (at(h, 0).S - at(-h, 0).S);
    EXPECT_NEAR(T, 1.1, 1e-6) << lambda;
    EXPECT_NEAR(-rho * T * (at(0, h).S - at(0, -h).S) / (2 * h), response.P, 1e-5 * response.P) << lambda;
    double const C = 2 * h * eps / (at(h, 0).split.T - at(-h, 0).split.T);
    EXPECT_NEAR(1 / response.caloric.inverse_C_0, C, 1e-6 * C) << lambda;
    double const u = 0.02 * C; // the expansion is of second order
    EXPECT_NEAR(response.caloric.T(u), at(u / eps, 0).split.T, 1e-5) << lambda;
  }
}

TEST_P(EveryCentreOfMass, IsFoundAgainByItsEntropy) {
  auto const of = units(20);
  MixedParticle const mixed(models, of, GetParam());
  for (double const lambda : {1e-4, 0.5, 1 - 1e-6}) {
    double const eps = mixed.energy_from_temperature(lambda, 1, 1.3);
    auto const state = mixed.from_energy(lambda, 1, eps, {1.2, 0});
    auto const again = mixed.from_entropy(lambda, 1, state.S, {1.28, state.split.log_density_ratio});
    EXPECT_NEAR(again.eps, eps, 1e-11 * std::abs(eps)) << lambda;
    EXPECT_EQ(again.S, state.S);
    EXPECT_NEAR(again.split.T, 1.3, 1e-10) << lambda;
  }
}

// Near both ends the mixture is what the pure component is, but for a jump.
TEST_P(EveryCentreOfMass, GoesOverIntoThePureParticles) {
  auto const of = units(20);
  MixedParticle const mixed(models, of, GetParam());
  auto const reacting = make_reacting_thermodynamics(models, of, GetParam());
  for (double const end : {0.0, 1.0}) {
    Particles particles;
    particles.resize(2, {.reacts = true});
    particles.progress = {end, end == 0 ? pure_below : pure_above};
    particles.rho = {1, 1}, particles.T = {1.2, 1.2};
    particles.log_density_ratio = {0, 0}, particles.id = {0, 1};
    Failure failure;
    reacting->energy_from_temperature(particles, {0, 1}, failure);
    particles.eps[1] = particles.eps[0];
    reacting->from_energy(particles, {0, 2}, failure);
    ASSERT_FALSE(failure.any()) << failure.message();
    EXPECT_NEAR(particles.T[0], 1.2, 1e-12);
    EXPECT_NEAR(particles.T[1], particles.T[0], 1e-3);
    EXPECT_NE(particles.T[1], particles.T[0]);
    EXPECT_NEAR(particles.P[1], particles.P[0], 1e-3 * particles.P[0]);
    EXPECT_NEAR(particles.caloric[1].inverse_C_0 / particles.caloric[0].inverse_C_0, 1, 2e-3);
  }
}

// Pure particles and mixtures of every progress, whole packs of them and what is left over.
TEST_P(EveryCentreOfMass, HasTheSameTemperatureWithoutPressures) {
  auto const of = units(20);
  auto const reacting = make_reacting_thermodynamics(models, of, GetParam());
  constexpr std::size_t count = 61;
  Particles whole;
  whole.resize(count, {.reacts = true});
  for (std::size_t i = 0; i < count; ++i) {
    whole.id[i] = static_cast<std::uint32_t>(i);
    whole.progress[i] = i < 20 ? 0 : i < 50 ? 0.03 * static_cast<double>(i - 19) : 1;
    whole.rho[i] = 0.9 + 0.003 * static_cast<double>(i), whole.T[i] = 1.2, whole.log_density_ratio[i] = 0;
  }
  Failure failure;
  reacting->energy_from_temperature(whole, {0, count}, failure);
  std::ranges::fill(whole.T, 1.1);
  auto alone = whole;
  reacting->from_energy(whole, {0, count}, failure);
  reacting->temperature_from_energy(alone, {0, count}, failure);
  ASSERT_FALSE(failure.any()) << failure.message();
  for (std::size_t i = 0; i < count; ++i) {
    EXPECT_NEAR(whole.T[i], 1.2, 1e-9) << i;
    EXPECT_EQ(alone.T[i], whole.T[i]) << i;
    EXPECT_EQ(alone.S[i], whole.S[i]) << i;
    EXPECT_EQ(alone.log_density_ratio[i], whole.log_density_ratio[i]) << i;
    EXPECT_EQ(alone.P[i], 0) << i;
  }
}

TEST(MixedParticle, IsRefusedWhereThereIsNone) {
  auto const of = units();
  auto const reacting = make_reacting_thermodynamics(models, of, CentreOfMass::free);
  Particles particles;
  particles.resize(2, {.reacts = true});
  particles.id = {7, 3}, particles.progress = {0.5, 0.5}, particles.rho = {0.1, 1}, particles.T = {1, 1};
  particles.eps = {10, 10};
  Failure failure;
  reacting->from_energy(particles, {0, 2}, failure);
  ASSERT_TRUE(failure.any());
  EXPECT_EQ(failure.id(), 7u); // half burnt and thin
  EXPECT_NE(failure.message().find("mixture of progress"), std::string::npos) << failure.message();
  EXPECT_THROW(
      make_reacting_thermodynamics({fitting::material("argon").eos, models.product}, of, CentreOfMass::free),
      InputError);
}

} // namespace
} // namespace mesobridge::sdpd
