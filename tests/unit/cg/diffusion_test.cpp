#include "cg/diffusion.hpp"
#include "error_text.hpp"
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <random>

namespace mesobridge::cg {
namespace {

/// Langevin's particles in a periodic box, by the exact steps of velocity and place: C(t) = kT/m exp(-gamma
/// t), Delta^2 = 6 D (t - (1 - exp(-gamma t))/gamma), D = kT/(m gamma).
struct Langevin {
  double gamma = 2, kT = 1.5, mass = 3, dt = 0.05, edge = 4;
  std::size_t molecules = 200, frames = 4000;
  Vec3 drift = {};

  double D() const { return kT / (mass * gamma); }
  double displacement(double t) const { return 6 * D() * (t + std::expm1(-gamma * t) / gamma); }
  BlobSeries series(unsigned seed) const {
    std::mt19937_64 generator(seed);
    std::normal_distribution<double> G;
    Box const box{{edge, edge, edge}};
    BlobSeries all{.molecules = molecules, .atoms = 1, .mass = mass};
    // The joint law of the velocity's and the place's noise over one step.
    double const a = std::exp(-gamma * dt), vv = kT / mass * (1 - a * a),
                 xx = kT / mass / (gamma * gamma) * (2 * gamma * dt - 3 + 4 * a - a * a),
                 xv = kT / mass / gamma * (1 - a) * (1 - a);
    std::vector<Vec3> x(molecules), v(molecules);
    for (auto& velocity : v)
      for (int axis = 0; axis < 3; ++axis)
        component(velocity, axis) = std::sqrt(kT / mass) * G(generator);
    for (std::size_t k = 0; k < frames; ++k) {
      all.times.push_back(dt * double(k)), all.boxes.push_back(box);
      for (std::size_t m = 0; m < molecules; ++m) {
        all.R.push_back(box.wrap(x[m] + drift * (dt * double(k)))), all.P.push_back(mass * (v[m] + drift));
        for (int axis = 0; axis < 3; ++axis) {
          double const g = G(generator), h = G(generator), before = component(v[m], axis);
          component(v[m], axis) = a * before + std::sqrt(vv) * g;
          component(x[m], axis) +=
              before * (1 - a) / gamma + xv / std::sqrt(vv) * g + std::sqrt(xx - xv * xv / vv) * h;
        }
      }
    }
    return all;
  }
};

TEST(Diffusion, OfLangevinsParticlesIsExact) {
  Langevin const fluid;
  auto const found = diffusion(fluid.series(5), {.longest = 20});
  EXPECT_LT(std::abs(deviation(found.D, fluid.D())), 4);
  EXPECT_LT(found.D.se, 0.03 * fluid.D());
  EXPECT_LT(std::abs(deviation(found.D_earlier, fluid.D())), 4);
  EXPECT_LT(std::abs(deviation(found.temperature, fluid.kT)), 4);
  EXPECT_LT(found.temperature.se, 0.01 * fluid.kT);
  ASSERT_TRUE(found.decay);
  EXPECT_NEAR(found.decay->mean, 1 / fluid.gamma, 0.02);
  ASSERT_TRUE(found.D_velocity);
  // The trapezoidal rule has x/2 coth(x/2) of the integral, x = gamma dt.
  double const x = fluid.gamma * fluid.dt;
  EXPECT_LT(std::abs(deviation(*found.D_velocity, fluid.D() * x / 2 / std::tanh(x / 2))), 4);
  EXPECT_GT(std::abs(deviation(*found.D_velocity, 1.2 * fluid.D())), 4); // a wrong answer is seen
  std::size_t compared = 0;
  for (std::size_t k = 1; k < found.lag.size(); k += 20, ++compared) {
    EXPECT_LT(std::abs(deviation(found.displacement[k], fluid.displacement(found.lag[k]))), 5)
        << found.lag[k];
    EXPECT_LT(std::abs(deviation(found.velocity[k], std::exp(-fluid.gamma * found.lag[k]))), 5)
        << found.lag[k];
  }
  EXPECT_GT(compared, 15u);
}

TEST(Diffusion, DoesNotFeelTheMotionOfAllTogether) {
  Langevin fluid;
  fluid.frames = 400;
  auto const at_rest = diffusion(fluid.series(6), {.longest = 5});
  fluid.drift = {7, -3, 11};
  auto const moving = diffusion(fluid.series(6), {.longest = 5});
  ASSERT_TRUE(moving.D_velocity && at_rest.D_velocity);
  EXPECT_NEAR(moving.D.mean / at_rest.D.mean, 1, 1e-9);
  EXPECT_NEAR(moving.D_velocity->mean / at_rest.D_velocity->mean, 1, 1e-9);
  EXPECT_NEAR(moving.temperature.mean / at_rest.temperature.mean, 1, 1e-9);
}

// Plain sums over all pairs of frames.
TEST(Diffusion, IsThatOfPlainSums) {
  Langevin fluid;
  fluid.molecules = 6, fluid.frames = 40, fluid.edge = 1000;
  auto const series = fluid.series(7);
  auto const found = diffusion(series, {.longest = 0.5, .groups = 6});
  for (std::size_t lag = 0; lag < found.lag.size(); ++lag) {
    double changes = 0, products = 0, squares = 0;
    for (std::size_t k = 0; k + lag < fluid.frames; ++k)
      for (std::size_t m = 0; m < 6; ++m) {
        Vec3 step, early, late;
        for (std::size_t n = 0; n < 6; ++n) {
          double const part = (n == m) - 1.0 / 6;
          step += part * series.boxes[0].minimum_image(series.R[(k + lag) * 6 + n] - series.R[k * 6 + n]);
          early += part * series.P[k * 6 + n], late += part * series.P[(k + lag) * 6 + n];
        }
        changes += norm2(step), products += dot(early, late);
      }
    for (std::size_t k = 0; k < fluid.frames; ++k)
      for (std::size_t m = 0; m < 6; ++m) {
        Vec3 own;
        for (std::size_t n = 0; n < 6; ++n)
          own += ((n == m) - 1.0 / 6) * series.P[k * 6 + n];
        squares += norm2(own);
      }
    double const pairs = double(fluid.frames - lag);
    EXPECT_NEAR(found.displacement[lag].mean, 1.2 * changes / pairs / 6, 1e-9);
    if (lag == 0) {
      EXPECT_NEAR(found.temperature.mean, 1.2 * squares / double(fluid.frames) / 18 / fluid.mass, 1e-9);
    } else { // a ratio, freed from bias by the jackknife
      EXPECT_NEAR(found.velocity[lag].mean, products / pairs / (squares / double(fluid.frames)), 0.1);
    }
  }
}

TEST(Diffusion, IsCorrectedForTheImagesOfABox) {
  Langevin fluid;
  fluid.frames = 100, fluid.molecules = 20;
  auto const series = fluid.series(8);
  auto const found = diffusion(series, {.viscosity = 5, .temperature = 2});
  ASSERT_TRUE(found.D_infinite);
  EXPECT_NEAR(found.D_infinite->mean - found.D.mean, 2.837297 * 2 / (6 * 3.14159265358979 * 5 * 4), 1e-9);
  EXPECT_FALSE(diffusion(series).D_infinite);
}

TEST(Diffusion, HasNoIntegralOfFramesThatAreFarApart) {
  Langevin fluid;
  fluid.dt = 0.5, fluid.frames = 200, fluid.edge = 20;
  auto const found = diffusion(fluid.series(9));
  EXPECT_FALSE(found.D_velocity);
  EXPECT_FALSE(found.decay);
  EXPECT_LT(std::abs(deviation(found.D, fluid.D())), 4);
}

TEST(Diffusion, KnowsWhenVelocitiesHaveChangedBeforeTheyHaveDiedAway) {
  Langevin const fluid;
  auto const found = diffusion(fluid.series(5), {.longest = 3 / fluid.gamma});
  ASSERT_TRUE(found.decay);
  EXPECT_NEAR(found.decay->mean, 1 / fluid.gamma, 0.02);
  EXPECT_FALSE(found.D_velocity); // a twentieth of it is missing at three decays
  EXPECT_FALSE(diffusion(fluid.series(5), {.longest = 0.5 / fluid.gamma}).decay);
}

TEST(Diffusion, RefusesByName) {
  Langevin fluid;
  fluid.frames = 40, fluid.molecules = 8;
  auto const good = fluid.series(1);
  EXPECT_NO_THROW(diffusion(good));
  auto const refused = [](BlobSeries const& series, DiffusionSettings const& settings,
                          std::string const& word) {
    auto const text = tests::error_text([&] { diffusion(series, settings); });
    EXPECT_NE(text.find(word), std::string::npos) << text;
  };
  refused(good, {.longest = 0.1}, "longest lag");
  refused(good, {.longest = 100}, "longest lag");
  refused(good, {.groups = 3}, "groups");
  refused(good, {.viscosity = -1}, "viscosity");
  refused(good, {.viscosity = std::numeric_limits<double>::infinity()}, "viscosity");
  auto gap = good;
  gap.times.back() += 0.01;
  refused(gap, {}, "interval");
  auto fast = good;
  for (auto& box : fast.boxes)
    box.edge = {0.1, 0.1, 0.1};
  refused(fast, {}, "0.4");
  fluid.molecules = 3;
  refused(fluid.series(1), {}, "molecules");
}

} // namespace
} // namespace mesobridge::cg
