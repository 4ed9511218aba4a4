#include "fitting/eos/evaluate.hpp"
#include "fitting/eos/list.hpp"
#include "fitting/eos/lj_bwr_stability.hpp"
#include "unit/fitting/built_in.hpp"
#include <gsl/gsl_integration.h>
#include <gtest/gtest.h>
#include <random>

namespace mesobridge::fitting::test {
namespace {

TEST(LjBwrPublished, ResidualFreeEnergyOfJohnsonsSet) {
  EXPECT_NEAR(lj().alpha_r(0.6, 1.35), -1.237403479, 5e-10);
  EXPECT_NEAR(argon().alpha_r(0.6 * argon_units.density(), 1.35 * argon_units.temperature()), -1.237403479,
              5e-10);
}

/// A_res straight from the printed formulae, in long double, with the printed recursion of the G_i.
long double printed_free_energy(long double rho, long double T) {
  auto const x = [](int j) { return static_cast<long double>(lj_bwr_1993.x[j - 1]); };
  long double const g = 3, F = std::exp(-g * rho * rho), T2 = T * T, T3 = T2 * T, T4 = T2 * T2;
  long double const a[] = {x(1) * T + x(2) * std::sqrt(T) + x(3) + x(4) / T + x(5) / T2,
                           x(6) * T + x(7) + x(8) / T + x(9) / T2,
                           x(10) * T + x(11) + x(12) / T,
                           x(13),
                           x(14) / T + x(15) / T2,
                           x(16) / T,
                           x(17) / T + x(18) / T2,
                           x(19) / T2};
  long double const b[] = {x(20) / T2 + x(21) / T3, x(22) / T2 + x(23) / T4,
                           x(24) / T2 + x(25) / T3, x(26) / T2 + x(27) / T4,
                           x(28) / T2 + x(29) / T3, x(30) / T2 + x(31) / T3 + x(32) / T4};
  long double A = 0, G = (1 - F) / (2 * g);
  for (int i = 1; i <= 8; ++i)
    A += a[i - 1] * std::pow(rho, static_cast<long double>(i)) / i;
  for (int i = 1; i <= 6; ++i) {
    if (i > 1)
      G = -(F * std::pow(rho, static_cast<long double>(2 * (i - 1))) - 2 * (i - 1) * G) / (2 * g);
    A += b[i - 1] * G;
  }
  return A;
}

TEST(LjBwrPublished, EqualsThePrintedFormulae) {
  std::mt19937_64 generator(3);
  std::uniform_real_distribution<double> density(0.001, 1.3), temperature(0.84, 100);
  double worst = 0;
  int cases = 0;
  for (; cases < 20000; ++cases) {
    double const rho = density(generator), T = temperature(generator);
    double const printed = static_cast<double>(printed_free_energy(rho, T));
    worst =
        std::max(worst, std::abs(lj().alpha_r(rho, T) * T - printed) / std::max(std::abs(printed), 1e-3 * T));
  }
  std::printf("%d states; largest difference from the printed formulae %.1e\n", cases, worst);
  EXPECT_LT(worst, 1e-11);
  EXPECT_EQ(cases, 20000);
}

TEST(LjBwrPublished, ArgonOfTheThesis) {
  LjUnits units = argon_units;
  units.mass = 6.63e-26;
  auto const state = state_from_temperature(argon().in_units(units), 1150, 1000);
  EXPECT_NEAR(state.e * units.mass / (k_B * 1000), 1.26554, 1e-5);
  EXPECT_NEAR(state.P, 0.68139e9, 1e4);
  // The mass matters: 6.64e-26 does not give the same pressure.
  EXPECT_GT(std::abs(state_from_temperature(argon(), 1150, 1000).P - 0.68139e9), 1e6);
}

/// Density behind a shock that drives the fluid to the velocity v_P, by bisection of the Rankine-Hugoniot
/// relations.
double hugoniot_density(LjBwr const& eos, double rho_0, double T_0, double v_P) {
  double const e_0 = eos.energy_from_temperature(T_0, rho_0), P_0 = eos.pressure(e_0, rho_0);
  auto excess = [&](double rho) {
    double const P_1 = P_0 + rho_0 * v_P * v_P * rho / (rho - rho_0);
    return eos.pressure(e_0 + 0.5 * (P_0 + P_1) * (1 / rho_0 - 1 / rho), rho) - P_1;
  };
  double low = 1.05 * rho_0, high = 1.7 * rho_0;
  for (int i = 0; i < 60; ++i) {
    double const middle = 0.5 * (low + high);
    (excess(middle) < 0 ? low : high) = middle;
  }
  return low;
}

TEST(LjBwrPublished, ShockInArgon) {
  // A value beside fitting/README.md, Eq. (F14), from an independent solver.
  double const rho_0 = 1150, v_P = 500;
  double const rho = hugoniot_density(argon(), rho_0, 500, v_P), v_S = v_P * rho / (rho - rho_0);
  double const e_0 = argon().energy_from_temperature(500, rho_0), P_0 = argon().pressure(e_0, rho_0);
  double const P = P_0 + rho_0 * v_S * v_P, e = e_0 + 0.5 * (P_0 + P) * (1 / rho_0 - 1 / rho);
  std::printf("argon shock: v_S %.2f m/s, rho %.2f kg/m^3, P %.5g Pa, T %.2f K\n", v_S, rho, P,
              argon().temperature(e, rho));
  EXPECT_NEAR(v_S / 1975.0, 1, 1e-4);
  EXPECT_NEAR(rho / 1539.8, 1, 1e-4);
  EXPECT_NEAR(P / 1.4661e9, 1, 1e-4);
  EXPECT_NEAR(argon().temperature(e, rho) / 968.9, 1, 1e-4);
}

TEST(LjBwrPublished, CriticalPoint) {
  // Johnson et al. constrained their set to T_c* = 1.313, rho_c* = 0.310.
  auto least_slope = [](double T) {
    std::pair least{1e9, 0.0};
    for (double rho = 0.2; rho < 0.45; rho += 1e-4)
      least = std::min(least, std::pair{lj().isochore(rho).pressure_density_slope(T), rho});
    return least;
  };
  EXPECT_NEAR(least_slope(1.313).first, 0, 2e-3);
  EXPECT_NEAR(least_slope(1.313).second, 0.310, 2e-3);
  EXPECT_LT(least_slope(1.303).first, -5e-3);
  EXPECT_GT(least_slope(1.323).first, 5e-3);
}

double exact_second_virial(double T) {
  // B(T) = -2 pi int_0^inf (exp(-u/T) - 1) r^2 dr of the Lennard-Jones potential
  auto integrand = [](double r, void* temperature) {
    double const r_6 = std::pow(r, -6), u = 4 * (r_6 * r_6 - r_6);
    return (std::expm1(-u / *static_cast<double*>(temperature))) * r * r;
  };
  gsl_function function{.function = integrand, .params = &T};
  auto* const workspace = gsl_integration_workspace_alloc(1000);
  double near = 0, far = 0, error = 0;
  gsl_integration_qags(&function, 1e-3, 1, 0, 1e-9, 1000, workspace, &near, &error);
  gsl_integration_qagiu(&function, 1, 0, 1e-9, 1000, workspace, &far, &error);
  gsl_integration_workspace_free(workspace);
  return -2 * M_PI * (near + far);
}

TEST(LjBwrPublished, DiluteLimitIsTheSecondVirialCoefficient) {
  int cases = 0;
  for (double T : {1.0, 1.5, 2.0, 3.0, 5.0}) {
    double const B = lj().alpha_r(1e-7, T) / 1e-7;
    EXPECT_NEAR(B, exact_second_virial(T), 0.03) << "T* = " << T;
    ++cases;
  }
  EXPECT_EQ(cases, 5);
}

TEST(LjBwrPublished, HeatCapacityIsPositiveAllOverTheDomain) {
  auto const& set = lj_bwr_1993;
  auto const found = stability(set, {0.01, set.rho_max, set.T_low, set.T_max});
  std::printf("%d states; least c_v %.4f k_B at rho* %.3f, T* %.3f\n", found.states, found.c_v_min,
              found.rho_at_c_v_min, found.T_at_c_v_min);
  EXPECT_GT(found.c_v_min, 1.5);
  EXPECT_EQ(found.unstable, 0);
  EXPECT_EQ(found.states, 126 * 80);
  // It is not so at lower temperatures, which is why the continuation is needed.
  LjBwrSet uncontinued = set;
  uncontinued.T_low = 0.5;
  EXPECT_LT(stability(uncontinued, {0.01, set.rho_max, 0.5, set.T_max}).c_v_min, 0);
}

TEST(LjBwrPublished, ContinuationHasConstantHeatCapacityAndNoStep) {
  int cases = 0;
  for (double rho : {0.05, 0.3, 0.7, 0.9, 1.2}) {
    auto const isochore = lj().isochore(rho);
    double const T_low = lj_bwr_1993.T_low, above = T_low * (1 + 1e-12), below = T_low * (1 - 1e-12);
    EXPECT_DOUBLE_EQ(isochore.heat_capacity(0.2), isochore.heat_capacity(T_low));
    EXPECT_EQ(isochore.heat_capacity_slope(0.2), 0);
    EXPECT_NEAR(isochore.energy(above), isochore.energy(below), 1e-9);
    EXPECT_NEAR(isochore.entropy(above), isochore.entropy(below), 1e-9);
    EXPECT_NEAR(isochore.pressure(above), isochore.pressure(below), 1e-9);
    EXPECT_NEAR(isochore.pressure_density_slope(above), isochore.pressure_density_slope(below), 1e-7);
    ++cases;
  }
  EXPECT_EQ(cases, 5);
  EXPECT_NEAR(lj_bwr_1993.T_low * argon_units.temperature(), 100, 1e-12);
}

TEST(LjBwrPublished, SoundSpeedIsRefusedInsideTheLiquidGasRegion) {
  auto const state = state_from_temperature(lj(), 0.4, 0.85);
  EXPECT_LT(state.sound_speed_squared, 0);
  EXPECT_FALSE(state.sound_speed.has_value());
  EXPECT_THROW(lj().sound_speed(state.e, 0.4), PhysicsError);
}

TEST(LjBwrPublished, RefusesSetsThatAreNone) {
  auto refused = [](auto change) {
    LjBwrSet set = lj_bwr_1993;
    change(set);
    EXPECT_THROW(LjBwr{set}, InputError);
  };
  refused([](LjBwrSet& set) { set.x[4] = NAN; });
  refused([](LjBwrSet& set) { set.gamma = 0; });
  refused([](LjBwrSet& set) { set.T_low = -1; });
  refused([](LjBwrSet& set) { set.T_max = set.T_low; });
  refused([](LjBwrSet& set) { set.rho_max = INFINITY; });
  EXPECT_THROW(LjBwr(lj_bwr_1993, LjUnits{.sigma = 1, .epsilon = 0, .mass = 1}), InputError);
}

} // namespace
} // namespace mesobridge::fitting::test
