#include "interrupted_run.hpp"
#include "refusals.hpp"
#include "scratch_directory.hpp"
#include "workflows/command.hpp"
#include "workflows/store/store.hpp"
#include "workflows/text_file.hpp"
#include <cmath>
#include <gtest/gtest.h>

// These tests run the program itself, as a user would.

namespace mesobridge::workflows {

namespace {

using tests::program;
using tests::ScratchDirectory;
using Words = std::vector<std::string>;

/// Copper by Foiles's potential, whose short cut-off allows a small box.
Words small(std::string const& command, std::string const& directory, Words const& more) {
  Words words{"md",
              command,
              "--potential",
              "Cu_u3.eam",
              "--atoms",
              "108",
              "--equilibration-steps",
              "300",
              "--sampling-steps",
              "2400",
              "--seed",
              "5",
              "-o",
              directory,
              "--json"};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

TEST(MetalProgram, BadInputHasACodeAndOneClearMessage) {
  ScratchDirectory const scratch;
  auto const grid = [&](Words const& more) { return small("metal-grid", scratch / "x", more); };
  auto const hugoniot = [&](Words const& more) { return small("hugoniot", scratch / "x", more); };
  std::vector<tests::Refusal> const cases{
      {{"md", "metal-grid"}, 2, "--potential is required"},
      {{"md", "metal-grid", "--potential", "Xy.eam.alloy"}, 2, "/usr/share/lammps/potentials/Xy.eam.alloy"},
      {{"md", "metal-grid", "--potential", "Cu_u3.eam", "--element", "Sn"},
       2,
       "has no element 'Sn'; it has Cu"},
      {{"md", "metal-grid", "--potential", "Cu.meam"}, 2, "must end in .eam"},
      {grid({"--rho", "100"}), 2, "density [kg/m^3] = 100: must be from half to twice"},
      {grid({"--T", "-5"}), 2, "temperature [K] = -5"},
      {grid({"--lattice", "sc"}), 2, "lattice 'sc': must be fcc, bcc or hcp"},
      {{"md", "metal-grid", "--potential", "Cu_u3.eam", "--atoms", "8", "-o", scratch / "x"}, 2, "too few"},
      {grid({"--start", "gas"}), 2, "--start"},
      {hugoniot({"--compression", "0.9"}), 2, "--compression = 0.9: must be at least 1.01"},
      {hugoniot({"--vp", "9000"}), 2, "v_P [m/s] = 9000: must be"},
      {hugoniot({"--compression", "1.95"}), 3, "no shocked state is to be expected"},
      {small("metal-grid", "/dev/null/x", {}), 4, "/dev/null/x"},
  };
  EXPECT_EQ(tests::expect_refusals(cases), 13);
}

TEST(MetalProgram, AGridIsTheSameOnOneAndTwoRanksAndAfterAResume) {
  ScratchDirectory const scratch;
  Words const states{"--rho", "8900,9500", "--T", "300,900"};
  auto with_ranks = [&](char const* ranks) {
    auto words = small("metal-grid", scratch / ranks, states);
    words.insert(words.end(), {"--ranks", ranks});
    return words;
  };
  auto const two = program(with_ranks("2")), one = program(with_ranks("1"));
  ASSERT_EQ(two.status, 0) << two.errors;
  ASSERT_EQ(one.status, 0) << one.errors;
  EXPECT_EQ(Json::parse(two.output)["states"], Json::parse(one.output)["states"]);
  auto const table = read_text_file(scratch / "2/metal-grid.csv");
  EXPECT_EQ(table, read_text_file(scratch / "1/metal-grid.csv"));
  EXPECT_EQ(table.substr(0, table.find('\n')), "rho_kg_m3,T_K,P_Pa,P_se_Pa,e_J_kg,e_se_J_kg");
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 5);
  Store const store(scratch / "2/metal-grid.h5", Store::Mode::read);
  EXPECT_EQ(store.read_doubles("metal_grid/P_Pa").size(), 4u);
  EXPECT_NE(store.read_text_attribute("provenance", "command").find("--potential Cu_u3.eam"),
            std::string::npos);

  // A run of two of the four states, resumed with all of them, gives the samples of the unbroken run.
  auto words = small("metal-grid", scratch / "3", {"--rho", "8900,9500", "--T", "300", "--ranks", "1"});
  ASSERT_EQ(program(words).status, 0);
  words = small("metal-grid", scratch / "3", states);
  words.insert(words.end(), {"--ranks", "1", "--resume"});
  auto const resumed = program(words);
  ASSERT_EQ(resumed.status, 0) << resumed.errors;
  auto by_state = [](Json states) {
    std::sort(states.begin(), states.end(), [](Json const& a, Json const& b) {
      return std::pair(a["rho_kg_m3"].get<double>(), a["T_K"].get<double>()) <
             std::pair(b["rho_kg_m3"].get<double>(), b["T_K"].get<double>());
    });
    return states;
  };
  EXPECT_EQ(by_state(Json::parse(resumed.output)["states"]), by_state(Json::parse(one.output)["states"]));
  EXPECT_NE(resumed.errors.find("MD of 2 states: done"), std::string::npos) << resumed.errors;
  words.insert(words.end(), {"--time-step", "0.03"});
  auto const other = program(words);
  EXPECT_EQ(other.status, 2);
  EXPECT_NE(other.errors.find("was made with other settings"), std::string::npos) << other.errors;
}

TEST(MetalProgram, AnInterruptedRunSaysSoAndKeepsItsStates) {
  ScratchDirectory const scratch;
  int ran = 0;
  for (std::string const ranks : {"1", "2"}) {
    auto words = small("metal-grid", scratch / ranks,
                       {"--rho", "8900", "--T", "300,600,900", "--ranks", ranks, "--sampling-steps=1000000"});
    std::erase(words, "--sampling-steps");
    std::erase(words, "2400");
    tests::expect_interrupted(words, "go on with --resume", scratch / (ranks + "/metal-runs.h5"), "P_Pa");
    ++ran;
  }
  EXPECT_EQ(ran, 2);
}

TEST(MetalProgram, TheHugoniotCurveClosesAndIsCoppers) {
  ScratchDirectory const scratch;
  auto const result =
      program(small("hugoniot", scratch / "h", {"--compression", "1.08,1.14", "--vp", "900"}));
  ASSERT_EQ(result.status, 0) << result.errors;
  auto const json = Json::parse(result.output);
  auto const& points = json["points"];
  ASSERT_EQ(points.size(), 3u);
  double const rho0 = json["rho0_kg_m3"];
  EXPECT_NEAR(rho0, 8820, 40); // 8935 kg/m^3 at rest, less the thermal expansion; 8933 by experiment
  Json initial;
  for (auto const& state : json["states"])
    if (state["T_K"] == 300 && std::abs(state["rho_kg_m3"].get<double>() - rho0) < 0.06)
      initial = state;
  ASSERT_TRUE(initial.is_object());
  double const P0 = initial["P_Pa"], e0 = initial["e_J_kg"];
  EXPECT_LT(std::abs(P0), 5 * initial["P_se_Pa"].get<double>() + 2e7) << "zero pressure";
  int checked = 0;
  for (auto const& p : points) {
    double const v_P = p["v_P_m_s"], v_S = p["v_S_m_s"], rho = p["rho_kg_m3"], P = p["P_Pa"], e = p["e_J_kg"];
    double const start = p["rho0_kg_m3"];
    EXPECT_NEAR(rho * (v_S - v_P) / (start * v_S), 1, 1e-9);
    EXPECT_NEAR((P - P0) / (start * v_S * v_P), 1, 1e-9);
    EXPECT_NEAR(e - e0, (P + P0) * (1 / start - 1 / rho) / 2, 5 * p["e_se_J_kg"].get<double>());
    // Experiment: v_S = 3940 m/s + 1.489 v_P (Marsh, LASL Shock Hugoniot Data, 1980).
    EXPECT_NEAR(v_S / (3940 + 1.489 * v_P), 1, 0.08);
    EXPECT_EQ(p["phase"], "solid");
    ++checked;
  }
  EXPECT_EQ(checked, 3);
  EXPECT_NEAR(points[2]["v_P_m_s"].get<double>(), 900, 60);
  EXPECT_NEAR(json["us_up"]["s"].get<double>(), 1.49, 0.4);
  auto const table = read_text_file(scratch / "h/hugoniot.csv");
  EXPECT_EQ(table.substr(0, table.find('\n')),
            "rho0_kg_m3,T0_K,P0_Pa,P0_se_Pa,v_P_m_s,v_P_se_m_s,v_S_m_s,v_S_se_m_s,rho_kg_"
            "m3,P_Pa,P_se_Pa,T_K,T_se_K,e_J_kg,e_se_J_kg");
}

} // namespace

} // namespace mesobridge::workflows
