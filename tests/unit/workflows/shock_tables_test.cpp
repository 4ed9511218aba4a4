#include "fitting/eos/list.hpp"
#include "workflows/shock_study/shock_tables.hpp"
#include <gtest/gtest.h>

namespace mesobridge::workflows {
namespace {

ShockRow row(double factor) {
  return {.model = "SDPD",
          .K = 100,
          .eta = 2e-3,
          .dt_reduced = 0.02,
          .spacing = 1.8e-9,
          .particles = 1000,
          .Re_l = 1.5,
          .v_S = {1975.0 * factor, 2, 6},
          .rho = {1539.8, 0.2, 6},
          .mass_per_volume = {1539.8, 0.5, 6},
          .P = {1.4661e9 * factor, 1e6, 6},
          .T = {968.9, 0.3, 6},
          .T_kin = {969, 3, 6},
          .depth = {-2e-9, 0, 2e-9},
          .profile = {1540, 1345, 1150},
          .profile_se = {1, 1, 1}};
}

TEST(ShockVerdicts, PassWithinTheBoundAndFailBeyond) {
  auto const exact = argon_shock("argon", 1150, 500, 500);
  for (auto const& line : shock_verdicts({row(1.005), row(0.995)}, exact, 0.01, "all"))
    EXPECT_EQ(line.verdict, Verdict::passed) << line.what << line.found;
  auto const off = shock_verdicts({row(1), row(1.03)}, exact, 0.01, "all");
  ASSERT_EQ(off.size(), 4u);
  EXPECT_EQ(off[0].verdict, Verdict::failed); // v_S
  EXPECT_EQ(off[1].verdict, Verdict::passed); // rho
  EXPECT_EQ(off[2].verdict, Verdict::failed); // P
  EXPECT_EQ(off[3].verdict, Verdict::passed); // T
  EXPECT_NE(off[0].found.find("+3.0"), std::string::npos) << off[0].found;
}

TEST(ShockTable, HasOursBesideThePrintedAndAReasonWhereARunFailed) {
  auto const printed = published("thesis-table-5.2.csv");
  auto const ours = row(1);
  ShockRow const failed{.model = "SSA", .K = 5, .failure = "particle 3 ended"};
  auto const exact = argon_shocks(1150, 500, 500);
  auto const table = shock_table({{"", ours, "100"}, {"", failed, ""}}, exact, printed, "");
  ASSERT_EQ(table.rows.size(), 5u);
  for (auto const& cells : table.rows)
    EXPECT_EQ(cells.size(), table.header.size());
  EXPECT_EQ(table.rows[0][5], "1900"); // printed v_S
  EXPECT_EQ(table.rows[1][4], "fails");
  EXPECT_EQ(table.rows[2][5], "1975");
  auto const json = row_json(ours, printed, "100");
  for (auto const* key : {"v_S_m_s", "rho_kg_m3", "P_Pa", "T_K", "mass_per_volume_kg_m3"}) {
    EXPECT_TRUE(json.contains(key)) << key;
    EXPECT_TRUE(json.contains(std::string(key) + "_se")) << key;
  }
  EXPECT_EQ(json["printed_P_Pa"], 1.39e9);
  EXPECT_EQ(json["Re_l"], 1.5);
  EXPECT_EQ(row_json(failed, printed, "")["failure"], "particle 3 ended");
  EXPECT_FALSE(row_json(failed, printed, "").contains("v_S_m_s"));
}

TEST(FrontPlot, IsInTheParticlesUnitOrInNanometres) {
  auto const ours = row(1);
  auto const exact = argon_shock("argon", 1150, 500, 500);
  auto const profile = fitting::shock_profile(fitting::Fluid(fitting::material("argon").eos), exact,
                                              {.shear_viscosity = 2e-3});
  auto const in_nm = front_plot("a", "b", {{"K = 100", ours, ""}}, profile, exact, std::nullopt),
             in_spacings = front_plot("a", "b", {{"K = 100", ours, ""}}, profile, exact, 0.386e-9);
  ASSERT_EQ(in_nm.panels[0].series.size(), 2u);
  EXPECT_NEAR(in_nm.panels[0].series[0].x[0], -2, 1e-12);
  EXPECT_NEAR(in_spacings.panels[0].series[0].x[0], -2 / 1.8, 1e-12);
  EXPECT_GT(in_spacings.panels[0].series[1].x.size(), 10u); // Navier-Stokes
}

} // namespace
} // namespace mesobridge::workflows
