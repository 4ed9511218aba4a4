#include "eos_program.hpp"
#include "md/error.hpp"
#include "scratch_directory.hpp"
#include "workflows/store/store.hpp"
#include "workflows/text_file.hpp"
#include <algorithm>
#include <gtest/gtest.h>

// The commands of `mesobridge eos` as their users run them.

namespace mesobridge::workflows {
namespace {

using tests::eos, tests::expect_near, tests::json_of, tests::ScratchDirectory;

struct ExpectedJump {
  std::string line;
  double v_S, rho, P, T, tolerance;
};

TEST(EosCommands, HugoniotGivesTheValuesOfAnIndependentSolverAndTheThesis) {
  std::vector<ExpectedJump> const cases{
      // The values beside fitting/README.md, Eq. (F14), of an independent solver
      {"--model argon --rho0 1150 --T0 500 --vp 500", 1975.0, 1539.8, 1.4661e9, 968.9, 1e-4},
      {"--model nitromethane --rho0 1104 --T0 300 --vp 2500", 6109.9, 1868.6, 16.82e9, 2329, 2e-4},
      {"--model ideal-gas --rho0 1150 --T0 1000 --vp 1661", 2314.1, 4074.7, 4.579e9, 8139, 1e-4},
      // Thesis, Table 5.2 ("EoS") and Table 4.2 ("RH"; its T = 8244 K contradicts its own P and rho)
      {"--model argon --rho0 1150 --T0 500 --vp 500", 1975, 1540, 1.47e9, 969, 3e-3},
      {"--model ideal-gas --rho0 1150 --T0 1000 --vp 1661", 2314, 4075, 4.58e9, 8139, 3e-4},
  };
  int ran = 0;
  for (auto const& c : cases) {
    auto const found = json_of("hugoniot " + c.line);
    expect_near(found, "v_S_m_s", c.v_S, c.tolerance);
    expect_near(found, "rho_kg_m3", c.rho, c.tolerance);
    expect_near(found, "P_Pa", c.P, c.tolerance);
    expect_near(found, "T_K", c.T, c.tolerance);
    ++ran;
  }
  EXPECT_EQ(ran, 5);
}

TEST(EosCommands, HugoniotTakesAnyOfFourQuantities) {
  std::string const argon = "hugoniot --model argon --rho0 1150 --T0 500";
  auto const by_piston = json_of(argon + " --vp 500");
  int ran = 0;
  for (auto const& [option, key] :
       {std::pair{" --vs ", "v_S_m_s"}, {" --P ", "P_Pa"}, {" --rho ", "rho_kg_m3"}}) {
    auto const other = json_of(argon + option + by_piston[key].dump());
    expect_near(other, "v_P_m_s", 500, 1e-9);
    ++ran;
  }
  EXPECT_EQ(ran, 3);
}

TEST(EosCommands, HugoniotOfAGasOfAnyGamma) {
  // A shock so strong compresses towards (gamma + 1)/(gamma - 1).
  auto const air = json_of("hugoniot --model ideal-gas --gamma 1.4 --rho0 1 --T0 300 --vp 1e6");
  expect_near(air, "rho_kg_m3", 6, 1e-5);
}

TEST(EosCommands, ReducedModelsPrintReducedKeys) {
  auto const found = json_of("hugoniot --model lj --rho0 0.8 --T0 2 --vp 2");
  for (auto const* key : {"v_S", "rho", "P", "T", "e"})
    EXPECT_TRUE(found.contains(key)) << key;
  // rho_1 (v_S - v_P) = rho_0 v_S
  expect_near(found, "rho", 0.8 * found["v_S"].get<double>() / (found["v_S"].get<double>() - 2), 1e-10);
}

TEST(EosCommands, ChapmanJouguetIsThatOfAnIndependentSolver) {
  std::string const line = "cj --reactant nitromethane --product nitromethane-products";
  auto const found = json_of(line + " --rho0 1104 --T0 300 --q 4.716e6");
  expect_near(found, "D_m_s", 6757, 1e-4);
  expect_near(found, "rho_kg_m3", 1578.6, 2e-4);
  expect_near(found, "P_Pa", 15.15e9, 2e-4);
  expect_near(found, "T_K", 4882, 1e-4);
  EXPECT_NEAR(found["tangency_error"].get<double>(), 0, 1e-7);
  EXPECT_GT(found["least_excess_of_D_nearby"], 0);
  // The calibration of the products (Table 6.3), and the heat that gives what the thesis quotes.
  expect_near(json_of(line + " --rho0 1128 --T0 300 --q 0"), "D_m_s", 6280, 2e-4);
  expect_near(json_of(line + " --rho0 1104 --T0 300 --q 3.52e6"), "D_m_s", 6620, 1e-4);
  auto const help = eos("cj --help");
  for (auto const* number : {"6757", "6620", "6280", "3.52e6"})
    EXPECT_NE(help.output.find(number), std::string::npos) << number;
}

TEST(EosCommands, CrussardHoldsTheChapmanJouguetState) {
  std::string const explosive =
      " --reactant nitromethane --product nitromethane-products --rho0 1104 --T0 300 --q 4.716e6";
  auto const cj = json_of("cj" + explosive);
  auto const at_density = json_of("crussard" + explosive + " --rho " + cj["rho_kg_m3"].dump());
  expect_near(at_density, "v_S_m_s", cj["D_m_s"], 1e-9);
  expect_near(at_density, "P_Pa", cj["P_Pa"], 1e-9);
  auto const slow = eos("crussard" + explosive + " --vs 6000");
  EXPECT_EQ(slow.status, 3);
  EXPECT_NE(slow.errors.find("Chapman and Jouguet"), std::string::npos) << slow.errors;
  EXPECT_LE(
      std::ranges::min(
          json_of("crussard" + explosive + " --P-max 3e10")["curve"]["v_S_m_s"].get<std::vector<double>>()),
      1.001 * cj["D_m_s"].get<double>());
}

TEST(EosCommands, IsentropeReleasesToZeroPressure) {
  auto const found = json_of("isentrope --model water --rho0 1100 --T0 400 --rho 1000");
  // T ~ (1/rho - b)^(1 - gamma), P + P_inf ~ (1/rho - b)^-gamma with gamma = 1.19, P_inf = 0.62178 GPa
  double const ratio = (1.0 / 1000 - 6.7212e-4) / (1.0 / 1100 - 6.7212e-4);
  expect_near(found, "T_K", 400 * std::pow(ratio, -0.19), 1e-12);
  double const P_0 = found["from"]["P_Pa"], P_1 = found["P_Pa"];
  EXPECT_NEAR((P_1 + 6.2178e8) / (P_0 + 6.2178e8), std::pow(ratio, -1.19), 1e-12);
  auto const to_zero = json_of("isentrope --model water --rho0 1100 --T0 400 --P 0");
  EXPECT_NEAR(to_zero["P_Pa"].get<double>(), 0, 1);
}

TEST(EosCommands, ProfileJoinsTheStatesOfTheHugoniot) {
  auto const found = json_of("profile --model argon --rho0 1150 --T0 500 --vp 500 --eta 1e-4");
  expect_near(found, "v_S_m_s", 1975.0, 1e-4);
  auto const v = found["curve"]["v_m_s"].get<std::vector<double>>();
  ASSERT_GT(v.size(), 100u);
  EXPECT_NEAR(v.front(), 500, 1e-2);
  EXPECT_NEAR(v.back(), 0, 1e-2);
  EXPECT_GT(found["thickness_m"], 0);
}

TEST(EosCommands, RiemannIsSymmetricForEqualHalves) {
  // Each half of a head-on collision is shocked as by a piston.
  auto const found = json_of("riemann --left argon --rho-left 1150 --T-left 500 --u-left 500 --right argon "
                             "--rho-right 1150 --T-right 500 --u-right -500");
  expect_near(found, "P_Pa", 1.4661e9, 1e-4);
  EXPECT_NEAR(found["u_m_s"].get<double>(), 0, 1e-6);
  EXPECT_EQ(found["left_wave"]["kind"], "shock");
  expect_near(found["right_wave"], "head_m_s", 1975.0 - 500, 1e-4);
  expect_near(found["left_of_contact"], "T_K", 968.9, 1e-4);
}

std::size_t count(std::string const& text, std::string const& part) {
  std::size_t found = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
    ++found;
  return found;
}

TEST(EosCommands, CurvesAreWrittenAsTheEndingSays) {
  ScratchDirectory const scratch;
  struct Case {
    std::string line, file, content;
  };
  std::string const nitromethane = " --reactant nitromethane --product nitromethane-products --rho0 1104 "
                                   "--T0 300 --q 4.716e6 --P-max 3e10";
  std::vector<Case> const cases{
      {"hugoniot --model argon --rho0 1150 --T0 500 --vp 500", "h.csv", "v_P_m_s,v_S_m_s,rho_kg_m3,T_K,P_Pa"},
      {"hugoniot --model argon --rho0 1150 --T0 500 --P-max 2e9", "h.svg", "behind"},
      {"hugoniot --model argon --rho0 1150 --T0 500 --vp 500", "h.html", "<svg"},
      {"crussard" + nitromethane, "c.svg", "Rayleigh line"},
      {"crussard" + nitromethane, "c.csv", "v_S_m_s"},
      {"isentrope --model tin --rho0 9000 --T0 1500 --P 0", "i.svg", "Isentrope of tin"},
      {"plot --model argon --model ideal-gas --T 300 1000 --rho0 1150 --T0 500 --rho-min 900 --rho-max 1600",
       "p.svg", "isentrope"},
      {"plot --model lj --T 2 --rho-min 0.1 --rho-max 1", "p.html", "P*"},
      {"profile --model argon --rho0 1150 --T0 500 --vp 500 --eta 1e-4 --kappa 0.1", "f.svg",
       "Shock front in argon"},
      {"riemann --left nitromethane-products --rho-left 1600 --T-left 4000 --right water --rho-right 1050 "
       "--T-right 300",
       "r.svg", "Riemann problem"},
      {"table --model lj --rho-min 0.1 --rho-max 1 --T-min 1 --T-max 5", "t.csv",
       "rho,T,P,e,s,c_v,sound_speed"},
  };
  int ran = 0;
  for (auto const& [line, name, content] : cases) {
    auto const file = (scratch / name).string();
    auto const result = eos(line + " -o " + file);
    ASSERT_EQ(result.status, 0) << line << "\n" << result.errors;
    auto const text = read_text_file(file);
    if (name != "h.svg")
      EXPECT_NE(text.find(content), std::string::npos) << line;
    else
      EXPECT_EQ(text.find(content), std::string::npos); // no shock was asked for
    EXPECT_NE(result.output.find(file), std::string::npos);
    ++ran;
  }
  EXPECT_EQ(ran, 11);
  EXPECT_EQ(count(read_text_file(scratch / "h.csv"), "\n"), 61u); // head and 60 points
}

TEST(EosCommands, TheTableIsTheModel) {
  ScratchDirectory const scratch;
  auto const file = (scratch / "t.h5").string();
  auto const summary =
      json_of("table --model argon --rho-min 100 --rho-max 1600 --rho-points 4 --T-min 90 --T-max 990 "
              "--T-points 3 -o " +
              file);
  EXPECT_EQ(summary["states"], 12);
  EXPECT_GT(summary["mechanically_unstable_states"],
            0); // 100 kg/m^3 at 90 K ... lies inside the liquid-gas region
  Store const store(file, Store::Mode::read);
  EXPECT_EQ(store.shape("P_Pa"), (Store::Shape{4, 3}));
  EXPECT_EQ(store.read_text_attribute("P_Pa", "unit"), "Pa");
  EXPECT_NE(store.read_text_attribute("provenance", "command").find("eos table"), std::string::npos);
  auto const rho = store.read_doubles("rho_kg_m3"), T = store.read_doubles("T_K"),
             P = store.read_doubles("P_Pa"), c_2 = store.read_doubles("sound_speed_squared_m2_s2");
  auto const state = json_of(fmt::format("eval --model argon --rho {} --T {}", rho[2], T[1]));
  EXPECT_DOUBLE_EQ(P[2 * 3 + 1], state["P_Pa"].get<double>());
  EXPECT_NEAR(std::sqrt(c_2[2 * 3 + 1]) / state["sound_speed_m_s"].get<double>(), 1, 1e-12);
}

TEST(EosCommands, BadInputHasACodeAndOneClearMessage) {
  struct Case {
    std::string line;
    int code;
    std::string message;
  };
  std::vector<Case> const cases{
      {"hugoniot --model argon --rho0 1150 --T0 500", 2, "one of them must be given"},
      {"hugoniot --model argon --rho0 1150 --T0 500 --vp 1 --vs 2", 2, "at most one"},
      {"hugoniot --model argon --rho0 1150 --T0 500 --vp -5", 2, "v_P = -5"},
      {"hugoniot --model argon --rho0 -1 --T0 500 --vp 5", 2, "--rho0 = -1"},
      {"hugoniot --model argon --rho0 1150 --T0 nan --vp 5", 2, "--T0 = nan"},
      {"hugoniot --model argn --rho0 1150 --T0 500 --vp 5", 2, "argn"},
      {"hugoniot --model argon --rho0 1150 --T0 500 --vs 900", 3, "sound speed"},
      {"hugoniot --model argon --rho0 1150 --T0 500 --vp 1e5", 3, "outside the model"},
      {"hugoniot --model argon --rho0 1150 --T0 500 --vp 5 -o x.txt", 2, "must end in .csv, .svg or .html"},
      {"cj --reactant nitromethane --product lj --rho0 1104 --T0 300 --q 1e6", 2, "same units"},
      {"cj --reactant nitromethane --product nitromethane-products --rho0 1104 --T0 300", 2, "--q"},
      {"isentrope --model tin --rho0 9000 --T0 1500", 2, "exactly one"},
      {"isentrope --model tin --rho0 9000 --T0 1500 --P -1e12", 3, "does not reach pressure"},
      {"profile --model argon --rho0 1150 --T0 500 --vp 500 --eta -1", 2, "shear viscosity = -1"},
      {"riemann --left tin --rho-left 7775 --T-left 300 --u-left -2000 --right tin --rho-right 7775 "
       "--T-right 300 "
       "--u-right 2000",
       3, "a vacuum opens"},
      {"plot --model argon --rho-min 1 --rho-max 2 -o x.svg", 2, "give --T"},
      {"plot --model argon --T 300 --rho-min 3 --rho-max 2 -o x.svg", 2, "--rho-max = 2"},
      {"plot --model argon --T 300 --rho-min 1 --rho-max 2", 2, "a file must be given"},
      {"table --model argon --rho-min 800 --rho-max 1e5 --T-min 200 --T-max 300 -o x.csv", 3, "outside"},
      {"table --model argon --rho-min 800 --rho-max 900 --T-min 200 --T-max 300 -o x.txt", 2, ".csv or .h5"},
  };
  int ran = 0;
  for (auto const& [line, code, message] : cases) {
    tests::expect_refusal(eos(line), code, message);
    ++ran;
  }
  EXPECT_EQ(ran, 20);
}

} // namespace
} // namespace mesobridge::workflows
