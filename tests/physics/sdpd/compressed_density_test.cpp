#include "cg/estimate.hpp"
#include "fitting/eos/ideal_gas.hpp"
#include "sdpd/method/settings.hpp"
#include "sdpd/setup/equilibration.hpp"
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

// What constants of the densities do in a fluid that is compressed while its kernels keep their width
// (sdpd/README.md, Eq. (S70) ... (S72)).

namespace mesobridge::sdpd {
namespace {

constexpr double rho_0 = 1150, h_0 = 2.5, K = 5;

/// The thesis's ideal gas, with kernels 2.5 distances between particles at rest wide.
SimulationSettings gas(double rho, double T, DensityCorrection const& constants) {
  return {.method = Sdpd{.eos = fitting::IdealGas(1e-25),
                         .K = K,
                         .kernel = "wendland-c4",
                         .density_correction = constants,
                         .h_factor = h_0 * std::cbrt(rho / rho_0),
                         .eta = 2e-3},
          .rho = rho,
          .T = T,
          .lattice = {10, 10, 10},
          .disorder = 0.15,
          .dt = 0.05,
          .scheme = {.pairs = "ems"},
          .seed = 5};
}

/// Means of rho_i over the mass per volume, and of the pressure over that of the ideal gas.
struct Means {
  cg::Estimate rho, P;
};

Means measure(SimulationSettings const& settings) {
  Simulation simulation(settings);
  equilibrate(simulation, 200, [] { return true; });
  std::vector<double> rho, P;
  for (int k = 0; k < 150; ++k) {
    simulation.advance(4);
    auto const now = simulation.observe();
    rho.push_back(now.rho), P.push_back(now.P); // P in units of n k_B T
  }
  return {cg::estimate_mean(rho), cg::estimate_mean(P)};
}

/// Wendland's C4 of Eq. (S4), written once more.
double W(double r) {
  double const u = r / h_0;
  return u >= 1 ? 0
                : 495 / (32 * std::numbers::pi * std::pow(h_0, 3)) * std::pow(1 - u, 6) *
                      (1 + 6 * u + 35 * u * u / 3);
}

/// D of Eq. (S71) per volume of a particle at rest, by sums.
double missing_neighbours() {
  constexpr double dr = h_0 / 400, dk = 0.02;
  double D = 0;
  for (double k = dk / 2; k < 14; k += dk) {
    double w = 0;
    for (double r = dr / 2; r < h_0; r += dr)
      w += 4 * std::numbers::pi * r * r * W(r) * std::sin(k * r) / (k * r) * dr;
    double const S = 1 / (1 + (K - 1) * (2 * w - w * w));
    D += 4 * std::numbers::pi * k * k * w * (1 - S) * dk;
  }
  return D / std::pow(2 * std::numbers::pi, 3);
}

TEST(CompressedDensity, IsThatOfTheRandomPhaseApproximation) {
  double const D = missing_neighbours(), x = 4074.7 / rho_0;
  EXPECT_NEAR(D, 0.190, 0.002);
  DensityCorrection const constants{1, 0.5};
  auto const found = measure(gas(4074.7, 8139.4, constants));
  double const expected = 1 + (0.5 * W(0) - D) / x;
  EXPECT_LT(found.rho.se, 0.001);
  EXPECT_NEAR(found.rho.mean, expected, 0.002 + 4 * found.rho.se);
  EXPECT_GT(std::abs(found.rho.mean - (1 + 0.5 * W(0) / x)), 0.02); // not that of particles placed at random
}

/// The same constants give the pressure at rest and at 3.5 times the density and 8 times the temperature,
/// whatever the scale c, as long as epsilon/c is the same.
TEST(CompressedDensity, KeepsThePressureWithoutAnotherCalibration) {
  int cases = 0;
  for (double const c : {1.0, 1.04})
    for (auto const& [rho, T] : {std::pair(rho_0, 1000.0), {4074.7, 8139.4}}) {
      auto const found = measure(gas(rho, T, {c, 0.52 * c}));
      EXPECT_LT(found.P.se, 0.004);
      EXPECT_NEAR(found.P.mean, 1, 0.006 + 3 * found.P.se) << rho << " " << c;
      ++cases;
    }
  EXPECT_EQ(cases, 4);
  auto const plain = measure(gas(rho_0, 1000, {}));
  EXPECT_LT(plain.P.mean, 0.93); // a wrong answer is seen
}

} // namespace
} // namespace mesobridge::sdpd
