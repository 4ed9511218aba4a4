#include "md/error.hpp"
#include "scratch_directory.hpp"
#include "workflows/coarse/coarse_scenes.hpp"
#include "workflows/coarse/compared_shocks.hpp"
#include "workflows/scene/scene.hpp"
#include "workflows/text_file.hpp"
#include <gtest/gtest.h>

namespace mesobridge::workflows {
namespace {

/// A front at 2 before which 0.3, 0.2 and 1 are the density, pressure and temperature, and behind which are
/// 0.4, 0.5 and 1.1.
ShockOfRun shock() {
  ShockOfRun shock{.measured = {.v_S = {2, 0.01}, .rho = {0.4, 0}, .P = {0.5, 0.004}, .T = {1.1, 0.002}},
                   .mass_per_volume = {0.4, 0},
                   .T_kin = {1.09, 0.01},
                   .exact = std::nullopt,
                   .depth = {-20, -10, 1, 14, 16},
                   .rho = {{0.4, 0}, {0.4, 0}, {0.33, 0}, {0.31, 0}, {0.29, 0}},
                   .P = {{0.5, 0}, {0.5, 0}, {0.3, 0}, {0.2, 0.003}, {0.2, 0.003}},
                   .T = {{1.1, 0}, {1.1, 0}, {1, 0}, {1, 0.001}, {1, 0.001}},
                   .velocity = {},
                   .T_motion = {}};
  return shock;
}

// By hand: 10 (0.5 + 0.2)/2 (1/0.3 - 1/0.4) = 2.9167, its error 10 0.8333/2 (0.004^2 + 0.003^2)^(1/2)
// = 0.02083; heat (20 + 3/2) 0.1 = 2.15, its error 21.5 (0.002^2 + 0.001^2)^(1/2) = 0.04808.
TEST(ComparedShocks, KnowWhatIsHeat) {
  auto const state = shocked_state(shock(), 1.5, 10, fitting::ConstantHeatCapacity(20));
  EXPECT_NEAR(state.rho_0.mean, 0.3, 1e-12);
  EXPECT_NEAR(state.energy.mean, 2.9166667, 1e-6);
  EXPECT_NEAR(state.energy.se, 0.0208333, 1e-6);
  EXPECT_NEAR(state.heat.mean, 2.15, 1e-9);
  EXPECT_NEAR(state.heat.se, 0.0480755, 1e-6);
  EXPECT_THROW(shocked_state(shock(), 3, 10, fitting::ConstantHeatCapacity(20)), PhysicsError); // 8 x 3 = 24
}

TEST(ComparedShocks, AreToldSideBySide) {
  ComparedShocks shocks{.melt = shock(), .particles = shock(), .of_melt = {}, .of_particles = {}};
  shocks.of_melt = shocked_state(shock(), 1.5, 10, fitting::ConstantHeatCapacity(20));
  EXPECT_EQ(shocks_section(shocks, 0.5, {}).content.size(), 1u); // there is nothing to compare with
  EXPECT_FALSE(shocks_json(shocks).contains("P_dpde"));
  shocks.of_particles = shocks.of_melt;
  shocks.of_particles->P = {0.52, 0.003};
  EXPECT_NEAR(shocks_json(shocks)["P_standard_errors_apart"].get<double>(), 4, 1e-9);
}

TEST(ComparedShocks, ComeFromTheSamePiston) {
  tests::ScratchDirectory const scratch;
  auto plan = star_to_dpde_plan("quick", 7);
  plan.melt.star = md::star_of_name("6-3"), plan.v_P = 0.5, plan.shock_across = 4, plan.shock_along = 48;
  auto const stages = shock_stages(plan, "out", 0.98288);
  EXPECT_EQ(line_of(stages.front()),
            "mesobridge md piston-shock --star 6-3 --rho0 0.3 --T0 0.98288 --vp 0.5 --cells-across 4 "
            "--cells-along 48 --seed 7 --ranks 1 -o out/shock/melt");
  auto const text = shock_scene(plan, 0.98288, 0.26);
  for (char const* const line : {"lattice = [4, 4, 48]\n", "N = 768\n", "piston = 0.5\n", "bins = 48\n",
                                 "../model/6-3-melt.toml", "seed = 7\n"})
    EXPECT_NE(text.find(line), std::string::npos) << line << text;
  plan.v_P = 0;
  EXPECT_THROW(check(plan), InputError);
}

} // namespace
} // namespace mesobridge::workflows
