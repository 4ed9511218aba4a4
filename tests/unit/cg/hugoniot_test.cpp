#include "cg/hugoniot.hpp"
#include "md/error.hpp"
#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace mesobridge::cg::test {
namespace {

/// A metal with e = e_c(rho) + c T, P = P_c(rho) + G rho c T and the cold curve of a solid with a constant
/// bulk modulus K in ln(rho): P_c = K ln(rho/rho_c), so e_c = -K/rho (1 + ln(rho/rho_c)) + K/rho_c.
struct Metal {
  double rho_c = 9000, K = 1.4e11, c = 400, G = 2;

  double e(double rho, double T) const { return K / rho_c - K / rho * (1 + std::log(rho / rho_c)) + c * T; }
  double P(double rho, double T) const { return K * std::log(rho / rho_c) + G * rho * c * T; }
  /// The shocked temperature: the Hugoniot equation is linear in T.
  double shocked_T(double rho0, double T0, double rho) const {
    double const dv = 1 / rho0 - 1 / rho;
    double const cold = e(rho, 0) - e(rho0, T0) - (P(rho, 0) + P(rho0, T0)) * dv / 2;
    return -cold / (c - G * rho * c * dv / 2);
  }
};

struct Noise {
  double e = 500, P = 2e7, correlation = 0.6;
};

MetalPoint point(Metal const& metal, double rho, double T, Noise const& noise, std::mt19937_64* random) {
  std::normal_distribution<double> normal;
  double const a = random ? normal(*random) : 0, b = random ? normal(*random) : 0;
  double const r = noise.correlation;
  MetalPoint result;
  result.state = {rho, T};
  result.e = {metal.e(rho, T) + noise.e * a, noise.e, 100};
  result.P = {metal.P(rho, T) + noise.P * (r * a + std::sqrt(1 - r * r) * b), noise.P, 100};
  result.cov_eP = r * noise.e * noise.P;
  return result;
}

std::vector<MetalPoint> states(Metal const& metal, double rho, double T, Noise const& noise,
                               std::mt19937_64* random) {
  std::vector<MetalPoint> result;
  for (double part : {0.9, 1.05, 1.15})
    result.push_back(point(metal, rho, part * T, noise, random));
  return result;
}

constexpr double rho0 = 8900, T0 = 300, rho1 = 10500;

TEST(Hugoniot, WithoutNoiseItIsTheExactSolution) {
  Metal const metal;
  double const T = metal.shocked_T(rho0, T0, rho1), P0 = metal.P(rho0, T0), P = metal.P(rho1, T);
  auto const initial = point(metal, rho0, T0, {}, nullptr);
  auto const found = solve_hugoniot(initial, states(metal, rho1, 500, {}, nullptr));
  EXPECT_NEAR(found.T.mean / T, 1, 1e-10);
  EXPECT_NEAR(found.P.mean / P, 1, 1e-10);
  EXPECT_NEAR(found.e.mean / metal.e(rho1, T), 1, 1e-10);
  // Rankine and Hugoniot: mass, momentum and energy.
  double const v_P = found.v_P.mean, v_S = found.v_S.mean;
  EXPECT_NEAR(rho1 * (v_S - v_P) / (rho0 * v_S), 1, 1e-12);
  EXPECT_NEAR(P0 + rho0 * v_S * v_P, found.P.mean, 1e-10 * P);
  EXPECT_NEAR(metal.e(rho0, T0) + (P0 + P) * (1 / rho0 - 1 / rho1) / 2, found.e.mean, 1e-9 * found.e.mean);
  EXPECT_LT(found.chi_2, 1e-12);
}

TEST(Hugoniot, TheErrorsAreThoseOfRepeatedMeasurements) {
  Metal const metal;
  double const T = metal.shocked_T(rho0, T0, rho1), P = metal.P(rho1, T), P0 = metal.P(rho0, T0);
  double const v_P = std::sqrt((P - P0) * (1 / rho0 - 1 / rho1)), v_S = v_P * rho1 / (rho1 - rho0);
  std::mt19937_64 random(7);
  constexpr int repeats = 1500;
  double sum_T = 0, sum_P = 0, sum_e = 0, sum_v_P = 0, sum_v_S = 0, sum_cross = 0, chi_2 = 0;
  for (int k = 0; k < repeats; ++k) {
    auto const found =
        solve_hugoniot(point(metal, rho0, T0, {}, &random), states(metal, rho1, 500, {}, &random));
    sum_T += std::pow(deviation(found.T, T), 2);
    sum_P += std::pow(deviation(found.P, P), 2);
    sum_e += std::pow(deviation(found.e, metal.e(rho1, T)), 2);
    sum_v_P += std::pow(deviation(found.v_P, v_P), 2);
    sum_v_S += std::pow(deviation(found.v_S, v_S), 2);
    sum_cross += (found.v_P.mean - v_P) * (found.v_S.mean - v_S) / found.cov_vSvP;
    chi_2 += found.chi_2;
  }
  // Mean squares of standardised errors are 1 +- sqrt(2/1500) = 0.037.
  for (double sum :
       {sum_T, sum_P, sum_e, sum_v_P, sum_v_S, sum_cross, chi_2}) // three states: 1 degree of freedom
    EXPECT_NEAR(sum / repeats, 1, 0.15);
  EXPECT_GT(std::abs(sum_T / repeats * 1.5 - 1), 0.15) << "errors that are a fifth too small are seen";
}

TEST(Hugoniot, RefusesWhatHasNoSolution) {
  Metal const metal;
  auto const initial = point(metal, rho0, T0, {}, nullptr);
  auto good = states(metal, rho1, 500, {}, nullptr);
  EXPECT_THROW(solve_hugoniot(initial, std::span(good).first(1)), InputError);
  auto same_T = good;
  for (auto& p : same_T)
    p.state.T = 500;
  EXPECT_THROW(solve_hugoniot(initial, same_T), InputError);
  auto other_rho = good;
  other_rho[1].state.rho += 1;
  EXPECT_THROW(solve_hugoniot(initial, other_rho), InputError);
  EXPECT_THROW(solve_hugoniot(good[0], states(metal, rho0, 300, {}, nullptr)), InputError) << "a rarefaction";
  auto falling = good;
  std::swap(falling[0].e, falling[2].e);
  EXPECT_THROW(solve_hugoniot(initial, falling), PhysicsError);
}

TEST(Hugoniot, FindsTheDensityOfZeroPressureWithItsError) {
  Metal const metal;
  double low = 8000, high = 9000; // P(rho, 300 K) = 0 by bisection
  for (int k = 0; k < 60; ++k)
    (metal.P((low + high) / 2, T0) < 0 ? low : high) = (low + high) / 2;
  std::mt19937_64 random(3);
  double sum = 0;
  constexpr int repeats = 500;
  for (int k = 0; k < repeats; ++k) {
    std::vector<MetalPoint> points;
    for (double part : {0.998, 1.0, 1.002}) // near enough for a straight line
      points.push_back(point(metal, part * low, T0, {}, &random));
    auto const rho = zero_pressure_density(points);
    sum += std::pow(deviation(rho, low), 2);
  }
  EXPECT_NEAR(sum / repeats, 1, 0.25);
}

HugoniotPoint on_line(double c0, double s, double v_P, double se_P, double se_S, double correlation,
                      std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  double const a = normal(random), b = normal(random);
  HugoniotPoint result;
  result.v_P = {v_P + se_P * a, se_P, 0};
  result.v_S = {c0 + s * v_P + se_S * (correlation * a + std::sqrt(1 - correlation * correlation) * b), se_S,
                0};
  result.cov_vSvP = correlation * se_P * se_S;
  return result;
}

TEST(Hugoniot, FitsTheUsUpLineWithItsErrors) {
  std::mt19937_64 random(11);
  double sum_c0 = 0, sum_s = 0, chi_2 = 0;
  constexpr int repeats = 1000;
  for (int k = 0; k < repeats; ++k) {
    std::vector<HugoniotPoint> points;
    for (double v_P = 200; v_P < 1700; v_P += 100)
      points.push_back(on_line(3940, 1.489, v_P, 4, 15, 0.5, random));
    auto const line = fit_us_up(points);
    sum_c0 += std::pow(line.a - 3940, 2) / line.var_a;
    sum_s += std::pow(line.b - 1.489, 2) / line.var_b;
    chi_2 += line.chi_2 / 13;
  }
  EXPECT_NEAR(chi_2 / repeats, 1, 0.05);
  // The covariance is never less than that of the stated errors, so it is a little above on the mean.
  EXPECT_NEAR(sum_c0 / repeats, 0.88, 0.15);
  EXPECT_NEAR(sum_s / repeats, 0.88, 0.15);
}

TEST(Hugoniot, ACurveHasTheErrorsOfItsScatterAboutALine) {
  std::mt19937_64 random(5);
  std::vector<HugoniotPoint> points;
  for (double v_P = 200; v_P < 1700; v_P += 100) {
    points.push_back(on_line(3940, 1.489, v_P, 0.1, 0.3, 0.5, random));
    points.back().v_S.mean += 3e-5 * std::pow(v_P - 900, 2); // up to 15 m/s
  }
  auto const line = fit_us_up(points);
  EXPECT_GT(line.chi_2, 100 * 13);
  EXPECT_GT(std::sqrt(line.var_a), 1.0) << "0.1 m/s by the errors of the points alone";
}

} // namespace
} // namespace mesobridge::cg::test
