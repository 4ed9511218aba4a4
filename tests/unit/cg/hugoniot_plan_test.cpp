#include "cg/hugoniot_plan.hpp"
#include "md/error.hpp"
#include "md/units.hpp"
#include "scratch_directory.hpp"
#include <algorithm>
#include <cmath>
#include <functional>
#include <gtest/gtest.h>

namespace mesobridge::cg {

namespace {

using tests::ScratchDirectory;

md::MetalSettings copper(ScratchDirectory const& scratch) {
  auto settings = md::metal_settings(md::Preset::quick, md::read_metal_potential("Cu_u3.eam", ""));
  settings.log_file = scratch / "lammps.log";
  return settings;
}

/// What MD would answer if the crystal's atoms had another heat capacity and Grueneisen parameter than the
/// estimates take, and melted at `T_melt` with a latent heat.
class Nature {
 public:
  Nature(md::MpiWorld const& world, md::MetalSettings const& settings)
      : cold_(world, settings.potential, settings.lattice, settings.log_file),
        mass_(settings.potential.mass) {}

  double T_melt = 1e9;
  double latent_heat = 2e5; // J/kg, copper's
  double pressure_of_melting = 0;

  MetalPoint measure(md::MetalState state) {
    auto const cold = cold_.at(state.rho);
    double const thermal = 3.3 * k_B * state.T / mass_;
    bool const liquid = state.T > T_melt;
    MetalPoint point;
    point.state = state;
    point.e = {cold.e + thermal + (liquid ? latent_heat : 0), 100, 100};
    point.P = {cold.P + 1.5 * state.rho * thermal + (liquid ? pressure_of_melting : 0), 1e7, 100};
    point.phase = liquid ? Phase::liquid : Phase::solid;
    return point;
  }

 private:
  md::MetalCrystal cold_;
  double mass_;
};

struct Outcome {
  HugoniotCurve curve;
  std::vector<MetalPoint> known;
  int rounds = 0;
};

/// Plays the plan to its end.
Outcome play(HugoniotRequest const& request, Nature& nature, md::MetalSettings const& settings, Phase start) {
  md::QuasiharmonicMetal metal(md::MpiWorld(), settings);
  Outcome outcome;
  for (; outcome.rounds < 20; ++outcome.rounds) {
    outcome.curve = plan_hugoniot(request, metal, start, outcome.known);
    if (outcome.curve.missing.empty())
      break;
    for (auto const& state : outcome.curve.missing) {
      for (auto const& point : outcome.known)
        EXPECT_FALSE(point.state == state) << "asked for twice: " << state.rho << ", " << state.T;
      outcome.known.push_back(nature.measure(state));
    }
  }
  return outcome;
}

/// h(T) of a point, from what nature answers there.
double hugoniot_function(Nature& nature, HugoniotPoint const& point) {
  auto const initial = nature.measure(point.initial), there = nature.measure({point.rho, point.T.mean});
  return there.e.mean - initial.e.mean -
         (there.P.mean + initial.P.mean) * (1 / point.initial.rho - 1 / point.rho) / 2;
}

TEST(HugoniotPlan, FindsTheCurveOfAMetalThatDiffersFromItsEstimates) {
  ScratchDirectory const scratch;
  auto const settings = copper(scratch);
  Nature nature(md::MpiWorld(), settings);
  HugoniotRequest const request{.T0 = 300, .rho0 = {}, .compressions = {1.05, 1.2, 1.3}, .v_P = {600}};
  auto const [curve, known, rounds] = play(request, nature, settings, Phase::solid);
  EXPECT_LE(rounds, 4);
  EXPECT_TRUE(curve.unsolved.empty());
  ASSERT_EQ(curve.points.size(), 4u);
  ASSERT_TRUE(curve.initial);
  EXPECT_LT(std::abs(nature.measure(*curve.initial).P.mean), 3e7) << "zero pressure";
  int checked = 0;
  for (auto const& point : curve.points) {
    EXPECT_LT(std::abs(hugoniot_function(nature, point)), 1.0) << point.rho; // J/kg, of 1e5 and more
    EXPECT_GE(point.states, 2);
    ++checked;
  }
  EXPECT_EQ(checked, 4);
  EXPECT_TRUE(std::any_of(curve.points.begin(), curve.points.end(),
                          [](auto const& p) { return std::abs(p.v_P.mean - 600) < 30; }));
}

TEST(HugoniotPlan, MadeAnewFromTheSameStatesItIsTheSame) {
  ScratchDirectory const scratch;
  auto const settings = copper(scratch);
  Nature nature(md::MpiWorld(), settings);
  HugoniotRequest const request{.T0 = 300, .rho0 = {}, .compressions = {1.1, 1.25}, .v_P = {}};
  auto const [curve, known, rounds] = play(request, nature, settings, Phase::solid);
  md::QuasiharmonicMetal another(md::MpiWorld(), settings); // with another history
  another.shocked({8800, 500}, 10000);
  auto const again = plan_hugoniot(request, another, Phase::solid, known);
  EXPECT_TRUE(again.missing.empty());
  ASSERT_EQ(again.points.size(), curve.points.size());
  for (std::size_t k = 0; k < curve.points.size(); ++k)
    EXPECT_EQ(again.points[k].T.mean, curve.points[k].T.mean);
}

TEST(HugoniotPlan, FollowsTheDensityOfZeroPressureFarFromItsEstimate) {
  ScratchDirectory const scratch;
  auto const settings = copper(scratch);
  Nature nature(md::MpiWorld(), settings);
  nature.T_melt = 100, nature.pressure_of_melting = 8e9; // a liquid is less dense by some per cent
  HugoniotRequest const request{.T0 = 1400, .rho0 = {}, .compressions = {1.2}, .v_P = {}};
  auto const [curve, known, rounds] = play(request, nature, settings, Phase::liquid);
  ASSERT_TRUE(curve.initial);
  EXPECT_LT(std::abs(nature.measure(*curve.initial).P.mean), 5e7);
  md::QuasiharmonicMetal metal(md::MpiWorld(), settings);
  EXPECT_LT(curve.initial->rho, 0.97 * metal.zero_pressure_density(1400));
  EXPECT_EQ(curve.points.size(), 1u);
}

TEST(HugoniotPlan, TakesOnePhaseAndEndsWhereThereIsNone) {
  ScratchDirectory const scratch;
  auto const settings = copper(scratch);
  Nature nature(md::MpiWorld(), settings);
  HugoniotRequest const request{.T0 = 300, .rho0 = 8800, .compressions = {1.3}, .v_P = {}};
  auto const solid = play(request, nature, settings, Phase::solid).curve.points;
  ASSERT_EQ(solid.size(), 1u);
  double const T_solid = solid[0].T.mean;

  nature.T_melt =
      0.5 * T_solid; // the latent heat leaves a liquid solution below T_solid, above the melting point
  nature.latent_heat = 5e4;
  auto const melted = play(request, nature, settings, Phase::solid);
  ASSERT_EQ(melted.curve.points.size(), 1u);
  EXPECT_EQ(melted.curve.points[0].phase, Phase::liquid);
  EXPECT_LT(melted.curve.points[0].T.mean, T_solid);

  nature.T_melt = 0.98 * T_solid; // a crystal's solution would be liquid, a liquid's would be a crystal
  nature.latent_heat = 2e5;
  auto const none = play(request, nature, settings, Phase::solid);
  EXPECT_LT(none.rounds, 20);
  EXPECT_TRUE(none.curve.points.empty());
  ASSERT_EQ(none.curve.unsolved.size(), 1u);
}

} // namespace

} // namespace mesobridge::cg
