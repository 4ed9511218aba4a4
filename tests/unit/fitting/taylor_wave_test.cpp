#include "fitting/eos/ideal_gas.hpp"
#include "fitting/reactive_fluid.hpp"
#include "fitting/taylor_wave.hpp"
#include "unit/fitting/built_in.hpp"
#include <cmath>
#include <gtest/gtest.h>

namespace mesobridge::fitting::test {
namespace {

// A polytropic gas, c = c_CJ + (gamma - 1)/2 (u - u_CJ), so that u falls on a straight line over z; strong
// detonations have rest from D t/2 on, whatever gamma.
TEST(TaylorWave, OfAPolytropicGasIsLinear) {
  int cases = 0;
  for (double const gamma : {1.2, 1.4, 3.0}) {
    Fluid const fluid{IdealGas::from_gamma(1, gamma, 1)};
    auto const ahead = fluid.at_temperature(1.3, 1e-3);
    Hugoniot const crussard(ahead, fluid, 5);
    auto const cj = crussard.chapman_jouguet();
    auto const wave = taylor_wave(fluid, cj, 0, 40);
    double const D = cj.v_S, P_cj = (ahead.P + 1.3 * D * D) / (gamma + 1),
                 u_cj = (P_cj - ahead.P) / (1.3 * D), c_cj = D - u_cj;
    ASSERT_EQ(wave.size(), 40u);
    EXPECT_NEAR(wave.front().place, 1, 1e-7);
    EXPECT_NEAR(wave.front().u / u_cj, 1, 1e-7);
    EXPECT_NEAR(wave.back().u / u_cj, 0, 1e-9);
    EXPECT_NEAR(wave.back().place, (c_cj - 0.5 * (gamma - 1) * u_cj) / D, 1e-7);
    EXPECT_NEAR(wave.back().place, 0.5, 1e-3);
    for (auto const& at : wave) {
      double const c = c_cj + 0.5 * (gamma - 1) * (at.u - u_cj);
      EXPECT_NEAR(at.place, (at.u + c) / D, 1e-7);
      EXPECT_NEAR(*at.state.sound_speed / c, 1, 1e-7);
      EXPECT_NEAR(at.state.s, cj.behind.s, 1e-9 * std::abs(cj.behind.s));
    }
    ++cases;
  }
  EXPECT_EQ(cases, 3);
}

TEST(TaylorWave, OfNitromethaneObeysTheEquationsOfMotion) {
  auto const rest = Fluid(nitromethane()).at_temperature(1104, 300);
  ReactiveFluid const explosive{nitromethane(), products(), VolumeLaw::additive_volume, rest,
                                4.78e-19 / (61.04 * atomic_mass)};
  auto const cj = explosive.crussard().chapman_jouguet();
  auto const wave = taylor_wave(Fluid(products()), cj, 0, 400);
  // Of x = z/(D t): (u - x D) rho' + rho u' = 0 and (u - x D) rho u' + P' = 0.
  for (std::size_t k = 1; k + 1 < wave.size(); ++k) {
    auto const &a = wave[k - 1], &b = wave[k], &c = wave[k + 1];
    double const dx = c.place - a.place, flow = b.u - b.place * cj.v_S;
    double const rho_x = (c.state.rho - a.state.rho) / dx, u_x = (c.u - a.u) / dx,
                 P_x = (c.state.P - a.state.P) / dx;
    EXPECT_NEAR(flow * rho_x / (b.state.rho * u_x), -1, 1e-4);
    EXPECT_NEAR(flow * b.state.rho * u_x / P_x, -1, 1e-4);
  }
  auto const behind_piston = taylor_wave(Fluid(products()), cj, 0.5 * cj.v_P, 10);
  EXPECT_NEAR(behind_piston.back().u / (0.5 * cj.v_P), 1, 1e-9);
  EXPECT_THROW(taylor_wave(Fluid(products()), cj, cj.v_P, 10), InputError);
  EXPECT_GT(wave.back().place, 0.4);
  EXPECT_LT(wave.back().place, 0.6);
}

} // namespace
} // namespace mesobridge::fitting::test
