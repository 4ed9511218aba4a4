#include "md/metal.hpp"
#include "temporary_log.hpp"
#include <cmath>
#include <gtest/gtest.h>

namespace mesobridge::md::test {
namespace {

MetalSettings small_settings() {
  auto settings = metal_settings(Preset::quick, read_metal_potential("Cu_u3.eam", ""));
  settings.least_atoms = 108;
  settings.equilibration_steps = 300;
  settings.sampling_steps = 1000;
  settings.melt_steps = 500;
  settings.log_file = tests::temporary_log("metal");
  return settings;
}

class MetalTest : public ::testing::Test {
 protected:
  void TearDown() override { std::filesystem::remove(settings_.log_file); }
  std::optional<MetalEnd> run(MetalState state, std::vector<MetalSample>& samples) {
    return sample_metal(world_, state, settings_,
                        {.samples = [&](auto const& s) { return samples.push_back(s), true; }, .steps = {}});
  }
  MpiWorld world_;
  MetalSettings settings_ = small_settings();
};

double mean(std::vector<MetalSample> const& samples, double MetalSample::*member) {
  double sum = 0;
  for (auto const& sample : samples)
    sum += sample.*member;
  return sum / double(samples.size());
}

TEST_F(MetalTest, ACrystalStaysOneAndALiquidFlows) {
  std::vector<MetalSample> solid, liquid;
  MetalState const state{.rho = 8000, .T = 1400};
  auto const crystal = run(state, solid);
  settings_.start = MetalStart::liquid;
  auto const melt = run(state, liquid);
  ASSERT_TRUE(crystal && melt);
  ASSERT_EQ(solid.size(), 50u);
  EXPECT_EQ(solid.back().step, 1000);
  EXPECT_GT(crystal->lattice_order, 0.5);
  EXPECT_LT(melt->lattice_order, 0.3);
  double const d = CrystalBlock(Lattice::fcc, 1).neighbour_distance(state.rho / settings_.potential.mass);
  EXPECT_LT(solid.back().displacement_2, 0.15 * d * d);
  EXPECT_GT(liquid.back().displacement_2, 0.5 * d * d);
  EXPECT_GT(mean(liquid, &MetalSample::e),
            mean(solid, &MetalSample::e) + 5e4); // copper's heat of fusion is 2.05e5 J/kg
  EXPECT_NEAR(mean(solid, &MetalSample::T), 1400, 60);
  EXPECT_NEAR(mean(liquid, &MetalSample::T), 1400, 60);
}

TEST_F(MetalTest, AColdCrystalIsHarmonic) {
  // Equipartition: 3 k_B T of vibrations for each atom above the crystal at rest, which anharmonicity hardly
  // changes at 60 K.
  MetalCrystal crystal(world_, settings_.potential, Lattice::fcc, settings_.log_file);
  double const rho = crystal.at_zero_pressure().rho, T = 60;
  std::vector<MetalSample> samples;
  ASSERT_TRUE(run({.rho = rho, .T = T}, samples));
  double const thermal = 3 * 1.380649e-23 * T / settings_.potential.mass;
  EXPECT_NEAR(mean(samples, &MetalSample::e) / thermal, 1, 0.06);
  EXPECT_NEAR(mean(samples, &MetalSample::T) / T, 1, 0.06);
  // Debye's model, classical: <u^2> = 9 hbar^2 T/(m k_B Theta^2), Theta = 343 K in copper. A small box lacks
  // long waves; its centre of mass, which the thermostat moves by several times as much, is left out.
  double const hbar = 1.054571817e-34,
               u_2 = 9 * hbar * hbar * T / (settings_.potential.mass * 1.380649e-23 * 343 * 343);
  EXPECT_NEAR(mean(samples, &MetalSample::displacement_2) / u_2, 1, 0.4);
}

TEST_F(MetalTest, TheSeedDecidesTheRunAndConsumersStopIt) {
  auto const first_energy = [&](std::uint64_t seed) {
    settings_.seed = seed;
    double e = 0;
    EXPECT_FALSE(sample_metal(world_, {9000, 500}, settings_,
                              {.samples = [&](auto const& s) { return e = s.e, false; }, .steps = {}}));
    return e;
  };
  double const one = first_energy(1);
  EXPECT_EQ(first_energy(1), one);
  EXPECT_NE(first_energy(2), one);
  int calls = 0;
  EXPECT_FALSE(sample_metal(world_, {9000, 500}, settings_,
                            {.samples = {}, .steps = [&](std::int64_t) { return ++calls < 3; }}));
  EXPECT_EQ(calls, 3);
}

TEST_F(MetalTest, WhatCannotBeSampledIsAPhysicsError) {
  settings_.start = MetalStart::liquid;
  settings_.melt_steps = 1;
  std::vector<MetalSample> samples;
  EXPECT_THROW(run({9000, 300}, samples), PhysicsError) << "a crystal that does not melt";
  settings_ = small_settings();
  settings_.least_atoms = 256;
  settings_.reduced_time_step = 0.1;
  try {
    run({17000, 1e5}, samples);
    FAIL() << "atoms that fly apart";
  } catch (PhysicsError const& error) {
    std::string const text = error.what();
    for (char const* part : {"Cu at 17000 kg/m^3, 100000 K", "unstable", "Lost atoms", "--time-step"})
      EXPECT_NE(text.find(part), std::string::npos) << text;
  }
}

TEST_F(MetalTest, RefusesBadInputBeforeAnyRun) {
  int cases = 0;
  MetalState const state{.rho = 9000, .T = 300};
  auto const refuses = [&](MetalState s, auto change) {
    auto settings = small_settings();
    change(settings);
    EXPECT_THROW(check(s, settings), InputError) << cases;
    ++cases;
  };
  refuses({.rho = 4000, .T = 300}, [](auto&) {});
  refuses({.rho = 18000, .T = 300}, [](auto&) {});
  refuses({.rho = std::nan(""), .T = 300}, [](auto&) {});
  refuses({.rho = 9000, .T = 0}, [](auto&) {});
  refuses(state, [](auto& s) { s.least_atoms = 32; }); // a box narrower than two cut-offs
  refuses(state, [](auto& s) { s.reduced_time_step = 0.2; });
  refuses(state, [](auto& s) { s.friction_steps = 1; });
  refuses(state, [](auto& s) { s.sampling_steps = 5; });
  refuses(state, [](auto& s) { s.sample_every = 0; });
  EXPECT_EQ(cases, 9);
  EXPECT_NO_THROW(check(state, small_settings()));
}

} // namespace
} // namespace mesobridge::md::test
