#include "long_inputs.hpp"
#include "pair_monte_carlo.hpp"
#include "program.hpp"
#include "scratch_directory.hpp"
#include "workflows/command.hpp"
#include "workflows/text_file.hpp"
#include <array>
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

/// A soft fluid of particles with the mass 2 and k_BT = 1, the forces on them with noise, as a melt's blobs.
void write_soft_fluid(std::filesystem::path const& file, std::uint64_t seed) {
  constexpr int side = 6, frames = 300;
  constexpr double density = 1, mass = 2;
  auto const law = tests::soft(20);
  tests::PairMonteCarlo fluid(law, side, density, 0.4, seed);
  for (int k = 0; k < 100; ++k)
    fluid.sweep();
  int const molecules = side * side * side;
  BlobFile blobs(file,
                 {.kind = "melt",
                  .name = "soft",
                  .fingerprint = "test",
                  .molecules = molecules,
                  .atoms = 1,
                  .mass = mass,
                  .rho = density,
                  .T = 1},
                 {.command = "test", .seed = seed, .scene = "", .inputs = {}});
  std::mt19937_64 bits(seed);
  std::normal_distribution<double> normal;
  auto const any = [&] { return Vec3{normal(bits), normal(bits), normal(bits)}; };
  std::vector<cg::BlobFrame> all;
  for (int k = 0; k < frames; ++k) {
    fluid.sweep(), fluid.sweep();
    cg::BlobFrame frame{.step = k, .time = 0.1 * k, .box = fluid.box(), .blobs = {}};
    auto const& R = fluid.positions();
    auto const F = tests::forces_of(law, R, fluid.box());
    for (std::size_t m = 0; m < R.size(); ++m)
      frame.blobs.push_back({.R = R[m], .P = std::sqrt(mass) * any(), .F = F[m] + 3.0 * any()});
    all.push_back(std::move(frame));
  }
  blobs.append(all);
  blobs.close();
}

/// u in the middles of the bins, of one method.
std::vector<double> found_by(std::filesystem::path const& file, std::filesystem::path const& folder,
                             std::vector<std::string> const& more) {
  std::vector<std::string> words{"cg",          "potential",     file.string(), "--cutoff", "1",
                                 "--bin-width", "0.1",           "--threads",   "1",        "--json",
                                 "-o",          folder.string(), "--steps",     "1000"};
  words.insert(words.end(), more.begin(), more.end());
  auto const result = program(words);
  EXPECT_EQ(result.status, 0) << result.errors;
  return Json::parse(result.output)["u"].get<std::vector<double>>();
}

// Two series of one fluid: their differences are the errors of inversion, which says none.
TEST(CoarsePotential, ByForcesIsThatOfTheStructureInASoftFluid) {
  ScratchDirectory const scratch;
  std::array<std::vector<double>, 2> inverted, matched;
  for (std::size_t k : {0u, 1u}) {
    auto const file = scratch / fmt::format("soft-{}.h5", k);
    write_soft_fluid(file, 20 + k);
    inverted[k] = found_by(file, scratch / "inverted", {"--iterations", "4"});
    matched[k] = found_by(file, scratch / "matched", {"--method", "force-matching"});
  }
  auto const json = Json::parse(read_text_file(scratch / "matched/potential.json"));
  auto const errors = json["u_se"].get<std::vector<double>>(), r = json["r"].get<std::vector<double>>();
  std::size_t const n = errors.size();
  ASSERT_EQ(inverted[0].size(), n);
  ASSERT_LT(json["first"].get<double>(), 0.3);
  auto const bin_of = [&](double at) { return std::size_t(at / (r[1] - r[0])); };
  double spread = 0, apart = 0, count = 0;
  for (std::size_t k = bin_of(0.3); k < n; ++k) {
    spread += 0.25 * std::pow(inverted[0][k] - inverted[1][k], 2) + 0.5 * std::pow(errors[k], 2);
    apart += std::pow(0.5 * (inverted[0][k] + inverted[1][k] - matched[0][k] - matched[1][k]), 2), count += 1;
    EXPECT_NEAR(0.5 * (matched[0][k] + matched[1][k]), 10 * std::pow(1 - r[k], 2), 0.1)
        << r[k]; // 1 % of u(0)
  }
  EXPECT_LT(std::sqrt(apart / count), 3 * std::sqrt(spread / count) + 0.02);
  EXPECT_LT(std::sqrt(spread / count), 0.2);
  EXPECT_LT(json["g_difference"].get<double>(), 1e-3);
  EXPECT_GT(json["explained"].get<double>(), 0.3);
  auto const text =
      program({"cg", "potential", (scratch / "soft-1.h5").string(), "--cutoff", "1", "--bin-width", "0.1",
               "--threads", "1", "-o", (scratch / "beside").string(), "--steps", "600", "--method",
               "force-matching", "--beside", (scratch / "inverted/potential.csv").string()});
  EXPECT_NE(text.output.find("standard errors, at r ="), std::string::npos) << text.output << text.errors;
  EXPECT_NE(read_text_file(scratch / "beside/potential.html").find("u apart in se"), std::string::npos);
}

TEST(CoarsePotential, ByForcesIsRefusedByName) {
  ScratchDirectory const scratch;
  auto const file = scratch / "soft.h5", none = scratch / "none.h5", one = scratch / "one.h5";
  write_soft_fluid(file, 3);
  tests::write_many_blobs(none, "melt", 100, 20);
  tests::write_many_blobs(one, "melt", 100, 1);
  write_text_file(scratch / "other.csv", "r,v\n0,1\n1,0\n");
  struct Case {
    std::filesystem::path file;
    std::vector<std::string> more;
    std::string says;
  };
  for (auto const& [of, more, says] : {Case{none, {}, "all in the file are zero"},
                                       {one, {}, "at least 4"},
                                       {file, {"--cutoff", "3.1"}, "half of the box"},
                                       {file, {"--knots", "1e-5"}, "too close"},
                                       {file, {"--knots", "-1"}, "knots"},
                                       {file, {"--pressure"}, "--method hnc"},
                                       {file, {"--share", "1"}, "--share"},
                                       {file, {"--beside", (scratch / "other.csv").string()}, "u"},
                                       {file, {"--beside", "missing.csv"}, "missing.csv"}}) {
    std::vector<std::string> words{"cg", "potential", of.string(), "--method", "force-matching"};
    if (says != "half of the box")
      words.insert(words.end(),
                   {"--cutoff", of == file ? "1" : "3", "--bin-width", of == file ? "0.1" : "0.3"});
    words.insert(words.end(), more.begin(), more.end());
    auto const result = program(words);
    EXPECT_EQ(result.status, 2) << says << result.errors;
    EXPECT_NE(result.errors.find(says), std::string::npos) << result.errors;
  }
  auto const knots = program({"cg", "potential", file.string(), "--knots", "1"});
  EXPECT_EQ(knots.status, 2);
  EXPECT_NE(knots.errors.find("--method force-matching"), std::string::npos) << knots.errors;
  EXPECT_FALSE(std::filesystem::exists(scratch / "potential.csv"));
}

/// Molecules held anywhere, on which a pair force and noise with a memory of two frames act.
void write_held_fluid(std::filesystem::path const& file, tests::PairLaw const& law) {
  constexpr int molecules = 60, configurations = 6, frames = 200;
  HeldFile held(file, tests::held_head(molecules), frames,
                {.command = "test", .seed = 1, .scene = "", .inputs = {}});
  tests::RandomBlobs random(std::cbrt(19 * molecules / 0.3), 5);
  std::mt19937_64 bits(3);
  std::normal_distribution<double> normal;
  for (int c = 0; c < configurations; ++c) {
    auto frame = random.frame(0, molecules);
    std::vector<Vec3> R, noise(molecules);
    for (auto const& blob : frame.blobs)
      R.push_back(blob.R);
    auto const F = tests::forces_of(law, R, frame.box);
    for (int k = 0; k < frames; ++k) {
      frame.step = c * frames + k, frame.time = 0.02 * double(frame.step);
      for (std::size_t m = 0; m < molecules; ++m) {
        noise[m] = 0.6 * noise[m] + 0.8 * Vec3{normal(bits), normal(bits), normal(bits)};
        frame.blobs[m].U_kin = 27, frame.blobs[m].F = F[m] + noise[m];
      }
      held.append(frame);
    }
  }
  held.close();
}

// Mean forces at held centres, and the temperature of the motion about them.
TEST(CoarsePotential, ByForcesTakesHeldMolecules) {
  ScratchDirectory const scratch;
  auto const file = scratch / "held.h5";
  tests::PairLaw const law{6, {}, [](double r) { return 2 * (1 - r / 6); }};
  write_held_fluid(file, law);
  auto const result = program({"cg", "potential", file.string(), "--method", "force-matching", "--cutoff",
                               "6", "--bin-width", "0.6", "--steps", "600", "--threads", "1", "--json"});
  ASSERT_EQ(result.status, 0) << result.errors;
  auto const json = Json::parse(result.output);
  EXPECT_EQ(json["blocks"].get<int>(), 6);
  EXPECT_NEAR(json["kT"].get<double>(), 1, 1e-9); // 27 of motion inside, 54 freedoms
  EXPECT_FALSE(json.contains("P_target"));
  EXPECT_GT(json["explained"].get<double>(), 0.9);
  auto const f = json["f"].get<std::vector<double>>(), errors = json["f_se"].get<std::vector<double>>(),
             r = json["r"].get<std::vector<double>>();
  for (std::size_t k = 3; k + 1 < f.size(); ++k) {
    EXPECT_NEAR(f[k], law.f(r[k]), 5 * errors[k]) << r[k];
    EXPECT_LT(errors[k], 0.1) << r[k];
  }
}

} // namespace
} // namespace mesobridge::workflows
