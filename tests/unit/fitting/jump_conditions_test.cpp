#include "fitting/jump_conditions.hpp"
#include "fitting/shock_relations.hpp"
#include "fitting/state_at_rest.hpp"
#include "md/error.hpp"
#include <gtest/gtest.h>

namespace mesobridge::fitting::test {
namespace {

using enum Quantity;

TEST(JumpConditions, AnyTwoQuantitiesOfAShockGiveTheOthers) {
  Fluid const argon(material("argon").eos);
  auto const shock = Hugoniot(argon, argon.at_temperature(1150, 500)).from_piston(500);
  std::vector<Datum> const data{
      {rho, shock.behind.rho}, {P, shock.behind.P}, {v_P, shock.v_P}, {v_S, shock.v_S}};
  int pairs = 0;
  for (auto const& a : data)
    for (auto const& b : data) {
      if (a.quantity == b.quantity)
        continue;
      auto const jump = jump_of(shock.ahead.rho, shock.ahead.P, a, b);
      for (auto const& expected : data)
        EXPECT_NEAR(jump.of(expected.quantity) / expected.value, 1, 1e-9);
      ++pairs;
    }
  EXPECT_EQ(pairs, 12);
}

TEST(JumpConditions, AContradictionIsJudgedByTheErrors) {
  // LASL's copper: 8.93 g/cm^3, v_P = 1 km/s, v_S = 5.408 km/s: P = 48.29 GPa, rho = 10.956 g/cm^3.
  Datum const piston{v_P, 1000}, front{v_S, 5408, 54};
  EXPECT_FALSE(contradiction(8930, 0, piston, front, {{P, 48.293e9}, {rho, 10956}}));
  EXPECT_FALSE(contradiction(8930, 0, piston, front, {{P, 50e9}})) << "54 m/s are 0.48 GPa";
  auto const wrong = contradiction(8930, 0, piston, front, {{rho, 10956}, {P, 42e9}});
  ASSERT_TRUE(wrong);
  EXPECT_EQ(wrong->stated.quantity, P);
  EXPECT_NEAR(wrong->by_jump, 48.293e9, 1e6);
  EXPECT_TRUE(contradiction(8930, 0, piston, {v_S, 5408}, {{P, 50e9}})) << "exact velocities";
  EXPECT_FALSE(contradiction(8930, 1.7e9, piston, {v_S, 5408}, {{P, 50e9}})) << "from 1.7 GPa";
}

Observation shock(double rho_0, double T_0, Observation::AtRest rest) {
  return {.path = DataPath::hugoniot,
          .start = StartState{.rho = rho_0, .T = T_0, .e = {}, .P = {}},
          .given = {{v_P, 500}},
          .measured = {{v_S, 4000, 40}},
          .origin = "data.csv:2",
          .at_rest = rest};
}

TEST(StateAtRest, IsOneDatumAStart) {
  std::vector<Observation> data{shock(8930, 293, {}), shock(8930, 293, {}),
                                shock(8930, 400, {.P = 1e9, .P_is_given = true, .P_se = 1e7, .rho_se = {}}),
                                shock(8900, 293, {.rho_se = 3.0})};
  auto const notes = add_states_at_rest(data);
  ASSERT_EQ(notes.size(), 3u);
  ASSERT_EQ(data.size(), 7u);
  for (std::size_t k = 4; k < 7; ++k)
    EXPECT_NO_THROW(check(data[k]));
  EXPECT_EQ(data[4].given[0].value, 8930);
  EXPECT_DOUBLE_EQ(data[4].given[0].se, 8.93);
  EXPECT_EQ(data[4].measured[0].value, 0);
  EXPECT_NE(notes[0].find("P(8930 kg/m^3, 293 K) = 0 Pa (no P0 is given) counts"), std::string::npos)
      << notes[0];
  EXPECT_EQ(data[5].measured[0].value, 1e9);
  EXPECT_EQ(data[5].measured[0].se, 1e7);
  EXPECT_EQ(data[5].given[0].se, 0);
  EXPECT_EQ(data[6].given[0].se, 3);
}

TEST(StateAtRest, IsNotCountedBesideTheSameStateOfTheData) {
  Observation const known{.path = DataPath::state,
                          .start = {},
                          .given = {{rho, 8930, 8.9}, {T, 293}},
                          .measured = {{P, 1e5, 1e7}},
                          .origin = "data.csv:1"};
  std::vector<Observation> data{known, shock(8930, 293, {})};
  EXPECT_TRUE(add_states_at_rest(data).empty());
  EXPECT_EQ(data.size(), 2u);
}

} // namespace
} // namespace mesobridge::fitting::test
