#include "workflows/coarse/star_to_dpde.hpp"
#include "workflows/coarse/structure_of_blobs.hpp"
#include <gtest/gtest.h>

namespace mesobridge::workflows {
namespace {

/// Two molecules of 5 atoms and mass 4 with opposite momenta of 2, each with 6 of motion inside.
BlobData two_molecules(double T_of_thermostat) {
  BlobData data;
  data.head.molecules = 2, data.head.atoms = 5, data.head.mass = 4, data.head.T = T_of_thermostat;
  data.steps = {0}, data.times = {0};
  data.P = {{2, 0, 0}, {-2, 0, 0}}, data.U_kin = {6, 6};
  return data;
}

// 2 P^2/M = 2 of the centres, which have 3 freedoms; 2 + 24 of all atoms, which have 27.
TEST(StructureOfBlobs, TakesTheTemperatureFromAllThatMovesFreely) {
  EXPECT_DOUBLE_EQ(kT_of(two_molecules(0)), 2.0 / 3);
  EXPECT_DOUBLE_EQ(kT_of(two_molecules(1)), 26.0 / 27);
}

TEST(StructureOfBlobs, CutsWhereNothingIsLeftOfTheStructure) {
  cg::RadialBins bins{.width = 0.1, .g = std::vector<double>(100, 1.001)};
  bins.g[29] = 1.05;
  EXPECT_DOUBLE_EQ(usual_cutoff(bins, false), 3);
  EXPECT_DOUBLE_EQ(usual_cutoff(bins, true), 3.9);
  bins.g[95] = 0.95; // noise
  EXPECT_DOUBLE_EQ(usual_cutoff(bins, false), 8);
  EXPECT_DOUBLE_EQ(usual_cutoff(bins, true), 8);
}

TEST(StarToDpdePlan, HoldsThinMeltsLonger) {
  EXPECT_EQ(steps_at(0.3, 10000, 10), 10000);
  EXPECT_EQ(steps_at(0.5, 10000, 10), 10000);
  EXPECT_EQ(steps_at(0.2, 10000, 10), 18370);
  EXPECT_EQ(steps_at(0.1, 10000, 10), 51960);
  EXPECT_EQ(steps_at(1e-30, 10000, 10), 100000);
  EXPECT_EQ(sample_every_at(0.3, 25), 25); // and dense ones are seen more often
  EXPECT_EQ(sample_every_at(0.5, 25), 10);
}

TEST(StarToDpdePlan, KnowsWhichPairsFitIntoABox) {
  auto plan = star_to_dpde_plan("quick", 1);
  plan.melt.star = md::star_of_name("6-3"), plan.melt.rho = 19; // a distance of 1 between molecules
  EXPECT_EQ(least_across(plan, 2.5), 6);
  EXPECT_EQ(least_across(plan, 2.7), 7);
}

} // namespace
} // namespace mesobridge::workflows
