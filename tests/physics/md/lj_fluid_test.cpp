#include "md/lj_fluid.hpp"
#include "temporary_log.hpp"
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace mesobridge::md::test {
namespace {

LjFluidSettings small_settings() {
  return {.atoms = 108, .cutoff = 2.5, .sampling_steps = 400, .log_file = tests::temporary_log("fluid")};
}

class LjFluidTest : public ::testing::Test {
 protected:
  void TearDown() override { std::filesystem::remove(settings_.log_file); }
  bool run(LjState state, LjFluidConsumers const& consumers) {
    return sample_lj_fluid(world_, Ranks::own, state, settings_, consumers);
  }
  MpiWorld world_;
  LjFluidSettings settings_ = small_settings();
};

TEST_F(LjFluidTest, DeliversSamplesAndFramesWhileItRuns) {
  std::vector<ThermoSample> samples;
  std::vector<Frame> frames;
  std::int64_t steps = 0;
  EXPECT_TRUE(run({0.6, 4.0}, {.thermo = [&](auto const& s) { return samples.push_back(s), true; },
                               .frames = [&](auto const& f) { return frames.push_back(f), true; },
                               .frame_every = 100,
                               .steps = [&](std::int64_t done) { return steps = done, true; }}));
  EXPECT_EQ(steps, settings_.steps());
  ASSERT_EQ(samples.size(), 40u);
  ASSERT_EQ(frames.size(), 4u);
  EXPECT_EQ(samples.front().step, 10);
  EXPECT_EQ(samples.back().step, 400);
  // The kinetic temperature of the sample, 2K/(3N), and its energy against the frame of the same step. The
  // thermostat's velocities are those of half a step before.
  auto const& frame = frames.back();
  double potential = 0;
  for (std::size_t i = 0; i < 108; ++i)
    for (std::size_t j = i + 1; j < 108; ++j)
      if (double const r2 = norm2(frame.box.minimum_image(frame.positions[i] - frame.positions[j]));
          r2 < 6.25)
        potential += 4 * (std::pow(r2, -6) - std::pow(r2, -3));
  double const r3 = std::pow(2.5, -3), tail = 8.0 / 3 * std::numbers::pi * 0.6 * (r3 * r3 * r3 / 3 - r3);
  EXPECT_NEAR(samples.back().U - 1.5 * samples.back().T, potential / 108 + tail, 1e-9);
  double mean_T = 0;
  for (auto const& sample : samples)
    mean_T += sample.T / 40;
  EXPECT_NEAR(mean_T, 4.0,
              0.4); // a temperature with 3N - 3 in place of 3N, or a cold start, is the physics tests' to see
}

TEST_F(LjFluidTest, AnyConsumerStopsItAtOnce) {
  int samples = 0, frames = 0, steps = 0;
  EXPECT_FALSE(
      run({0.6, 4.0}, {.thermo = [&](auto const&) { return ++samples < 3; }, .frames = {}, .steps = {}}));
  EXPECT_EQ(samples, 3);
  EXPECT_FALSE(run(
      {0.6, 4.0},
      {.thermo = {}, .frames = [&](auto const&) { return ++frames < 1; }, .frame_every = 10, .steps = {}}));
  EXPECT_EQ(frames, 1);
  EXPECT_FALSE(
      run({0.6, 4.0}, {.thermo = {}, .frames = {}, .steps = [&](std::int64_t) { return ++steps < 2; }}));
  EXPECT_EQ(steps, 2);
}

TEST_F(LjFluidTest, TheSeedDecidesTheRun) {
  auto const first_energy = [&](std::uint64_t seed) {
    settings_.seed = seed;
    double U = 0;
    run({0.6, 4.0}, {.thermo = [&](auto const& s) { return U = s.U, false; }, .frames = {}, .steps = {}});
    return U;
  };
  double const one = first_energy(1);
  EXPECT_EQ(first_energy(1), one);
  EXPECT_NE(first_energy(2), one);
}

TEST_F(LjFluidTest, ACrystalThatDoesNotMeltIsAPhysicsError) {
  settings_.melt_steps = 1;
  settings_.equilibration_steps = 200;
  EXPECT_THROW(run({1.3, 1.0}, {}), InputError) << "the box is too small for the cut-off";
  settings_.atoms = 256;
  EXPECT_THROW(run({1.3, 1.0}, {}), PhysicsError);
}

TEST(LatticeOrder, IsOneInTheCrystalAndSmallInAGas) {
  Frame crystal{.step = 0, .box = {{4, 4, 4}}, .positions = {}, .velocities = {}, .types = {}};
  for (int x = 0; x < 8; ++x)
    for (int y = 0; y < 8; ++y)
      for (int z = 0; z < 8; ++z)
        if ((x + y + z) % 2 == 0)
          crystal.positions.push_back(Vec3{x + 0.3, y + 0.1, z + 0.2} *
                                      0.5); // fcc of constant 1, off the origin
  EXPECT_NEAR(lattice_order(crystal, 1.0), 1.0, 1e-12);
  for (std::size_t k = 0; k < crystal.positions.size(); ++k) // low-discrepancy points instead of a lattice
    crystal.positions[k] = {4 * std::fmod(0.8191725 * double(k), 1.0),
                            4 * std::fmod(0.6710436 * double(k), 1.0),
                            4 * std::fmod(0.5497005 * double(k), 1.0)};
  EXPECT_LT(lattice_order(crystal, 1.0), 0.2);
}

} // namespace
} // namespace mesobridge::md::test
