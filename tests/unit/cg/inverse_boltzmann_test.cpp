#include "cg/inverse_boltzmann.hpp"
#include "error_text.hpp"
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace mesobridge::cg {
namespace {

constexpr double kT = 1.3, cutoff = 3, width = 0.05;

/// Repulsive inside, with a shallow well; zero with its slope at the cut-off.
double u_of(double r) {
  double const x = 1 - r / cutoff;
  return r < cutoff ? x * x * (14 * x - 3) : 0;
}

RadialBins bins_of(auto const& g) {
  RadialBins bins{width, {}};
  for (int k = 0; k < 80; ++k)
    bins.g.push_back(g((k + 0.5) * width));
  return bins;
}

InversionSettings settings() {
  return {.kT = kT, .cutoff = cutoff};
}

TEST(InverseBoltzmann, BeginsWithThePotentialOfAThinGas) {
  auto const potential =
      boltzmann_potential(bins_of([](double r) { return std::exp(-u_of(r) / kT); }), settings());
  ASSERT_EQ(potential.u.size(), 60u);
  EXPECT_NEAR(potential.cutoff(), cutoff, 1e-12);
  std::size_t compared = 0;
  for (std::size_t k = 0; k < potential.u.size(); ++k)
    if (std::exp(-u_of(potential.r(k)) / kT) > 1e-3) {
      EXPECT_NEAR(potential.u[k], u_of(potential.r(k)), 2e-3) << potential.r(k);
      ++compared;
    }
  EXPECT_GT(compared, 50u);
}

// Where no pair ever was the potential goes on with a linear force, which pushes outwards.
TEST(InverseBoltzmann, GoesOnIntoTheCore) {
  auto const g = bins_of([](double r) { return r < 1 ? 0 : std::exp(-u_of(r) / kT); });
  auto const potential = boltzmann_potential(g, settings());
  for (std::size_t k = 1; k + 1 < 20; ++k) {
    double const inner = potential.u[k - 1] - potential.u[k], outer = potential.u[k] - potential.u[k + 1];
    EXPECT_GT(inner, 0);
    EXPECT_NEAR((outer - inner) / (potential.u[0] - potential.u[1]), 1, 1e-6); // u = a + b r^2
  }
  EXPECT_NEAR(potential.u[20], u_of(potential.r(20)), 0.01);
}

TEST(InverseBoltzmann, StaysWhereGIsTheTarget) {
  auto const g = bins_of([](double r) { return std::exp(-u_of(r) / kT); });
  auto const before = boltzmann_potential(g, settings());
  auto const after = inverted(before, g, g, settings());
  for (std::size_t k = 0; k < before.u.size(); ++k)
    EXPECT_NEAR(after.u[k], before.u[k], 1e-9);
  EXPECT_EQ(g_difference(g, g), 0);
}

// Of a gas so thin that g = exp(-u/kT) always: the whole change is right at once, half of it half.
TEST(InverseBoltzmann, AnUpdateOfAThinGasIsRight) {
  auto const wrong = [](double r) { return u_of(r) * 0.8; };
  auto const target = bins_of([](double r) { return std::exp(-u_of(r) / kT); }),
             now = bins_of([&](double r) { return std::exp(-wrong(r) / kT); });
  auto const before = boltzmann_potential(now, settings());
  for (double const share : {1.0, 0.5}) {
    auto s = settings();
    s.share = share;
    auto const after = inverted(before, target, now, s);
    for (std::size_t k = 5; k < after.u.size(); ++k) {
      double const r = after.r(k), wanted = wrong(r) + share * (u_of(r) - wrong(r));
      EXPECT_NEAR(after.u[k], wanted, 5e-3) << r;
    }
  }
  EXPECT_GT(g_difference(target, now), 1e-4);
}

// A made-up direct correlation of Gaussian form, whose h follows by Ornstein and Zernike's equation.
TEST(InverseBoltzmann, FindsTheDirectCorrelation) {
  double const density = 0.7, depth = 0.4, pi = std::numbers::pi;
  auto const c_of = [&](double r) { return -depth * std::exp(-r * r); };
  auto const h_of = [&](double r) {
    double sum = 0, dk = 0.01; // h(r) = 1/(2 pi^2 r) int k sin(k r) c/(1 - density c) dk
    for (double k = 0.5 * dk; k < 14; k += dk) {
      double const c = -depth * std::pow(pi, 1.5) * std::exp(-k * k / 4);
      sum += k * std::sin(k * r) * c / (1 - density * c) * dk;
    }
    return sum / (2 * pi * pi * r);
  };
  RadialBins bins{0.05, {}};
  for (int k = 0; k < 160; ++k)
    bins.g.push_back(1 + h_of((k + 0.5) * bins.width));
  auto const c = direct_correlation(bins, density);
  for (std::size_t k = 0; k < 80; ++k)
    EXPECT_NEAR(c[k], c_of((double(k) + 0.5) * bins.width), 2e-3) << k;
}

TEST(InverseBoltzmann, TakesPressureAway) {
  double const density = 0.4, excess = 0.02;
  auto const g = bins_of([](double r) { return std::exp(-u_of(r) / kT); });
  auto const before = boltzmann_potential(g, settings());
  auto const after = with_less_pressure(before, g, density, excess, 0.1 * kT);
  // P = rho kT - (2 pi/3) rho^2 int r^3 u' g dr, at the bins' edges
  auto const pressure = [&](PairPotential const& of) {
    double sum = 0;
    for (std::size_t k = 0; k + 1 < of.u.size(); ++k)
      sum += std::pow((double(k) + 1) * width, 3) * (of.u[k + 1] - of.u[k]) * 0.5 * (g.g[k] + g.g[k + 1]);
    return -2 * std::numbers::pi / 3 * density * density * sum;
  };
  EXPECT_NEAR(pressure(before) - pressure(after), excess, 0.05 * excess); // without the last half bin
  auto const much = with_less_pressure(before, g, density, 100, 0.1 * kT);
  EXPECT_NEAR(before.u[0] - much.u[0], 0.1 * kT * (1 - 0.5 * width / cutoff), 1e-12);
}

// The inversion's own change of the pressure is undone, but for what was to be changed; a pressure that is
// far away is come to by a quarter.
TEST(InverseBoltzmann, ComesToAPressureWhileItInverts) {
  double const density = 0.4;
  auto const target = bins_of([](double r) { return std::exp(-u_of(r) / kT); }),
             now = bins_of([](double r) { return std::exp(-1.1 * u_of(r) / kT); });
  auto const before = boltzmann_potential(now, settings());
  for (double const excess : {-0.02, 0.0, 0.02}) {
    auto const after = inverted_at_pressure(before, target, now, settings(), density, excess);
    EXPECT_NEAR(pressure_change(before, after, now, density), -excess, 2e-3) << excess;
  }
  auto const alone = inverted(before, target, now, settings()),
             far = inverted_at_pressure(before, target, now, settings(), density, 100);
  EXPECT_GT(std::abs(pressure_change(before, alone, now, density)), 0.01);
  EXPECT_NEAR(pressure_change(before, far, now, density), -25, 1);
}

// At small distances there is little room: a bin that holds a few pairs by chance would make a well in the
// core.
TEST(InverseBoltzmann, DoesNotTakeAFewPairsForStructure) {
  auto g = bins_of([](double r) { return std::exp(-u_of(r) / kT) * (r > 1 ? 1 : 0); });
  auto of_measured = settings();
  of_measured.least_pairs = 5e-4;
  auto const without = boltzmann_potential(g, of_measured);
  std::size_t const place = std::size_t(0.25 / g.width);
  for (std::size_t k = place; double(k) * g.width < 1; ++k)
    g.g[k] = 2e-3;
  auto const with = boltzmann_potential(g, of_measured);
  EXPECT_NEAR(with.u[place], without.u[place], 0.2 * kT);
}

TEST(InverseBoltzmann, RefusesByName) {
  auto const g = bins_of([](double r) { return std::exp(-u_of(r) / kT); });
  auto const refused = [&](RadialBins const& target, InversionSettings const& s, std::string const& word) {
    auto const text = tests::error_text([&] { boltzmann_potential(target, s); });
    EXPECT_NE(text.find(word), std::string::npos) << text;
  };
  refused(g, {.kT = 0, .cutoff = 3}, "kT");
  refused(g, {.kT = 1, .cutoff = 9}, "cutoff");
  refused(g, {.kT = 1, .cutoff = 3, .share = 0}, "share");
  refused(g, {.kT = 1, .cutoff = 3, .knots = 0}, "knots");
  refused(bins_of([](double) { return 0; }), settings(), "hold pairs");
  auto const before = boltzmann_potential(g, settings());
  EXPECT_NE(tests::error_text([&] {
              inverted(before, g, {0.1, g.g}, settings());
            }).find("target"),
            std::string::npos);
}

} // namespace
} // namespace mesobridge::cg
