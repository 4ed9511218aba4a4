#include "md/error.hpp"
#include "pair_fluid_fixtures.hpp"
#include "sdpd/method/settings.hpp"
#include "sdpd/observe/equilibrium.hpp"
#include "sdpd/observe/profile.hpp"
#include "sdpd_fixtures.hpp"
#include <gtest/gtest.h>
#include <numbers>

namespace mesobridge::sdpd {
namespace {

Simulation after(SimulationSettings settings, std::uint64_t steps) {
  settings.lattice = {6, 6, 24};
  settings.disorder = 0.1;
  Simulation simulation(settings);
  simulation.advance(steps);
  return simulation;
}

/// Mean over the slices, each counted as often as it has particles.
double mean_over_particles(Profile const& of, std::vector<double> const& values) {
  double sum = 0, count = 0;
  for (std::size_t s = 0; s < values.size(); ++s)
    sum += static_cast<double>(of.number[s]) * values[s], count += static_cast<double>(of.number[s]);
  return sum / count;
}

/// What the slices say of the whole, whose observation is a sum of its own: the number, the momentum, and the
/// kinetic energy, which is that about the slices' velocities and that of these.
void expect_totals(Simulation const& simulation, Profile const& of, double boltzmann) {
  auto const whole = simulation.observe();
  double number = 0, kinetic = 0;
  Vec3 momentum;
  for (std::size_t s = 0; s < of.number.size(); ++s) {
    auto const n = static_cast<double>(of.number[s]);
    number += n;
    momentum += n * of.velocity[s];
    if (n > 0)
      kinetic += 1.5 * (n - 1) * boltzmann * of.T_kin[s] + 0.5 * n * norm2(of.velocity[s]);
  }
  EXPECT_EQ(number, static_cast<double>(simulation.size()));
  EXPECT_NEAR(kinetic / whole.kinetic, 1, 1e-13);
  EXPECT_LT(norm(momentum - whole.momentum), 1e-12);
}

TEST(Profile, AddsUpToTheWholeFluidToRoundOff) {
  auto const simulation = after(argon(5, 0.01), 40);
  auto const now = simulation.snapshot();
  auto const whole = simulation.observe();
  auto const particles = moments(now);
  int compared = 0;
  for (int const axis : {0, 1, 2})
    for (std::size_t const count : {1u, 7u, 24u}) {
      auto const of = profile(now, simulation.box(), {axis, count}, 1.0 / 5);
      ASSERT_EQ(of.number.size(), count);
      expect_totals(simulation, of, 1.0 / 5);
      EXPECT_NEAR(mean_over_particles(of, of.rho) / whole.rho, 1, 1e-13);
      EXPECT_NEAR(mean_over_particles(of, of.T_int) / whole.T_int, 1, 1e-13);
      EXPECT_NEAR(mean_over_particles(of, of.P_internal) / particles.P_mean, 1, 1e-13);
      ++compared;
    }
  EXPECT_EQ(compared, 9);
  auto const one = profile(now, simulation.box(), {0, 1}, 1.0 / 5);
  EXPECT_NEAR(one.T_kin[0] / whole.T_kin, 1, 1e-13);
}

// The virial's pressure is that of the particles up to the kernel's error; in an ideal gas of size 5 their
// motion carries a fifth of it.
TEST(Profile, HasThePressureOfTheMovingParticlesToo) {
  auto const simulation = after(ideal_gas(5, 0.02), 40);
  auto const one = profile(simulation.snapshot(), simulation.box(), {0, 1}, 1.0 / 5);
  double const P = simulation.observe().P;
  EXPECT_NEAR(one.P[0] / P, 1, 0.05);
  EXPECT_NEAR(one.P_internal[0] / P, 0.8, 0.05);
}

TEST(Profile, OfParticlesWithoutDensitiesIsThatOfTheirMass) {
  auto const simulation = after(dpde_fluid(60), 20);

  auto const of = profile(simulation.snapshot(), simulation.box(), {2, 12}, 1);
  auto const whole = simulation.observe();
  expect_totals(simulation, of, 1);
  double rho = 0, inverse_T = 0;
  for (std::size_t s = 0; s < 12; ++s)
    rho += of.rho[s] / 12, inverse_T += static_cast<double>(of.number[s]) / of.T_int[s];
  EXPECT_NEAR(rho / whole.rho, 1, 1e-13);
  EXPECT_NEAR(static_cast<double>(simulation.size()) / inverse_T / whole.T_int, 1, 1e-13);
  EXPECT_TRUE(of.P.empty() && of.P_internal.empty());
}

// Half of r . f of all pairs of a particle, by brute force over the nearest images.
TEST(Profile, OfThePressureOfADpdFluidIsThatOfItsPairs) {
  double const a = 25;
  auto const simulation = after(dpd_fluid(), 20);
  auto const now = simulation.snapshot_with_virials();
  Vec3 const edge = simulation.box().edge;
  std::size_t const n = now.q.size();
  std::vector<double> expected(n);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) {
      Vec3 const d = now.q[i] - now.q[j];
      double const r =
          norm({std::remainder(d.x, edge.x), std::remainder(d.y, edge.y), std::remainder(d.z, edge.z)});
      if (i != j && r < 1)
        expected[i] += 0.5 * a * (1 - r) * r;
    }
  ASSERT_EQ(now.virial.size(), n);
  for (std::size_t i = 0; i < n; ++i)
    ASSERT_NEAR(now.virial[i], expected[i], 1e-10 * a) << i;
  constexpr std::size_t count = 8;
  auto const of = profile(now, simulation.box(), {2, count}, 1);
  double const volume = simulation.box().volume() / count;
  double sum = 0;
  for (std::size_t s = 0; s < count; ++s)
    sum += (of.P[s] - of.rho[s] * of.T_kin[s]) * volume;
  auto const whole = simulation.observe();
  double const of_motion = static_cast<double>(n) * whole.T_kin;
  EXPECT_NEAR(sum / (whole.P * count * volume - of_motion), 1, 1e-12);
  EXPECT_TRUE(after(argon(50, 0.02), 0).snapshot_with_virials().virial.empty());
}

// A shear wave and a wave of temperature in a fluid whose own fluctuations hide neither.
TEST(Profile, ShowsTheWavesThatTheFluidWasGiven) {
  double const U = 0.05, A = 0.2, K = 1e4;
  auto const simulation = after(argon(K, 0.05), 0);
  auto now = simulation.snapshot();
  double const k = 2 * std::numbers::pi / simulation.box().edge.z;
  for (std::size_t i = 0; i < now.q.size(); ++i) {
    now.p[i].y += U * std::sin(k * now.q[i].z);
    now.T[i] *= 1 + A * std::cos(k * now.q[i].z);
  }
  constexpr std::size_t count = 12;
  auto const of = profile(now, simulation.box(), {2, count}, 1 / K);
  double const width = simulation.box().edge.z / count;
  double const within = 2 / (k * width) * std::sin(k * width / 2); // mean of a wave over a slice's width
  double const per_slice = 864.0 / count;
  // Of a mean velocity: thermal, and from where the particles of a slice happen to be.
  double const noise = std::sqrt(1 / K / per_slice), place = U * k * 0.1 / std::sqrt(per_slice);
  double largest = 0;
  for (std::size_t s = 0; s < count; ++s) {
    double const z = (static_cast<double>(s) + 0.5) * width;
    double const v = U * within * std::sin(k * z), T = 1 + A * within * std::cos(k * z);
    EXPECT_NEAR(of.velocity[s].y, v, 5 * std::hypot(noise, place)) << s;
    EXPECT_NEAR(of.velocity[s].x, 0, 5 * noise) << s;
    EXPECT_NEAR(of.T_int[s], T, 5 * A * k * 0.1 / std::sqrt(per_slice)) << s;
    // The flow within a slice adds to the thermal motion: U^2 k^2 w^2/12 at most over 3 k_B T.
    EXPECT_NEAR(of.T_kin[s], 1, 5 * std::sqrt(2 / (3 * per_slice)) + K * std::pow(U * k * width, 2) / 36)
        << s;
    largest = std::max(largest, std::abs(of.velocity[s].y));
  }
  EXPECT_GT(largest, 10 * std::hypot(noise, place)); // a profile of nothing would fail
}

TEST(Profile, SaysWhereThereIsNothing) {
  Snapshot now;
  now.q = {{0.5, 0, 0}, {0.6, 0, 0}, {3.5, 0, 0}};
  now.p = {{1, 0, 0}, {3, 0, 0}, {5, 0, 0}};
  auto const of = profile(now, {{4, 1, 1}}, {0, 4}, 1);
  EXPECT_EQ(of.number, (std::vector<std::int64_t>{2, 0, 0, 1}));
  EXPECT_EQ(of.rho, (std::vector<double>{2, 0, 0, 1}));
  EXPECT_EQ(of.velocity[0].x, 2);
  EXPECT_EQ(of.velocity[1].x, 0);
  EXPECT_EQ(of.velocity[3].x, 5);
  EXPECT_DOUBLE_EQ(of.T_kin[0], 2.0 / 3);
  EXPECT_EQ(of.T_kin[3], 0); // one particle has no motion about its own velocity
  EXPECT_TRUE(of.T_int.empty());
  EXPECT_THROW(profile(now, {{4, 1, 1}}, {3, 4}, 1), InputError);
  EXPECT_THROW(profile(now, {{4, 1, 1}}, {0, 0}, 1), InputError);
}

} // namespace
} // namespace mesobridge::sdpd
