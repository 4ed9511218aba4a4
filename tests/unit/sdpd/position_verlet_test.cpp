#include "pair_fluid_fixtures.hpp"
#include "sdpd/make_system.hpp"
#include "sdpd/scheme/list.hpp"
#include <gtest/gtest.h>

namespace mesobridge::sdpd {
namespace {

void make(System& system, std::vector<SubStep> const& steps) {
  for (auto const& one : steps)
    one.run(system);
}

// Between the middles of two drifts of Velocity Verlet lie steps of position Verlet.
TEST(PositionVerlet, IsVelocityVerletHalfAStepLater) {
  double const dt = 0.02;
  auto const by_velocity = make_system(dpd_fluid(dt)), by_position = make_system(dpd_fluid(dt));
  std::vector<Vec3> start(by_velocity->size());
  for (std::size_t i = 0; i < start.size(); ++i)
    start[by_velocity->particles.id[i]] = by_velocity->particles.q[i];
  for (int k = 0; k < 6; ++k)
    make(*by_velocity, conservative_integrator("verlet").steps(dt));
  make(*by_position, {parts::kick_and_drift(dt / 2, dt / 2)});
  for (int k = 0; k < 5; ++k)
    make(*by_position, conservative_integrator("position-verlet").steps(dt));
  make(*by_position, {parts::kick_and_drift(0, dt / 2), parts::forces(), parts::kick(dt / 2)});
  auto const &one = by_velocity->particles, &other = by_position->particles;
  std::vector<std::size_t> place(one.size());
  for (std::size_t i = 0; i < place.size(); ++i)
    place[other.id[i]] = i;
  double moved = 0, apart = 0;
  for (std::size_t i = 0; i < place.size(); ++i) {
    std::size_t const j = place[one.id[i]];
    moved = std::max(moved, norm(by_velocity->box.minimum_image(one.q[i] - start[one.id[i]])));
    apart = std::max(apart, norm(by_velocity->box.minimum_image(one.q[i] - other.q[j])));
    apart = std::max(apart, norm(one.p[i] - other.p[j]));
  }
  EXPECT_GT(moved, 0.1);
  EXPECT_LT(apart, 1e-12);
}

} // namespace
} // namespace mesobridge::sdpd
