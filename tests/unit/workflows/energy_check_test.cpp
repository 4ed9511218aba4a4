#include "workflows/trajectory/energy_check.hpp"
#include <gtest/gtest.h>

namespace mesobridge::workflows {
namespace {

/// Warnings of a run whose total energies are these, in units of `unit`.
std::vector<std::string> warnings_of(std::vector<double> const& energies, double unit) {
  EnergyCheck check(EnergyCheck::Laws::of_mapping);
  for (std::size_t k = 0; k < energies.size(); ++k) {
    check.add(static_cast<std::int64_t>(k),
              {.kinetic = unit * (1 + 0.1 * (k % 2 ? 1 : -1)), .potential = unit * (energies[k] - 1)},
              std::nullopt);
  }
  return check.warnings();
}

TEST(EnergyCheck, TellsAWanderOfAnySize) {
  int cases = 0;
  for (double const unit : {1e-150, 1.0, 1e300}) { // of squares beyond all numbers
    auto const wanders = warnings_of({5, 6, 7, 8}, unit);
    ASSERT_EQ(wanders.size(), 1u) << unit;
    EXPECT_NE(wanders[0].find("the total energy wanders"), std::string::npos);
    EXPECT_EQ(wanders[0].find("inf"), std::string::npos) << wanders[0];
    EXPECT_EQ(wanders[0].find("nan"), std::string::npos) << wanders[0];
    ++cases;
  }
  EXPECT_EQ(cases, 3);
}

TEST(EnergyCheck, AsksForWhatTheUserCanMend) {
  for (auto const laws : {EnergyCheck::Laws::of_mapping, EnergyCheck::Laws::of_lammps}) {
    EnergyCheck check(laws);
    for (int k = 0; k < 4; ++k)
      check.add(k, {.kinetic = 1 + 0.01 * (k % 2), .potential = 4.0 + k, .bonds = 1}, 5.0 + k);
    auto const warnings = check.warnings();
    ASSERT_EQ(warnings.size(), 2u);
    bool const by_lammps = laws == EnergyCheck::Laws::of_lammps;
    EXPECT_EQ(warnings[0].find("special_bonds") != std::string::npos, by_lammps) << warnings[0];
    EXPECT_EQ(warnings[0].find("LAMMPS's K") == std::string::npos, by_lammps) << warnings[0];
    EXPECT_EQ(warnings[1].find("data file") != std::string::npos, by_lammps) << warnings[1];
    EXPECT_EQ(warnings[1].find("k or K") == std::string::npos, by_lammps) << warnings[1];
  }
}

TEST(EnergyCheck, SaysNothingOfAnEnergyThatIsKept) {
  EnergyCheck check(EnergyCheck::Laws::of_mapping);
  for (int k = 0; k < 4; ++k) {
    double const kinetic = 1 + 0.1 * (k % 2);
    check.add(k, {.kinetic = kinetic, .potential = 4 - kinetic}, std::nullopt);
  }
  EXPECT_TRUE(check.warnings().empty());
}

} // namespace
} // namespace mesobridge::workflows
