#include "sdpd/conduction/heat_conduction.hpp"
#include <gtest/gtest.h>

namespace mesobridge::sdpd {
namespace {

double const kB = 0.05, C_i = 1.2, C_j = 1.9, chi = 0.3;

PairTemperatures<double> at(double e_i, double e_j) {
  return {e_i / C_i, e_j / C_j, 1 / C_i, 1 / C_j};
}

template <class Law>
HeatStep<double> step(Law const& law, double dt, PairTemperatures<double> const& at) {
  return law.step(chi, dt, at, at.T_i - at.T_j);
}

// A reversible diffusion of the heat with the mobility M (noise 2 M) keeps the density pi when its drift is
// M d ln(pi) + dM, d = d/d eps_i - d/d eps_j. Here ln(pi) = sum C ln(eps)/k_B + measure (constant heat
// capacities), and the derivatives are numerical: an independent way to the drift of both laws.
template <class Law>
void expect_reversible(Law const& law) {
  double const e_i = 1.5, e_j = 1.1, h = 1e-5, dt = 1e-8;
  auto mobility = [&](double e) { return step(law, dt, at(e_i + e, e_j - e)).variance / (2 * dt); };
  auto log_pi = [&](double e) {
    auto const state = at(e_i + e, e_j - e);
    double const measure = Law::measure_over_T ? -std::log(state.T_i * state.T_j) : 0;
    return (C_i * std::log(e_i + e) + C_j * std::log(e_j - e)) / kB + measure;
  };
  auto slope = [&](auto const& f) { return (f(h) - f(-h)) / (2 * h); };
  double const drift = step(law, dt, at(e_i, e_j)).mean / dt;
  EXPECT_NEAR(drift, mobility(0) * slope(log_pi) + slope(mobility), 1e-6);
  EXPECT_GT(std::abs(drift), 0.1);
}

TEST(HeatConduction, LeavesTheMeasureOfSdpdAlone) {
  expect_reversible(SdpdConduction{2.7, kB});
}
TEST(HeatConduction, LeavesTheMeasureOfDpdeAlone) {
  expect_reversible(DpdeConduction{PowerFriction(2.7, 0, 1, 2), kB});
}

TEST(HeatConduction, OfSdpdIsFouriersLawOfThePair) {
  double const kappa = 0.8, dt = 1e-7;
  auto const state = at(1.5, 1.1);
  auto const heat = step(SdpdConduction{kappa, kB}, dt, state);
  EXPECT_NEAR(heat.mean / dt, 2 * kappa * chi * (state.T_j - state.T_i), 1e-7);
  EXPECT_NEAR(heat.variance / dt, 2 * kB * 2 * kappa * chi * state.T_i * state.T_j, 1e-7);
}

// The exact solution of the pair's equations at constant heat capacities, for any time step.
TEST(HeatConduction, RelaxesAPairExactly) {
  double const kappa = 0.8;
  auto const before = at(1.5, 1.1);
  int steps = 0;
  for (double const dt : {1e-3, 0.1, 3.0, 1e4}) {
    double const heat = step(SdpdConduction{kappa, 0}, dt, before).mean;
    auto const after = at(1.5 + heat, 1.1 - heat);
    double const rate = 2 * kappa * chi * (1 / C_i + 1 / C_j);
    EXPECT_NEAR(after.T_j - after.T_i, (before.T_j - before.T_i) * std::exp(-rate * dt), 1e-12);
    ++steps;
  }
  EXPECT_EQ(steps, 4);
}

} // namespace
} // namespace mesobridge::sdpd
