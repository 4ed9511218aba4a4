#include "program.hpp"
#include "scratch_directory.hpp"
#include "sdpd_scene.hpp"
#include "workflows/command/list.hpp"
#include "workflows/text_file.hpp"
#include <gtest/gtest.h>
#include <set>

// Built-in water is near the real one from 940 to 1170 kg/m^3 and from 280 to 350 K: beyond that every
// command that is given a state says so, and inside it none does. Every command on equations of state is
// there.

namespace mesobridge::workflows {
namespace {

using tests::program;
using Words = std::vector<std::string>;

std::string const scene = tests::SdpdScene{.fluid = "eos = \"water\"\nrho = \"997 kg/m^3\"\nT = \"300 K\"\n",
                                           .N = 512,
                                           .K = 1000,
                                           .eta = "1e-3 Pa*s",
                                           .scheme = "dt = 0.01\n",
                                           .run = "steps = 3200\n"}
                              .text();

TEST(UsableRange, IsToldByEveryCommandThatIsGivenAState) {
  tests::ScratchDirectory const scratch;
  auto const file = (scratch / "water.toml").string();
  write_text_file(file, scene);
  auto const table = (scratch / "water.csv").string(), drawing = (scratch / "water.svg").string();
  auto const commands_at = [&](std::string const& rho, std::string const& T) {
    return std::vector<Words>{
        {"eos", "eval", "--model", "water", "--rho", rho, "--T", T},
        {"eos", "hugoniot", "--model", "water", "--rho0", rho, "--T0", T, "--vp", "100"},
        {"eos", "isentrope", "--model", "water", "--rho0", rho, "--T0", T, "--rho", "1100"},
        {"eos", "profile", "--model", "water", "--rho0", rho, "--T0", T, "--vp", "100", "--eta", "1e-3"},
        {"eos", "riemann", "--left", "water", "--rho-left", "1000", "--T-left", "300", "--right", "water",
         "--rho-right", rho, "--T-right", T},
        {"eos", "crussard", "--reactant", "water", "--product", "nitromethane-products", "--rho0", rho,
         "--T0", T, "--q", "4e6", "--P", "2e10"},
        {"eos", "cj", "--reactant", "water", "--product", "nitromethane-products", "--rho0", rho, "--T0", T,
         "--q", "4e6"},
        {"eos", "znd", "--reactant", "water", "--product", "nitromethane-products", "--rho0", rho, "--T0", T,
         "--q", "4e6", "--Z", "1e15", "--Ea", "3e-19", "--D", "9500"},
        {"eos", "explosion", "--reactant", "water", "--product", "nitromethane-products", "--rho0", rho,
         "--T0", T, "--q", "4e6"},
        {"eos", "induction", "--reactant", "water", "--product", "nitromethane-products", "--rho0", rho,
         "--T0", T, "--q", "4e6", "--Z", "1e15", "--Ea", "3e-19", "--vp", "1000"},
        {"eos", "plot", "--model", "water", "--T", T, "--rho-min", "990", "--rho-max", rho, "-o", drawing},
        {"eos", "plot", "--model", "water", "--rho0", rho, "--T0", T, "--rho-min", "990", "--rho-max", "1100",
         "-o", drawing},
        {"eos", "table", "--model", "water", "--rho-min", "950", "--rho-max", rho, "--T-min", "290",
         "--T-max", T, "--rho-points", "3", "--T-points", "3", "-o", table},
        {"check", file, "--set", "fluid.rho=\"" + rho + " kg/m^3\"", "--set", "fluid.T=\"" + T + " K\""}};
  };
  int told = 0, silent = 0;
  for (auto const& words : commands_at("1150", "400")) {
    auto const result = program(words);
    EXPECT_EQ(result.status, 0) << words[1] << result.errors;
    EXPECT_NE(result.errors.find("outside the data of this model (rho from 940 to 1170, T from 280 to 350)"),
              std::string::npos)
        << words[0] << words[1] << ": " << result.errors;
    ++told;
  }
  for (auto const& words : commands_at("997", "300")) {
    auto const result = program(words);
    EXPECT_EQ(result.status, 0) << words[1] << result.errors;
    EXPECT_EQ(result.errors.find("outside the data"), std::string::npos) << result.errors;
    ++silent;
  }
  EXPECT_EQ(told, 14);
  EXPECT_EQ(silent, 14);
  std::set<std::string> tried{"eos list", "eos jwl"}; // no state there
  for (auto const& words : commands_at("997", "300"))
    tried.insert(words[0] + " " + words[1]);
  int of_eos = 0;
  for (auto const& command : commands())
    if (command.name.starts_with("eos ")) {
      EXPECT_TRUE(tried.contains(command.name)) << command.name;
      ++of_eos;
    }
  EXPECT_EQ(of_eos, 14);
}

// Products that detonate into water: the state behind the front is told, too.
TEST(UsableRange, IsToldOfTheProductsOfADetonation) {
  Words const explosive{"--reactant", "nitromethane", "--product", "water", "--rho0",
                        "1104",       "--T0",         "300",       "--q",   "1e6"};
  int told = 0;
  for (Words words : {Words{"eos", "cj"}, Words{"eos", "crussard", "--P", "2e10"}}) {
    words.insert(words.end(), explosive.begin(), explosive.end());
    auto const result = program(words);
    EXPECT_EQ(result.status, 0) << result.errors;
    EXPECT_NE(result.errors.find("water: the state"), std::string::npos) << result.errors;
    EXPECT_NE(result.errors.find("outside the data"), std::string::npos) << result.errors;
    ++told;
  }
  EXPECT_EQ(told, 2);
}

} // namespace
} // namespace mesobridge::workflows
