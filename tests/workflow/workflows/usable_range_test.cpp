#include "program.hpp"
#include "scratch_directory.hpp"
#include "workflows/text_file.hpp"
#include <gtest/gtest.h>

// Built-in water is near the real one from 940 to 1170 kg/m^3 and from 280 to 350 K: beyond that every
// command that is given a state says so, and inside it none does.

namespace mesobridge::workflows {
namespace {

using tests::program;
using Words = std::vector<std::string>;

constexpr char const* scene = R"(title = "water"
[fluid]
eos = "water"
rho = "997 kg/m^3"
T = "300 K"
[particles]
N = 512
K = 1000
[transport]
eta = "1e-3 Pa*s"
[scheme]
dt = 0.01
[run]
steps = 3200
)";

TEST(UsableRange, IsToldByEveryCommandThatIsGivenAState) {
  tests::ScratchDirectory const scratch;
  auto const file = (scratch / "water.toml").string();
  write_text_file(file, scene);
  auto const commands_at = [&](std::string const& rho, std::string const& T) {
    return std::vector<Words>{
        {"eos", "eval", "--model", "water", "--rho", rho, "--T", T},
        {"eos", "hugoniot", "--model", "water", "--rho0", rho, "--T0", T, "--vp", "100"},
        {"eos", "isentrope", "--model", "water", "--rho0", rho, "--T0", T, "--rho", "1100"},
        {"eos", "profile", "--model", "water", "--rho0", rho, "--T0", T, "--vp", "100", "--eta", "1e-3"},
        {"eos", "riemann", "--left", "water", "--rho-left", "1000", "--T-left", "300", "--right", "water",
         "--rho-right", rho, "--T-right", T},
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
  EXPECT_EQ(told, 6);
  EXPECT_EQ(silent, 6);
}

} // namespace
} // namespace mesobridge::workflows
