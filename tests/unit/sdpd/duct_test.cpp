#include "sdpd/method/mean_field_viscosity.hpp"
#include "sdpd/simulation.hpp"
#include "sdpd_fixtures.hpp"
#include <gtest/gtest.h>

namespace mesobridge::sdpd {
namespace {

// A viscous ideal gas without noise that a body force drives along a square duct: in the mean over the cross
// section 0.035144 rho g L^2/eta, on the axis 0.073671 of it, by the series of White, Viscous Fluid Flow,
// section 3-3; between two planes their ratio would be 2/3. (In a lattice without disorder, rows of particles
// slide past each other with less friction.)
TEST(Duct, HasTheVelocitiesOfPoiseuillesFlow) {
  auto s = ideal_gas(100, 0.05);
  s.as<Sdpd>().kernel = "wendland-c4";
  s.as<Sdpd>().eta = s.units().viscosity();
  s.lattice = {6, 14, 14}, s.disorder = 0.2, s.noise = false;
  auto const along_y = walls_along(1), along_z = walls_along(2);
  s.faces[1] = along_y[1], s.faces[2] = along_z[2];
  double const strength = usual_wall_friction(s);
  for (int const axis : {1, 2})
    for (auto& face : s.faces[static_cast<std::size_t>(axis)])
      face.friction = {.acts = true, .temperature = s.T, .strength = strength};
  constexpr double g = 0.002;
  s.body_force.acceleration.x = g * s.units().velocity() / s.units().time();
  Simulation simulation(s);
  simulation.advance(1600);
  auto const now = simulation.snapshot();
  double const L = simulation.box().edge.z;
  double mean = 0, axis = 0, on_axis = 0;
  for (std::size_t i = 0; i < now.q.size(); ++i) {
    mean += now.p[i].x / static_cast<double>(now.q.size());
    if (std::hypot(now.q[i].y - L / 2, now.q[i].z - L / 2) < 1)
      axis += now.p[i].x, ++on_axis;
  }
  EXPECT_GT(on_axis, 10);
  double const unit = g * L * L;
  EXPECT_NEAR(mean / unit / 0.035144, 1, 0.05);
  EXPECT_NEAR(axis / on_axis / unit / 0.073034, 1, 0.07); // 0.073671 on the axis itself
  EXPECT_NEAR(mean / (axis / on_axis) / (0.035144 / 0.073034), 1, 0.05);
}

} // namespace
} // namespace mesobridge::sdpd
