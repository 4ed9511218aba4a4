#include "md/hugoniostat.hpp"
#include "md/units.hpp"
#include "temporary_log.hpp"
#include <cmath>
#include <gtest/gtest.h>

namespace mesobridge::md::test {
namespace {

TEST(Hugoniostat, ItsStatesSatisfyTheHugoniotEquation) {
  MpiWorld const world;
  auto settings = metal_settings(Preset::quick, read_metal_potential("Cu_u3.eam", ""));
  settings.least_atoms = 108;
  settings.equilibration_steps = 3000;
  settings.sampling_steps = 3000;
  settings.log_file = tests::temporary_log("nphug");
  // A classical crystal at 300 K: e = 3 k_B T/m about the energy at rest; only the difference to it matters
  // here.
  double const e0 = 3 * k_B * 300 / settings.potential.mass;
  ShockTarget const target{.initial = {8820, 300}, .P0 = 0, .e0 = e0, .P = 3e10, .nearby = {10300, 500}};
  double e = 0, rho = 0, P = 0, T = 0;
  int samples = 0;
  ASSERT_TRUE(sample_hugoniostat(world, target, settings, [&](HugoniostatSample const& s) {
    e += s.e, rho += s.rho, P += s.P, T += s.T;
    return ++samples > 0;
  }));
  EXPECT_EQ(samples, 150);
  e /= samples, rho /= samples, P /= samples, T /= samples;
  EXPECT_NEAR(P / 3e10, 1, 0.02);
  double const work = P * (1 / 8820.0 - 1 / rho) / 2;
  EXPECT_NEAR((e - e0) / work, 1, 0.03);
  EXPECT_GT(rho, 9900);
  EXPECT_LT(rho, 10700);
  EXPECT_GT(T, 400);
  EXPECT_LT(T, 700);
  int calls = 0;
  EXPECT_FALSE(sample_hugoniostat(world, target, settings, [&](auto const&) { return ++calls < 2; }));
  EXPECT_EQ(calls, 2);
  std::filesystem::remove(settings.log_file);
}

} // namespace
} // namespace mesobridge::md::test
