#include "sdpd/observe/health.hpp"
#include <algorithm>
#include <gtest/gtest.h>
#include <random>

namespace mesobridge::sdpd {
namespace {

/// A run of which everything is known: series with memory about means that may drift, reduced units.
struct Story {
  double T_kin = 1, T_int = 1, P = 10, rho = 1, pairing = 0;     ///< means
  double rise_T = 0, rise_P = 0, rise_rho = 0, rise_pairing = 0; ///< from the first sample to the last
  double crystal = 0;
  double energy_per_time = 0;
  std::size_t samples = 400;
};

HealthConditions const ordinary{.thermal_energy = 3000, .thermal_pressure = 1};

/// A series of noise that forgets itself within about ten samples.
class Noise {
 public:
  Noise(double sigma, unsigned seed) : random_(seed), gauss_(0, sigma * std::sqrt(1 - 0.9 * 0.9)) {}
  double next() { return value_ = 0.9 * value_ + gauss_(random_); }

 private:
  std::mt19937_64 random_;
  std::normal_distribution<double> gauss_;
  double value_ = 0;
};

/// `more`: adds to the errors of the temperatures what their samples do not know.
std::vector<Finding> findings(Story const& story, unsigned seed,
                              HealthConditions const& conditions = ordinary, double more = 0) {
  EquilibriumSampler sampler;
  Noise T_kin(0.025, seed), T_int(0.003, seed + 1000), P(0.05, seed + 2000), rho(0.002, seed + 3000);
  for (std::size_t k = 0; k < story.samples; ++k) {
    double const x = static_cast<double>(k) / static_cast<double>(story.samples - 1), rise = story.rise_T * x;
    sampler.sample(static_cast<double>(k), 5000 + story.energy_per_time * static_cast<double>(k),
                   story.T_kin + rise + T_kin.next(), story.T_int + rise + T_int.next(),
                   story.P + story.rise_P * x + P.next());
    if (k % 10 == 0)
      sampler.sample(InstantMoments{.rho_mean = story.rho + story.rise_rho * x + rho.next(),
                                    .pairing = story.pairing + story.rise_pairing * x,
                                    .crystal = story.crystal});
  }
  auto means = sampler.result();
  for (auto* const T : {&means.T_kin, &means.T_int})
    T->se = std::hypot(T->se, more);
  return examine(sampler, means, conditions);
}

std::vector<std::string> names(std::vector<Finding> const& findings) {
  std::vector<std::string> all;
  for (auto const& finding : findings)
    all.push_back(finding.name);
  return all;
}

bool has(std::vector<Finding> const& findings, std::string const& name) {
  return std::ranges::find(findings, name, &Finding::name) != findings.end();
}

TEST(Health, FindsNothingAgainstGoodRuns) {
  int runs = 0, good = 0;
  for (unsigned seed = 1; seed <= 200; ++seed, ++runs)
    good += findings({}, seed).empty();
  EXPECT_EQ(runs, 200);
  EXPECT_EQ(good, 200);
}

TEST(Health, CallsTheBiasOfATimeStepNoFault) {
  int runs = 0;
  for (unsigned seed = 1; seed <= 50; ++seed, ++runs)
    EXPECT_TRUE(
        findings({.T_kin = 1.015, .pairing = 0.005, .rise_pairing = 0.002, .crystal = 0.05}, seed).empty())
        << seed;
  EXPECT_EQ(runs, 50);
}

// The errors are the summary's. What the time step has added to the energy is in them and excuses nothing.
TEST(Health, QuotesTheErrorsOfTheSummary) {
  Story const warm{.T_kin = 1.05, .T_int = 1.05};
  int runs = 0;
  for (unsigned seed = 1; seed <= 5; ++seed, ++runs) {
    EXPECT_FALSE(has(findings(warm, seed, ordinary, 0.02), "temperature_of_T_int")) << seed; // set so
    auto conditions = ordinary;
    conditions.gained_temperature = 0.02;
    auto const all = findings(warm, seed, conditions, 0.02);
    ASSERT_TRUE(has(all, "temperature_of_T_int")) << seed;
    auto const text = std::ranges::find(all, "temperature_of_T_int", &Finding::name)->text;
    EXPECT_NE(text.find("(standard error 2"), std::string::npos) << text;
    EXPECT_NE(text.find("% without the energy that the time step has added)"), std::string::npos) << text;
  }
  EXPECT_EQ(runs, 5);
}

TEST(Health, FindsWhatIsWrongAndNothingElse) {
  struct Case {
    Story story;
    std::string name;
    bool spoils;
    std::size_t others; ///< findings that the same fault brings with it, at most
  };
  std::vector<Case> const cases{
      {{.T_kin = 1.77, .T_int = 1.0}, "equipartition", true, 1},
      {{.T_kin = 1.06, .T_int = 1.0, .samples = 1600}, "equipartition", false, 1},
      {{.T_kin = 0.9, .T_int = 1.02}, "equipartition", true, 1},
      {{.T_kin = 1.3, .T_int = 1.3}, "temperature_of_T_kin", true, 1},
      {{.T_kin = 1.3, .T_int = 1.3}, "temperature_of_T_int", true, 1},
      {{.T_kin = 1.05, .T_int = 1.05}, "temperature_of_T_int", false, 1},
      {{.rise_T = 0.08}, "trend_of_T_int", false, 3},
      {{.rise_P = 0.6}, "trend_of_P", false, 0},
      {{.rise_P = -0.6}, "trend_of_P", false, 0},
      {{.rise_rho = -0.02, .samples = 1600}, "trend_of_rho", false, 0},
      {{.pairing = 0.03, .rise_pairing = 0.33}, "pairing", false, 0},
      {{.rise_pairing = 0.014}, "pairing", false, 0}, // 0.7 % on average, more in the end
      {{.crystal = 0.5}, "crystal", false, 0},
      {{.energy_per_time = 0.4}, "energy_drift", false, 0}, // 160 of 3000
      {{.energy_per_time = -2}, "energy_drift", true, 0},
  };
  std::size_t ran = 0;
  for (auto const& [story, name, spoils, others] : cases)
    for (unsigned seed = 1; seed <= 5; ++seed, ++ran) {
      SCOPED_TRACE(name + ", seed " + std::to_string(seed));
      auto const all = findings(story, seed);
      ASSERT_TRUE(has(all, name)) << ::testing::PrintToString(names(all));
      EXPECT_EQ(std::ranges::find(all, name, &Finding::name)->spoils, spoils);
      EXPECT_LE(all.size(), 1 + others) << ::testing::PrintToString(names(all));
    }
  EXPECT_EQ(ran, 5 * 15u);
}

TEST(Health, AsksOnlyWhatTheRunCanAnswer) {
  // Without noise there is no temperature of the motion; with a thermostat no energy that is kept.
  EXPECT_TRUE(findings({.T_kin = 0}, 1, {.has_motion = false, .thermal_energy = 3000, .thermal_pressure = 1})
                  .empty());
  EXPECT_TRUE(findings({.energy_per_time = 5}, 1, {.keeps_energy = false, .thermal_pressure = 1}).empty());
  // What was never brought to equilibrium is what the scene asked for.
  auto const fresh = findings({.T_kin = 1.77}, 1, {.was_equilibrated = false, .thermal_energy = 3000});
  ASSERT_TRUE(has(fresh, "equipartition"));
  EXPECT_FALSE(fresh.front().spoils);
  // A pressure near zero does not drift by any share of itself.
  EXPECT_TRUE(findings({.P = 0.01, .rise_P = 0.02}, 1).empty());
}

TEST(Health, ComparesChancesWithTheirErrors) {
  int runs = 0, alarms = 0; // short runs, whose means are uncertain by several per cent
  for (unsigned seed = 1; seed <= 200; ++seed, ++runs)
    alarms += !findings({.samples = 200}, seed).empty();
  EXPECT_EQ(runs, 200);
  EXPECT_LE(alarms, 1);
}

TEST(Trend, FindsAKnownRiseWithinItsErrors) {
  int covered = 0, refuted = 0, runs = 0;
  for (unsigned seed = 1; seed <= 200; ++seed, ++runs) {
    Noise noise(0.1, seed);
    std::vector<double> series;
    for (int k = 0; k < 1000; ++k)
      series.push_back(3 + 0.2 * k / 999.0 + noise.next());
    auto const [change, se] = trend(series);
    covered += std::abs(change - 0.2) < 2 * se;
    refuted += std::abs(change - 0.5) > 2 * se;
  }
  EXPECT_EQ(runs, 200);
  EXPECT_GE(covered, 180);
  EXPECT_GE(refuted, 198);
}

TEST(Trend, OfALineIsExact) {
  std::vector<double> series;
  for (int k = 0; k < 20; ++k)
    series.push_back(1 + 0.5 * k);
  auto const [change, se] = trend(series);
  EXPECT_NEAR(change, 9.5, 1e-12);
  EXPECT_NEAR(se, 0, 1e-12);
  EXPECT_THROW(trend(std::span(series).first(15)), std::exception);
}

} // namespace
} // namespace mesobridge::sdpd
