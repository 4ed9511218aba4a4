#include "long_inputs.hpp"
#include "program.hpp"
#include "scratch_directory.hpp"
#include "sdpd_scene.hpp"
#include "soft_scene.hpp"
#include "workflows/command.hpp"
#include "workflows/text_file.hpp"
#include <gtest/gtest.h>

namespace mesobridge::workflows {
namespace {

using tests::program;
using tests::ScratchDirectory;

/// Runs a scene into a folder of its own.
std::filesystem::path run_of(ScratchDirectory const& scratch, std::string const& name,
                             std::string const& scene) {
  write_text_file(scratch / (name + ".toml"), scene);
  auto const result = program({"run", (scratch / (name + ".toml")).string(), "-o", (scratch / name).string(),
                               "--quiet", "--threads", "1"});
  EXPECT_EQ(result.status, 0) << result.errors;
  return scratch / name;
}

std::string soft_scene(std::string const& friction, std::string const& run) {
  return tests::SoftScene{.method = "dpd", .run = run, .friction = friction}.text();
}

Json transport_of(std::filesystem::path const& folder, std::vector<std::string> const& more = {}) {
  std::vector<std::string> words{"cg", "transport", folder.string(), "--json"};
  words.insert(words.end(), more.begin(), more.end());
  auto const result = program(words);
  EXPECT_EQ(result.status, 0) << result.errors;
  return result.status == 0 ? Json::parse(result.output) : Json::object();
}

double in_se(Json const& json, std::string const& key, double value) {
  return std::abs(json.at(key).get<double>() - value) / json.at(key + "_se").get<double>();
}

// The DPD fluid of Groot and Warren: 0.81 by waves of force (sdpd/README.md, Flow); more friction makes
// particles slower and the fluid thicker.
TEST(Transport, OfRunsIsMeasuredAndComparedByTheSameCode) {
  ScratchDirectory const scratch;
  std::string const run = "equilibrate = 300\nsteps = 8000\ntrajectory_every = 10\n";
  auto const thin = run_of(scratch, "thin", soft_scene("gamma_par = 4.5\ncutoff = 1\n", run)),
             thick = run_of(scratch, "thick", soft_scene("gamma_par = 20\ncutoff = 1\n", run));
  auto const first = transport_of(thin);
  EXPECT_LT(in_se(first, "eta", 0.81), 4) << first["eta"] << first["eta_se"];
  EXPECT_LT(first["eta_se"].get<double>(), 0.12);
  EXPECT_LT(in_se(first, "temperature", 1), 4);
  EXPECT_EQ(first["units"], "reduced Lennard-Jones");
  double const L = std::cbrt(216.0 / 3),
               share = 2.837297 * first["temperature"].get<double>() / (6 * 3.14159265358979 * L);
  EXPECT_NEAR(first["D_infinite"].get<double>() - first["D"].get<double>(),
              share / first["eta"].get<double>(), 1e-9);
  EXPECT_GT(first["D_infinite_se"].get<double>(), first["D_se"].get<double>());
  auto const second = transport_of(thick, {"--beside", (thin / "transport.json").string()});
  auto const& beside = second.at("beside");
  EXPECT_LT(beside.at("D_difference_in_se").get<double>(), -6);
  EXPECT_GT(beside.at("eta_difference_in_se").get<double>(), 4);
  EXPECT_EQ(beside.at("D"), first["D"]);
  EXPECT_NEAR(beside.at("D_ratio").get<double>(), second["D"].get<double>() / first["D"].get<double>(),
              1e-12);
  EXPECT_NE(read_text_file(thick / "transport.html").find("Beside small"), std::string::npos);
  auto const itself = transport_of(thin, {"--beside", thin.string(), "-o", (scratch / "again").string()});
  EXPECT_EQ(itself.at("beside").at("D_difference_in_se").get<double>(), 0);
  auto const by_hand = transport_of(thin, {"--viscosity", "0.5", "-o", (scratch / "by-hand").string()});
  EXPECT_NEAR(by_hand["D_infinite"].get<double>() - by_hand["D"].get<double>(), share / 0.5, 1e-9);
}

// T = 1000 K at any size of the particles, D in m^2/s, the viscosity in Pa s.
TEST(Transport, OfAnSdpdRunIsInSi) {
  ScratchDirectory const scratch;
  auto const folder = run_of(
      scratch, "gas",
      tests::ideal_gas_scene("equilibrate = 200\nsteps = 4000\nsample_every = 50\ntrajectory_every = 2\n")
          .text());
  auto const json = transport_of(folder);
  EXPECT_EQ(json["units"], "SI");
  EXPECT_NEAR(json["temperature"].get<double>(), 1000, 60);
  EXPECT_NEAR(json["density"].get<double>(), 1150, 1e-6);
  EXPECT_GT(json["D"].get<double>(), 1e-11);
  EXPECT_LT(json["D"].get<double>(), 1e-6);
  EXPECT_LT(in_se(json, "eta", 2e-3), 4) << json["eta"]; // that is asked for: a gas has no other
  EXPECT_LT(json["eta_se"].get<double>(), 2e-4);
}

TEST(Transport, SaysWhyThereIsNoViscosity) {
  ScratchDirectory const scratch;
  auto const folder = run_of(
      scratch, "short", soft_scene("gamma_par = 4.5\ncutoff = 1\n", "steps = 400\ntrajectory_every = 10\n"));
  auto const json = transport_of(folder);
  EXPECT_FALSE(json.contains("eta"));
  EXPECT_NE(json.at("eta_missing").get<std::string>().find("at least"), std::string::npos);
  EXPECT_FALSE(json.contains("D_infinite"));
  EXPECT_NE(read_text_file(folder / "transport.html").find("No viscosity"), std::string::npos);
}

TEST(Transport, IsRefusedByName) {
  ScratchDirectory const scratch;
  std::string const friction = "gamma_par = 4.5\ncutoff = 1\n";
  std::filesystem::create_directories(scratch / "nothing");
  auto const bare = run_of(scratch, "bare", soft_scene(friction, "steps = 400\nsample_every = 10\n"));
  auto const one = run_of(scratch, "one",
                          soft_scene(friction, "steps = 400\nsample_every = 10\ntrajectory_every = 400\n"));
  auto const walls = run_of(
      scratch, "walls",
      soft_scene(friction, "steps = 400\nsample_every = 10\ntrajectory_every = 10\n[box]\nz = \"walls\"\n"));
  auto const driven = run_of(
      scratch, "driven",
      soft_scene(
          friction,
          "steps = 400\nsample_every = 10\ntrajectory_every = 10\n[box]\nbody_force = 0.1\nwaves = 1\n"));
  auto const good =
      run_of(scratch, "good", soft_scene(friction, "steps = 400\nsample_every = 10\ntrajectory_every = 5\n"));
  transport_of(good);
  auto other = Json::parse(read_text_file(good / "transport.json"));
  other["units"] = "SI";
  write_text_file(scratch / "si.json", other.dump());
  other.erase("displacement_se");
  write_text_file(scratch / "spoilt.json", other.dump());
  struct Case {
    std::vector<std::string> words;
    std::string says;
  };
  int refused = 0;
  for (auto const& [words, says] :
       {Case{{(scratch / "nothing").string()}, "no folder of a run"},
        Case{{bare.string()}, "trajectory_every"}, Case{{one.string()}, "at least 16 are needed"},
        Case{{walls.string()}, "not periodic along z"}, Case{{driven.string()}, "body_force"},
        Case{{good.string(), "--waves", "9"}, "1 ... 6"},
        Case{{good.string(), "--blocks", "3"}, "at least 8"},
        Case{{good.string(), "--beside", (scratch / "no.json").string()}, "no.json"},
        Case{{good.string(), "--beside", (scratch / "si.json").string()}, "units"},
        Case{{good.string(), "--beside", (scratch / "spoilt.json").string()}, "displacement_se"}}) {
    std::vector<std::string> all{"cg", "transport"};
    all.insert(all.end(), words.begin(), words.end());
    auto const result = program(all);
    EXPECT_EQ(result.status, 2) << says << result.errors;
    EXPECT_NE(result.errors.find(says), std::string::npos) << says << "\n" << result.errors;
    ++refused;
  }
  EXPECT_EQ(refused, 10);
}

} // namespace
} // namespace mesobridge::workflows
