#include "md/error.hpp"
#include "workflows/trajectory/unit_style.hpp"
#include <gtest/gtest.h>

namespace mesobridge::workflows {

namespace {

// LAMMPS's own constants mvv2e, update.cpp
TEST(UnitStyle, EnergiesOfMvvAreLammpsOwn) {
  EXPECT_NEAR(unit_style("real").energy_of_mv2, 48.88821291 * 48.88821291, 1e-4);
  EXPECT_NEAR(unit_style("metal").energy_of_mv2, 1.0364269e-4, 1e-11);
  std::size_t tried = 0;
  for (char const* name : {"lj", "si", "cgs", "micro", "nano"}) {
    EXPECT_EQ(unit_style(name).energy_of_mv2, 1) << name;
    ++tried;
  }
  EXPECT_EQ(tried, 5u);
  EXPECT_THROW(unit_style("electron"), InputError);
  EXPECT_THROW(unit_style("Real"), InputError);
}

TEST(UnitStyle, UnitsOfLengthsTimesAndVelocitiesAreRead) {
  EXPECT_DOUBLE_EQ(value_in_si("nm", 1, 0), 1e-9);
  EXPECT_DOUBLE_EQ(value_in_si("Angstrom", 1, 0), 1e-10);
  EXPECT_DOUBLE_EQ(value_in_si("nm+1", 1, 0), 1e-9);
  EXPECT_DOUBLE_EQ(value_in_si("fs", 0, 1), 1e-15);
  EXPECT_DOUBLE_EQ(value_in_si("nm ps-1", 1, -1), 1e3);
  EXPECT_DOUBLE_EQ(value_in_si("ps-1 nm", 1, -1), 1e3);
  EXPECT_DOUBLE_EQ(value_in_si("m s-1", 1, -1), 1);
  std::size_t tried = 0;
  for (char const* bad : {"", "parsec", "ps", "nm2", "nm ps", "nm ps-", "nm ps-1x", "-1"}) {
    EXPECT_THROW(value_in_si(bad, 1, -1), InputError) << bad;
    ++tried;
  }
  EXPECT_EQ(tried, 8u);
}

} // namespace

} // namespace mesobridge::workflows
