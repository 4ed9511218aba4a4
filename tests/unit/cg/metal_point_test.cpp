#include "cg/metal_point.hpp"
#include "md/units.hpp"
#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace mesobridge::cg::test {
namespace {

constexpr md::MetalState state{.rho = 9000, .T = 1000};

md::MetalSettings copper() {
  return md::metal_settings(md::Preset::quick, md::read_metal_potential("Cu_mishin1.eam.alloy", ""));
}

/// Independent samples of known means, whose kinetic parts follow the temperature of each sample.
std::vector<md::MetalSample> samples(double e, double P, double growth_of_displacement_m2) {
  auto const settings = copper();
  double const R = k_B / settings.potential.mass;
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;
  std::vector<md::MetalSample> result;
  constexpr int n = 2000;
  for (int k = 0; k < n; ++k) {
    double const T = state.T + 30 * normal(random), potential = normal(random);
    result.push_back({.step = 20 * (k + 1),
                      .T = T,
                      .e = e + 1.5 * R * (T - state.T) + 1000 * potential,
                      .P = P + state.rho * R * (T - state.T) + 1e8 * (0.8 * potential + 0.6 * normal(random)),
                      .displacement_2 = growth_of_displacement_m2 * k / n});
  }
  return result;
}

TEST(MetalPoint, EstimatesAreInSiWithTheKineticPartsExact) {
  auto const point = analyse_metal(state, copper(), samples(5e5, 2e10, 0), {.lattice_order = 0.9});
  EXPECT_TRUE(agrees(point.e, 5e5, 4));
  EXPECT_TRUE(agrees(point.P, 2e10, 4));
  EXPECT_TRUE(agrees(point.T_kin, 1000, 4));
  // 2000 independent samples of spreads 1000 J/kg and 1e8 Pa, which correlate by 0.8; the kinetic noise,
  // which is far larger in e (5900 J/kg), is gone. At most a half of the samples may be cut.
  EXPECT_NEAR(point.e.se, 1000 / std::sqrt(double(point.samples)), 4);
  EXPECT_NEAR(point.P.se, 1e8 / std::sqrt(double(point.samples)), 4e5);
  EXPECT_NEAR(point.cov_eP / (point.e.se * point.P.se), 0.8, 0.1);
  EXPECT_EQ(point.end.lattice_order, 0.9);
  // c_v = 3/2 R + <de^2> N m/(k_B T^2).
  double const mass = copper().potential.mass, expected = 1.5 * k_B / mass + 1e6 * 256 * mass / (k_B * 1e6);
  EXPECT_NEAR(point.c_v.mean / expected, 1, 0.1);
}

TEST(MetalPoint, APhaseIsALiquidWhenItsAtomsDiffuse) {
  double const d =
      md::CrystalBlock(md::Lattice::fcc, 1).neighbour_distance(state.rho / copper().potential.mass);
  auto const phase = [&](double growth) {
    return analyse_metal(state, copper(), samples(5e5, 2e10, growth * d * d), {}).phase;
  };
  EXPECT_EQ(phase(0), Phase::solid);
  EXPECT_EQ(phase(0.2), Phase::solid); // 0.1 in the second half
  EXPECT_EQ(phase(0.5), Phase::liquid);
  EXPECT_EQ(name_of(Phase::liquid), "liquid");
}

TEST(MetalPoint, TooFewSamplesAreRefusedWithTheState) {
  auto few = samples(5e5, 2e10, 0);
  few.resize(30);
  EXPECT_THROW(analyse_metal(state, copper(), few, {}), InputError);
  // One slow wave: far fewer independent samples than samples.
  auto slow = samples(5e5, 2e10, 0);
  slow.resize(200);
  for (std::size_t k = 0; k < slow.size(); ++k)
    slow[k].e += 1e5 * std::sin(0.01 * double(k));
  try {
    analyse_metal(state, copper(), slow, {});
    FAIL() << "no refusal";
  } catch (PhysicsError const& error) {
    EXPECT_NE(std::string(error.what()).find("Cu at 9000 kg/m^3, 1000 K"), std::string::npos) << error.what();
  }
}

} // namespace
} // namespace mesobridge::cg::test
