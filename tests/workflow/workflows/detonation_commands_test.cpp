#include "eos_program.hpp"
#include "scratch_directory.hpp"
#include "workflows/eos/detonation_view.hpp"
#include "workflows/text_file.hpp"
#include <gtest/gtest.h>

// The commands of reaction zones and explosions as their users run them; numbers of an independent code.

namespace mesobridge::workflows {
namespace {

using tests::eos, tests::expect_near, tests::json_of, tests::ScratchDirectory;

std::string const nitromethane =
    " --reactant nitromethane --product nitromethane-products --rho0 1104 --T0 300 --q 4.7159e6";
std::string const rates = " --Z 1e15 --Ea 3e-19";

TEST(DetonationCommands, ZndGivesTheZoneOfAnIndependentSolver) {
  auto const found = json_of("znd" + nitromethane + rates);
  expect_near(found, "D_m_s", 6766.8, 1e-5);
  expect_near(found, "von_neumann_P_Pa", 21.163e9, 3e-5);
  expect_near(found, "von_neumann_rho_kg_m3", 1902.0, 3e-5);
  expect_near(found, "von_neumann_T_K", 2957.6, 2e-5);
  expect_near(found, "zone_m", 12.25e-9, 5e-4);
  expect_near(found, "zone_time_s", 2.79e-12, 2e-3);
  expect_near(found["chapman_jouguet"], "P_Pa", 15.185e9, 1e-4);
  expect_near(found["chapman_jouguet"], "T_K", 4881.2, 1e-5);
  auto const rho = found["curve"]["rho_kg_m3"].get<std::vector<double>>(),
             u = found["curve"]["u_m_s"].get<std::vector<double>>();
  ASSERT_GT(rho.size(), 200u);
  EXPECT_EQ(rho.size(), found["curve"]["lambda"].size());
  for (std::size_t i = 0; i < rho.size(); ++i)
    ASSERT_NEAR(rho[i] * (found["D_m_s"].get<double>() - u[i]) / (1104 * found["D_m_s"].get<double>()), 1,
                1e-12);
}

TEST(DetonationCommands, TheSumOfTheNeighboursIsAChoice) {
  struct Case {
    std::string options;
    double nm, tolerance;
  };
  int ran = 0;
  for (auto const& c : {Case{" --sum density-minus-self", 13.70, 5e-4},
                        {" --sum density-minus-self --self 0.163", 13.70, 5e-4},
                        {" --sum unit", 18.90, 5e-4},
                        {" --volume-law paper", 12.25, 1e-2},
                        {" --P0 0", 12.25, 1e-2}}) {
    expect_near(json_of("znd" + nitromethane + rates + c.options), "zone_m", 1e-9 * c.nm, c.tolerance);
    ++ran;
  }
  EXPECT_EQ(ran, 5);
  auto const at_zero = json_of("znd" + nitromethane + rates + " --P0 0");
  expect_near(at_zero, "D_m_s", 6757.2, 1e-5);
  expect_near(at_zero, "von_neumann_rho_kg_m3", 1901.8, 3e-5);
  expect_near(at_zero, "von_neumann_T_K", 2962.5, 2e-5);
  expect_near(at_zero, "von_neumann_P_Pa", 21.146e9, 3e-5);
}

TEST(DetonationCommands, AnOverdrivenZoneEndsOnTheCrussardCurve) {
  auto const found = json_of("znd" + nitromethane + rates + " --D 7500 --end 0.999999");
  expect_near(found, "D_m_s", 7500, 1e-12);
  double const end = found["end"]["P_Pa"], last = found["curve"]["P_Pa"].back();
  EXPECT_NEAR(last / end, 1, 1e-4);
  EXPECT_GT(end, found["chapman_jouguet"]["P_Pa"]);
  // The Chapman-Jouguet velocity by its printed digits, a hair too slow, is that detonation.
  expect_near(json_of("znd" + nitromethane + rates + " --D 6766.83428"), "zone_m", 12.25e-9, 5e-4);
  auto const slow = eos("znd" + nitromethane + rates + " --D 6000");
  EXPECT_EQ(slow.status, 3);
  EXPECT_NE(slow.errors.find("Jouguet"), std::string::npos) << slow.errors;
}

TEST(DetonationCommands, ExplosionAndInductionAreThoseOfAnIndependentSolver) {
  // Products that took the heat at the initial density: the beginning of the Crussard curve.
  auto const exploded = json_of("explosion" + nitromethane);
  auto const crussard = json_of("crussard" + nitromethane + " --P-max 2e10")["constant_volume"];
  for (auto const* key : {"T_K", "P_Pa", "e_J_kg", "s_J_kg_K"})
    expect_near(exploded, key, crussard[key], 1e-12);
  auto const found = json_of("induction" + nitromethane + rates + " --vp 1764");
  expect_near(found, "induction_s", 189e-12, 4e-3);
  expect_near(found, "frank_kamenetskii_s", 289e-12, 2e-3);
  expect_near(found, "super_detonation_m_s", 9102, 1e-4);
  expect_near(found, "overtaken_at_s", 314e-12, 4e-3);
  expect_near(found, "overtaken_at_m", 1471e-9, 4e-3);
  expect_near(found, "v_S_m_s", 4683.9, 1e-5);
  // The shocked state explodes by itself as behind the shock.
  auto const hot =
      json_of("induction --reactant nitromethane --product nitromethane-products --rho0 1770.956 "
              "--T0 1278.797 --rho-bar 1104 --q 4.7159e6" +
              rates);
  expect_near(hot, "induction_s", found["induction_s"], 1e-4);
}

TEST(DetonationCommands, SlicesAreDrawnOverTheCurves) {
  ScratchDirectory const scratch;
  auto const csv = (scratch / "burnt.csv").string(), svg = (scratch / "view.svg").string();
  write_text_file(csv, "rho_g_cc,P_GPa,P_se_GPa,T_K\n1.9,20.5,0.5,3000\n1.0,4.4,0.2,4000\n");
  auto const slices = read_slices(csv);
  EXPECT_EQ(slices.label, "burnt");
  EXPECT_EQ(slices.rho, (std::vector<double>{1900, 1000}));
  EXPECT_EQ(slices.P_error, (std::vector<double>{0.5e9, 0.2e9}));
  auto const drawn = eos("crussard" + nitromethane + " --P-max 3e10 --slices " + csv + " -o " + svg);
  ASSERT_EQ(drawn.status, 0) << drawn.errors;
  auto const text = read_text_file(svg);
  for (auto const* label : {"burnt", "Rayleigh line", "Chapman-Jouguet and von Neumann", "isentrope"})
    EXPECT_NE(text.find(label), std::string::npos) << label;
  write_text_file(csv, "rho_g_cc,T_K\n1.9,3000\n");
  auto const without = eos("crussard" + nitromethane + " --P-max 3e10 --slices " + csv + " -o " + svg);
  EXPECT_EQ(without.status, 2);
  EXPECT_NE(without.errors.find("burnt.csv:2"), std::string::npos) << without.errors;
  auto const nowhere = eos("crussard" + nitromethane + " --P-max 3e10 --slices " + csv);
  EXPECT_EQ(nowhere.status, 2);
  EXPECT_NE(nowhere.errors.find(".svg or .html"), std::string::npos) << nowhere.errors;
}

TEST(DetonationCommands, TheViewMayBeDrawnOfARunsOwnModels) {
  auto const &reactant = fitting::material("nitromethane").eos,
             &product = fitting::material("nitromethane-products").eos;
  auto const rest = fitting::Fluid(reactant).at_temperature(1104, 300);
  DetonationView const view{"explosive",
                            "products",
                            fitting::Fluid(reactant),
                            fitting::Fluid(product),
                            rest,
                            fitting::Hugoniot(rest, fitting::Fluid(product), 4.7159e6)};
  auto const plot = detonation_plot(view, 2.5e10, 30, {{"slices", {1500, 900}, {13e9, 4e9}}});
  ASSERT_EQ(plot.panels.at(0).series.size(), 6u);
  auto const& line = plot.panels[0].series[2];
  // The line's slope over v_0 is the square of the mass flux.
  EXPECT_NEAR((line.y[1] - line.y[0]) * 1e9 / (line.x[0] - line.x[1]) / 1104 / (6766.834 * 6766.834), 1,
              1e-5);
  auto const& isentrope = plot.panels[0].series[3];
  EXPECT_NEAR(isentrope.x.back(), 1104.0 / 900, 1e-9);
  auto const& states = plot.panels[0].series[4];
  EXPECT_NEAR(states.y.at(1), 21.163, 1e-3);
  EXPECT_EQ(plot.panels[0].series[5].y, (std::vector<double>{13, 4}));
}

TEST(DetonationCommands, ProfilesAreWrittenAsTheEndingSays) {
  ScratchDirectory const scratch;
  int ran = 0;
  for (auto const& [name, content] :
       {std::pair<std::string, std::string>{"z.csv", "lambda,x_m,t_s,P_Pa,rho_kg_m3,T_K,u_m_s"},
        {"z.svg", "Reaction zone of nitromethane"},
        {"z.html", "<svg"}}) {
    auto const file = (scratch / name).string();
    auto const result = eos("znd" + nitromethane + rates + " -o " + file);
    ASSERT_EQ(result.status, 0) << result.errors;
    EXPECT_NE(read_text_file(file).find(content), std::string::npos) << name;
    ++ran;
  }
  EXPECT_EQ(ran, 3);
}

} // namespace
} // namespace mesobridge::workflows
