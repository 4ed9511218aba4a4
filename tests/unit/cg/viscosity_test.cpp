#include "cg/viscosity.hpp"
#include "error_text.hpp"
#include "hydrodynamic_modes.hpp"
#include <gtest/gtest.h>

namespace mesobridge::cg {
namespace {

// x'' + x'/T + (a/T) x = 0 with x(0) = 1, x'(0) = 0, by small steps.
TEST(ViscousDecay, IsTheMotionOfADampedOscillator) {
  int compared = 0;
  for (double const rate_times_memory : {1e-3, 0.1, 0.2499999, 0.25, 0.2500001, 0.3, 2.0}) {
    ViscousDecay const decay{.rate = 0.7, .memory = rate_times_memory / 0.7};
    double x = 1, v = 0, t = 0;
    double const h = 1e-3 * std::min(1.0, decay.memory);
    for (int step = 0; t < 6; ++step, t += h) {
      if (step % 200 == 0 && t > 0) {
        EXPECT_NEAR(decay(t), x, 2e-4) << rate_times_memory << " " << t;
        ++compared;
      }
      v -= 0.5 * h * (v + decay.rate * x) / decay.memory;
      x += h * v, v -= 0.5 * h * (v + decay.rate * x) / decay.memory;
    }
  }
  EXPECT_GT(compared, 100);
}

TEST(ViscousDecay, IsFoundInItsOwnValues) {
  int compared = 0;
  for (double const memory : {0.05, 0.3, 1.0, 4.0}) {
    ViscousDecay const set{.rate = 0.6, .memory = memory};
    std::vector<double> values;
    for (int lag = 0; lag < 40; ++lag)
      values.push_back(set(0.1 * lag));
    auto const found = fit_viscous_decay(values, 0.1);
    EXPECT_NEAR(found.rate, set.rate, 1e-6) << memory;
    EXPECT_NEAR(found.memory, set.memory, 1e-5) << memory;
    ++compared;
  }
  EXPECT_EQ(compared, 4);
}

TEST(WaveShells, AreThoseOfTheBox) {
  auto const cube = wave_shells(Box{{5, 5, 5}}, 2);
  ASSERT_EQ(cube.size(), 4u);
  std::size_t const vectors[] = {3, 6, 4, 3};
  for (std::size_t s = 0; s < 4; ++s) {
    EXPECT_EQ(cube[s].vectors.size(), vectors[s]);
    EXPECT_NEAR(cube[s].k, 2 * std::numbers::pi / 5 * std::sqrt(double(s + 1)), 1e-12);
  }
  auto const duct = wave_shells(Box{{10, 4, 5}}, 2); // 2 pi/10 times 1, 2 (two ways)
  ASSERT_EQ(duct.size(), 2u);
  EXPECT_EQ(duct[0].vectors.size(), 1u);
  EXPECT_EQ(duct[1].vectors.size(), 2u);
  // Edges (5, 0, 0), (5, 6, 0), (-5, 6, 7): a lattice of 5 x 6 x 7.
  auto const upright = wave_shells(Box{{5, 6, 7}}, 2),
             tilted = wave_shells(Box{.edge = {5, 6, 7}, .xy = 5, .xz = -5, .yz = 6}, 3);
  ASSERT_GE(tilted.size(), upright.size());
  for (std::size_t k = 0; k < upright.size(); ++k) {
    EXPECT_NEAR(tilted[k].k, upright[k].k, 1e-12);
    EXPECT_EQ(tilted[k].vectors.size(), upright[k].vectors.size()) << k;
  }
  EXPECT_THROW(wave_shells(Box{{5, 5, 5}}, 0.5), InputError);
  EXPECT_THROW(wave_shells(Box{{5, 5, 5}}, 7), InputError);
}

TEST(Viscosity, OfKnownModesIsFoundForEachWaveAndForNone) {
  HydrodynamicModes fluid;
  fluid.drift = {0.9, -0.4, 0.6};
  auto const found = viscosity(fluid.series(3));
  EXPECT_NEAR(found.density, fluid.density(), 1e-12);
  ASSERT_EQ(found.waves.size(), 4u);
  EXPECT_TRUE(found.left_out.empty());
  for (auto const& wave : found.waves) {
    EXPECT_LT(std::abs(deviation(wave.eta, fluid.eta_of(wave.k))), 4) << wave.k;
    EXPECT_LT(std::abs(deviation(wave.eta_integral, fluid.eta_of(wave.k))), 4) << wave.k;
    EXPECT_LT(wave.eta.se, 0.06 * fluid.eta);
    EXPECT_LT(std::abs(deviation(wave.temperature, fluid.kT)), 4);
    EXPECT_NEAR(wave.memory, fluid.memory, 0.15);
    ViscousDecay const exact{fluid.eta_of(wave.k) * wave.k * wave.k / fluid.density(), fluid.memory};
    for (std::size_t lag = 1; lag < wave.correlation.size(); lag += 3)
      EXPECT_LT(std::abs(deviation(wave.correlation[lag], exact(found.interval * double(lag)))), 5);
  }
  EXPECT_LT(std::abs(deviation(found.eta, fluid.eta)), 4);
  EXPECT_LT(std::abs(deviation(found.eta_integral, fluid.eta)), 4);
  EXPECT_LT(found.eta.se, 0.04 * fluid.eta);
  EXPECT_GT(std::abs(deviation(found.eta, 1.25 * fluid.eta)), 4); // a wrong answer is seen
  EXPECT_GT(std::abs(deviation(found.eta, fluid.eta_of(found.waves[3].k))), 4);
  EXPECT_LT(found.chi2, 14); // of two degrees of freedom
}

// Runs that differ in the seed alone spread as each says; the mean of all is right. The shorter ones are as
// short as may be: 8 blocks, twice as long as the slowest wave lives.
TEST(Viscosity, ErrorsAreThoseOfManyRuns) {
  HydrodynamicModes fluid;
  fluid.sites = 5;
  constexpr int runs = 16;
  int compared = 0;
  for (std::size_t const frames : {1200u, 400u}) {
    fluid.frames = frames;
    double sum = 0, squares = 0, quoted = 0;
    for (int run = 0; run < runs; ++run, ++compared) {
      auto const eta = viscosity(fluid.series(100 + unsigned(run))).eta;
      double const off = eta.mean - fluid.eta;
      sum += off, squares += off * off, quoted += eta.se * eta.se;
    }
    double const mean = sum / runs, spread = std::sqrt((squares / runs - mean * mean) * runs / (runs - 1));
    EXPECT_LT(std::abs(mean), 4 * spread / std::sqrt(double(runs))) << frames;
    EXPECT_GT(spread / std::sqrt(quoted / runs), 0.55) << frames;
    EXPECT_LT(spread / std::sqrt(quoted / runs), 1.5) << frames;
  }
  EXPECT_EQ(compared, 32);
}

// A short lattice of waves, by plain sums over sites.
TEST(TransverseCurrents, AreThoseOfPlainSums) {
  HydrodynamicModes fluid;
  fluid.frames = 5, fluid.edge = {6, 7, 8};
  auto const series = fluid.series(9);
  auto const shells = wave_shells(series.boxes[0], 1.2);
  auto const currents = transverse_currents(series, shells);
  std::size_t compared = 0;
  for (std::size_t s = 0; s < shells.size(); ++s)
    for (std::size_t v = 0; v < shells[s].vectors.size(); ++v) {
      auto const n = shells[s].vectors[v];
      Vec3 const k{n[0] * 2 * std::numbers::pi / 6, n[1] * 2 * std::numbers::pi / 7,
                   n[2] * 2 * std::numbers::pi / 8};
      for (std::size_t f = 0; f < fluid.frames; ++f) {
        double whole = 0, along = 0, ours = 0; // sums of squares of the current's parts
        for (double const phase : {0.0, -0.5 * std::numbers::pi}) {
          Vec3 J, mean;
          for (std::size_t m = 0; m < series.molecules; ++m)
            mean += series.P[f * series.molecules + m] / double(series.molecules);
          for (std::size_t m = 0; m < series.molecules; ++m)
            J += std::cos(dot(k, series.R[f * series.molecules + m]) + phase) *
                 (series.P[f * series.molecules + m] - mean);
          whole += dot(J, J), along += dot(J, k) * dot(J, k) / dot(k, k);
        }
        for (std::size_t part = 0; part < 4; ++part)
          ours += std::pow(currents[s][4 * v + part][f], 2);
        EXPECT_NEAR(ours, whole - along, 1e-9 * whole);
        ++compared;
      }
    }
  EXPECT_EQ(compared, 10u);
}

TEST(Viscosity, RefusesByName) {
  HydrodynamicModes fluid;
  fluid.frames = 600;
  auto const good = fluid.series(1);
  EXPECT_NO_THROW(viscosity(good));
  auto const refused = [](BlobSeries const& series, ViscositySettings const& settings,
                          std::string const& word) {
    auto const text = tests::error_text([&] { viscosity(series, settings); });
    EXPECT_NE(text.find(word), std::string::npos) << text;
  };
  refused(good, {.reach = 0}, "longest wave vector");
  refused(good, {.blocks = 4}, "blocks");
  refused(good, {.reach = 1}, "at least two lengths");
  auto gap = good;
  gap.times.back() += 0.01;
  refused(gap, {}, "interval");
  auto breathing = good;
  breathing.boxes[7].edge.x += 0.1;
  refused(breathing, {}, "edges of the box");
  auto at_rest = good;
  for (auto& P : at_rest.P)
    P = {};
  refused(at_rest, {}, "velocities");
  fluid.frames = 60;
  refused(fluid.series(1), {}, "frames");
  fluid.frames = 80;
  refused(fluid.series(1), {}, "too short");
  fluid.frames = 600, fluid.interval = 3;
  refused(fluid.series(1), {}, "too far apart");
}

} // namespace
} // namespace mesobridge::cg
