#include "workflows/reproduce/structure_study.hpp"
#include "workflows/sdpd/known_structure.hpp"
#include <cmath>
#include <gtest/gtest.h>

namespace mesobridge::workflows {
namespace {

TEST(StructureStudy, NamesWhatParticlesAre) {
  StructureCase const large{"cubic", 65, 1e4};
  auto const of = [&](double paired, double crystal, double moved, double se) {
    return structure_of(
        large,
        {.failure = {}, .paired = {paired, se, 30}, .crystal = {crystal, se, 30}, .moved = {moved, se, 30}});
  };
  EXPECT_EQ(of(0, 0, 0.2, 0.01), StructureKind::fluid);
  EXPECT_EQ(of(0, 0, 0.05, 0.01), StructureKind::glass);
  EXPECT_EQ(of(0.4, 0, 0.2, 0.01), StructureKind::paired);
  EXPECT_EQ(of(0.4, 0, 0.2, 0.3), StructureKind::fluid); // by chance
  EXPECT_EQ(of(0, 0.5, 0.2, 0.01), StructureKind::crystal);
  EXPECT_EQ(name_of(StructureKind::paired), "pairs");
}

FoundStructure run_of(double crystal, double moved, double se) {
  return {.failure = {}, .paired = {0, se, 30}, .crystal = {crystal, se, 30}, .moved = {moved, se, 30}};
}

TEST(StructureStudy, CountsWhatRunsBecame) {
  StructureCase const of{"wendland-c2", 65, 1e4};
  FoundStructure const crystal = run_of(0.9, 0, 0.01), glass = run_of(0, 0, 0.01),
                       stops{.failure = "too hot"};
  auto const text = [&](std::vector<FoundStructure> const& runs) { return verdict_of(of, runs).text(); };
  EXPECT_EQ(text({glass, glass, glass}), "glass");
  EXPECT_EQ(text({glass, crystal, crystal}), "crystal 2 of 3, glass 1 of 3");
  EXPECT_EQ(text({stops, run_of(0, 1, 0.01)}), "fluid 1 of 2, stops 1 of 2");
  EXPECT_EQ(text({stops}), "stops");
  auto const verdict = verdict_of(of, std::vector{glass, crystal, stops});
  EXPECT_EQ(verdict.count(StructureKind::crystal), 1u);
  EXPECT_EQ(verdict.count(StructureKind::paired), 0u);
  EXPECT_EQ(verdict.stopped, 1u);
}

TEST(StructureStudy, TakesTheLargerErrorOverRuns) {
  FoundStructure const stops{.failure = "too hot"};
  // 0.1, 0.2, 0.6: spread (0.07/3)^(1/2) of the mean 0.3
  std::vector<FoundStructure> const apart{run_of(0.1, 0, 0.01), stops, run_of(0.2, 0, 0.01),
                                          run_of(0.6, 0, 0.01)};
  auto const spread = over_runs(apart, &FoundStructure::crystal);
  ASSERT_TRUE(spread);
  EXPECT_NEAR(spread->mean, 0.3, 1e-12);
  EXPECT_NEAR(spread->se, std::sqrt(0.07 / 3), 1e-12);
  EXPECT_EQ(spread->n_eff, 90);
  std::vector<FoundStructure> const alike{run_of(0.3, 0, 0.06), run_of(0.3, 0, 0.08)};
  EXPECT_NEAR(over_runs(alike, &FoundStructure::crystal)->se, 0.05, 1e-12);
  EXPECT_FALSE(over_runs(std::vector{stops}, &FoundStructure::crystal));
}

// What the README says of argon, in shorter runs: one fluid, one of pairs, a glass and a crystal.
TEST(StructureStudy, FindsPairsGlassesCrystalsAndFluids) {
  struct Case {
    StructureCase of;
    StructureKind kind;
  };
  int ran = 0;
  for (auto const& [of, kind] :
       {Case{{"wendland-c4", 65, 100}, StructureKind::fluid}, Case{{"cubic", 65, 1e3}, StructureKind::paired},
        Case{{"wendland-c4", 65, 1e4}, StructureKind::glass},
        Case{{"wendland-c2", 65, 1e6}, StructureKind::crystal}}) {
    auto const found =
        find_structure(of, {.kernels = {}, .neighbours = {}, .K = {}, .time = 120}, 1, [] { return true; });
    ASSERT_TRUE(found.failure.empty()) << found.failure;
    EXPECT_EQ(structure_of(of, found), kind)
        << of.kernel << ' ' << of.K << ": paired " << found.paired.mean << ", crystal " << found.crystal.mean
        << ", moved " << found.moved.mean;
    EXPECT_EQ(known_structure(of.kernel, of.neighbours, of.K).has_value(),
              kind == StructureKind::paired || kind == StructureKind::crystal);
    ++ran;
  }
  EXPECT_EQ(ran, 4);
}

TEST(StructureStudy, PlansEveryCaseOnce) {
  StructurePlan const plan{.kernels = {"cubic", "lucy"}, .neighbours = {30, 65, 110}, .K = {10, 100}};
  auto const cases = cases_of(plan);
  ASSERT_EQ(cases.size(), 12u);
  EXPECT_EQ(cases.back().kernel, "lucy");
  EXPECT_EQ(cases.back().neighbours, 110);
  EXPECT_EQ(cases[1].K, 100);
}

} // namespace
} // namespace mesobridge::workflows
