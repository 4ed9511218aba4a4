#include "workflows/reproduce/structure_study.hpp"
#include "workflows/sdpd/known_structure.hpp"
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
