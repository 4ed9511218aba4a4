#include "long_inputs.hpp"
#include "program.hpp"
#include "scratch_directory.hpp"
#include "workflows/command.hpp"
#include "workflows/text_file.hpp"
#include <gtest/gtest.h>

namespace mesobridge::workflows {
namespace {

using tests::program;
using tests::ScratchDirectory;

// Molecules that do not see each other have no potential, and the pressure of an ideal gas.
TEST(CoarsePotential, OfMoleculesAtRandomIsNone) {
  ScratchDirectory const scratch;
  auto const file = scratch / "melt.h5";
  tests::write_many_blobs(file, "melt", 400, 100);
  auto const result = program({"cg", "potential", file.string(), "--cutoff", "3", "--bin-width", "0.3",
                               "--steps", "600", "--iterations", "2", "--threads", "1", "--json"});
  ASSERT_EQ(result.status, 0) << result.errors;
  auto const json = Json::parse(result.output);
  double const ideal = json["density"].get<double>() * json["kT"].get<double>();
  EXPECT_NEAR(json["P"].get<double>() / ideal, 1, 0.1);
  EXPECT_LT(json["g_difference"].get<double>(), 1e-3);
  auto const u = json["u"].get<std::vector<double>>();
  for (std::size_t k = 3; k < u.size(); ++k) // nearer there are hardly any pairs
    EXPECT_LT(std::abs(u[k]), 0.3 * json["kT"].get<double>()) << k;
  EXPECT_TRUE(read_text_file(scratch / "potential.csv").starts_with("r,u\n0,"));
  EXPECT_TRUE(std::filesystem::exists(scratch / "potential.html"));
}

TEST(CoarsePotential, IsRefusedByName) {
  ScratchDirectory const scratch;
  auto const file = scratch / "melt.h5";
  tests::write_many_blobs(file, "melt", 100, 5);
  struct Case {
    std::vector<std::string> more;
    std::string says;
  };
  for (auto const& [more, says] : {Case{{"--cutoff", "1000"}, "cutoff"},
                                   {{"--bin-width", "50"}, "bin width"},
                                   {{"--share", "2"}, "share"},
                                   {{"--iterations", "0"}, "iterations"},
                                   {{"--iterations", "-3"}, "iterations"},
                                   {{"--steps", "100"}, "steps"},
                                   {{"--enough", "nan"}, "enough"},
                                   {{"--pressure"}, "holds no pressures"},
                                   {{"--method", "magic"}, "hnc"}}) {
    std::vector<std::string> words{"cg", "potential", file.string()};
    words.insert(words.end(), more.begin(), more.end());
    auto const result = program(words);
    EXPECT_EQ(result.status, 2) << says;
    EXPECT_NE(result.errors.find(says), std::string::npos) << result.errors;
  }
  EXPECT_FALSE(std::filesystem::exists(scratch / "potential.csv"));
}

} // namespace
} // namespace mesobridge::workflows
