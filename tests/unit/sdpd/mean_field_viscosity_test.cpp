#include "pair_fluid_fixtures.hpp"
#include "sdpd/method/mean_field_viscosity.hpp"
#include <gtest/gtest.h>
#include <numbers>

namespace mesobridge::sdpd {
namespace {

// Groot and Warren 1997: 2 pi gamma n^2 r_c^5/1575 + 45 k_B T/(4 pi gamma r_c^3).
TEST(MeanFieldViscosity, IsThatOfGrootAndWarrenForDpd) {
  auto const fluid = dpd_fluid();
  auto const [dissipative, kinetic] = mean_field_viscosity(fluid);
  double const pi = std::numbers::pi, gamma = 4.5, n = 3;
  EXPECT_NEAR(dissipative, 2 * pi * gamma * n * n / 1575, 1e-6);
  EXPECT_NEAR(kinetic, 45 / (4 * pi * gamma), 1e-6);
  EXPECT_NEAR(mean_field_viscosity(dpde_fluid(60)).sum(), dissipative + kinetic, 1e-12);
  EXPECT_NEAR(usual_wall_friction(fluid), 4 * (1 + kinetic / dissipative), 1e-12);
}

// Friction across the line of centres, too: SDPD's eta comes out of its own coefficients, whose transverse
// part is half of that along the line, and its kinetic part from the integral of F, 12/h^2 for the cubic
// spline.
TEST(MeanFieldViscosity, IsThatOfSdpd) {
  auto fluid = argon(100, 0.02);
  auto const units = fluid.units();
  double const eta = 0.7;
  fluid.as<Sdpd>().eta = eta * units.viscosity();
  auto const [dissipative, kinetic] = mean_field_viscosity(fluid);
  EXPECT_NEAR(dissipative / units.viscosity(), eta, 1e-12);
  double const rate = 20 * eta / 9 * 12 / (2.5 * 2.5);
  EXPECT_NEAR(kinetic / units.viscosity(), 1 / (100 * 2 * rate), 1e-8);
}

// What friction transmits by its definition: half the sum over all others of force times distance in a fluid
// that is sheared uniformly.
TEST(MeanFieldViscosity, IsTheStressOfShearedParticlesWithoutStructure) {
  auto const fluid = dpde_fluid(60, 0.01, 2);
  double sum = 0, volume = 0;
  constexpr int cells = 120;
  for (int x = 0; x < cells; ++x)
    for (int y = 0; y < cells; ++y)
      for (int z = 0; z < cells; ++z) {
        auto const at = [](int k) { return 2 * (k + 0.5) / cells - 1; };
        Vec3 const r{at(x), at(y), at(z)};
        double const distance = norm(r), cell = std::pow(2.0 / cells, 3);
        volume += cell;
        if (distance >= 1)
          continue;
        double const w = (1 - distance) * (1 - distance), e_x = r.x / distance;
        double const force = (4.5 * e_x * e_x + 2 * (1 - e_x * e_x)) * w * r.z; // at the shear rate 1
        sum += 0.5 * 9 * force * r.z * cell;
      }
  EXPECT_NEAR(volume, 8, 1e-9);
  EXPECT_NEAR(mean_field_viscosity(fluid).dissipative / sum, 1, 1e-3);
}

} // namespace
} // namespace mesobridge::sdpd
