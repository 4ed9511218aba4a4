#include "fitting/eos/lj_bwr.hpp"
#include "fitting/eos/tabulated.hpp"
#include "unit/fitting/random_states.hpp"
#include <gtest/gtest.h>

namespace mesobridge::fitting::test {
namespace {

constexpr TableRegion region{.rho_min = 0.3, .rho_max = 1.2, .T_min = 0.85, .T_max = 50};
constexpr double requested = 1e-8;

LjBwr const& model() {
  static LjBwr const lj(lj_bwr_1993);
  return lj;
}
Tabulated const& table() {
  static Tabulated const built = Tabulated::of(model(), region, requested);
  return built;
}

RandomState state(std::mt19937_64& generator) {
  std::uniform_real_distribution<double> uniform(0, 1);
  return {std::lerp(region.rho_min, region.rho_max, uniform(generator)),
          region.T_min * std::pow(region.T_max / region.T_min, uniform(generator))};
}

TEST(QuinticSpline, WeightsAreThoseOfPolynomials) {
  // Splines of degree five reproduce x^5 and its derivatives when they interpolate it; here by their moments:
  // the weights sum to one, their derivatives to zero.
  int cases = 0;
  for (double t : {0.0, 0.2, 0.5, 0.9, 1.0}) {
    auto sum = [](quintic::Row r) { return r[0] + r[1] + r[2] + r[3] + r[4] + r[5]; };
    EXPECT_NEAR(sum(quintic::weights(t)), 1, 1e-15);
    EXPECT_NEAR(sum(quintic::weights<1>(t)), 0, 1e-15);
    EXPECT_NEAR(sum(quintic::weights<2>(t)), 0, 1e-15);
    double const h = 1e-30;
    auto const w = quintic::weights_of(std::complex<double>(t, h));
    for (int j = 0; j < quintic::order; ++j, ++cases)
      EXPECT_NEAR(w[j].imag() / h, quintic::weights<1>(t)[j], 1e-15);
  }
  EXPECT_EQ(cases, 30);
}

TEST(Tabulated, IsTheModelToTheRequestedError) {
  // Other states than those by which the builder judged.
  std::mt19937_64 generator(77);
  double worst_T = 0, worst_P = 0, worst_C = 0, worst_s = 0;
  int cases = 0;
  for (; cases < 20000; ++cases) {
    auto const [rho, T] = state(generator);
    auto const exact = model().isochore(rho);
    double const e = exact.energy(T), P = exact.pressure(T);
    worst_T = std::max(worst_T, std::abs(table().temperature(e, rho) / T - 1));
    worst_P = std::max(worst_P, std::abs(table().pressure(e, rho) - P) / (std::abs(P) + rho * T));
    worst_C = std::max(worst_C, std::abs(table().heat_capacity(e, rho) / exact.heat_capacity(T) - 1));
    worst_s = std::max(worst_s, std::abs(table().entropy(e, rho) - exact.entropy(T)));
  }
  std::printf("%d x %d cells, %d states: errors of T %.1e, P %.1e, c_v %.1e, s %.1e\n",
              table().table().density.cells, table().table().y.cells, cases, worst_T, worst_P, worst_C,
              worst_s);
  EXPECT_EQ(cases, 20000);
  EXPECT_LT(worst_T, requested);
  EXPECT_LT(worst_P, requested);
  EXPECT_LT(worst_C, 1e-5);
  EXPECT_LT(table().accuracy().P, requested);
  EXPECT_GT(Tabulated::of(model(), region, 1e-4).accuracy().P, requested); // the error is one that it can see
}

TEST(Tabulated, DerivesEverythingFromOneEntropy) {
  using Complex = std::complex<double>;
  std::mt19937_64 generator(78);
  double const h = 1e-30;
  double worst = 0;
  int cases = 0;
  for (; cases < 5000; ++cases) {
    auto const [rho, T_near] = state(generator);
    double const e = model().energy_from_temperature(T_near, rho);
    double const s_e = table().entropy_of(Complex(e, h), Complex(rho)).imag() / h;
    double const s_rho = table().entropy_of(Complex(e), Complex(rho, h)).imag() / h;
    double const T = table().temperature(e, rho), P = table().pressure(e, rho);
    worst = std::max(worst, std::abs(T * s_e - 1));
    worst = std::max(worst, discrepancy(P, -T * rho * rho * s_rho, rho * T + 1));
    worst = std::max(worst, std::abs(table().entropy(e, rho) - table().entropy_of(e, rho)));
  }
  EXPECT_EQ(cases, 5000);
  EXPECT_LT(worst, 1e-11);
}

TEST(Tabulated, SlopesAreThoseOfItsOwnFunctions) {
  std::mt19937_64 generator(79);
  int cases = 0;
  for (; cases < 300; ++cases) {
    auto const [rho, T] = state(generator);
    if (T > 0.9 * region.T_max || T < 1.1 * region.T_min || rho > 1.19 || rho < 0.31)
      continue;
    auto const at = table().isochore(rho);
    double const h = 1e-4, C = at.heat_capacity(T), P_scale = rho * T + std::abs(at.pressure(T));
    auto slope = [h](auto&& f, double x) {
      return (8 * (f(x * (1 + h)) - f(x * (1 - h))) - f(x * (1 + 2 * h)) + f(x * (1 - 2 * h))) / (12 * h * x);
    };
    EXPECT_NEAR(slope([&](double t) { return at.energy(t); }, T), C, 1e-7 * C);
    EXPECT_NEAR(slope([&](double t) { return at.heat_capacity(t); }, T), at.heat_capacity_slope(T),
                1e-5 * C / T);
    EXPECT_NEAR(slope([&](double t) { return at.pressure(t); }, T), at.pressure_slope(T), 1e-7 * P_scale / T);
    EXPECT_NEAR(slope([&](double r) { return table().isochore(r).pressure(T); }, rho),
                at.pressure_density_slope(T), 1e-6 * P_scale / rho);
    EXPECT_NEAR(at.temperature_from_energy(at.energy(T), 1) / T, 1, 1e-12);
    EXPECT_NEAR(at.temperature_from_entropy(at.entropy(T), T) / T, 1, 1e-11);
  }
  EXPECT_EQ(cases, 300);
}

TEST(Tabulated, ArraysAreEachStateAlone) {
  std::mt19937_64 generator(80);
  std::vector<double> e, rho;
  for (int i = 0; i < 1003; ++i) {
    auto const [density, T] = state(generator);
    rho.push_back(density);
    e.push_back(model().energy_from_temperature(T, density));
  }
  std::vector<double> T(e.size()), P(e), C(e);
  evaluate(table(), {e, rho}, {T, P, C});
  int cases = 0;
  for (std::size_t i = 0; i < e.size(); ++i, ++cases) {
    EXPECT_NEAR(T[i] / table().temperature(e[i], rho[i]), 1, 1e-12);
    EXPECT_NEAR(P[i], table().pressure(e[i], rho[i]), 1e-11 * (1 + std::abs(P[i])));
    EXPECT_NEAR(C[i] / table().heat_capacity(e[i], rho[i]), 1, 1e-9);
  }
  EXPECT_EQ(cases, 1003);
  e[1001] = -100;
  EXPECT_THROW(evaluate(table(), {e, rho}, {T, P, C}), PhysicsError);
}

TEST(Tabulated, RefusesWhatItDoesNotCover) {
  double const nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(table().isochore(0.29), PhysicsError);
  EXPECT_THROW(table().isochore(nan), PhysicsError);
  EXPECT_THROW(table().temperature(-50, 0.8), PhysicsError);
  EXPECT_THROW(table().temperature(1e4, 0.8), PhysicsError);
  EXPECT_THROW(table().temperature(nan, 0.8), PhysicsError);
  EXPECT_THROW(table().energy_from_temperature(0.8, 0.8), PhysicsError);
  EXPECT_THROW(table().energy_from_temperature(51, 0.8), PhysicsError);
  EXPECT_NO_THROW(table().energy_from_temperature(region.T_min, region.rho_max));
  EXPECT_NO_THROW(table().energy_from_temperature(region.T_max, region.rho_min));
  EXPECT_THROW(Tabulated::of(model(), {0.3, 0.2, 1, 50}, 1e-8), InputError);
  EXPECT_THROW(Tabulated::of(model(), {0.3, 1.2, 0, 50}, 1e-8), InputError);
  EXPECT_THROW(Tabulated::of(model(), region, 1e-15), InputError);
  // Across T_low, where dc_v/dT of the model jumps, the error falls too slowly to reach 1e-11.
  EXPECT_THROW(Tabulated::of(model(), {0.7, 0.9, 0.5, 5}, 1e-11), PhysicsError);
}

} // namespace
} // namespace mesobridge::fitting::test
