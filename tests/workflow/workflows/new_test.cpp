#include "scratch_directory.hpp"
#include "workflows/command/list.hpp"
#include "workflows/command_line.hpp"
#include "workflows/scene/keys.hpp"
#include "workflows/text_file.hpp"
#include <algorithm>
#include <gtest/gtest.h>
#include <sstream>

namespace mesobridge::workflows {
namespace {

using tests::ScratchDirectory;

std::filesystem::path const shipped = MESOBRIDGE_SOURCE_DIR "/workflows/scenes";

struct Outcome {
  int code;
  std::string errors;
};

Outcome outcome(std::vector<std::string> const& words) {
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  int const code = run_command_line(words, commands());
  testing::internal::GetCapturedStdout();
  return {code, testing::internal::GetCapturedStderr()};
}

/// How many keys stand in a commented scene; each must have its meaning right above it.
int commented_keys(std::string const& text) {
  int keys = 0;
  std::string section, comment;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("["))
      section = line.substr(1, line.find(']') - 1);
    auto const key = std::ranges::find_if(scene_keys(), [&](auto const& candidate) {
      return candidate.section == section && candidate.name == line.substr(0, line.find(" = "));
    });
    if (key != scene_keys().end()) {
      EXPECT_NE(comment.find(key->meaning), comment.npos) << key->path() << " below: " << comment;
      ++keys;
    }
    comment = line.starts_with("# ") ? comment + line.substr(2) + " " : "";
  }
  return keys;
}

/// Paths of models as the scene's text has them; they must be of files that are the same everywhere.
Scene with_models_at(Scene scene, std::filesystem::path const& folder) {
  auto const relative = [&](std::string& model) {
    if (!model.ends_with(".toml"))
      return;
    auto const place = std::filesystem::path(model).lexically_relative(std::filesystem::absolute(folder));
    EXPECT_EQ(read_text_file(model), read_text_file(shipped / place));
    model = place.string();
  };
  relative(scene.fluid.eos);
  for (auto* const model : {&scene.reaction.product, &scene.particles.model})
    if (*model)
      relative(**model);
  return scene;
}

TEST(New, WritesEveryShippedSceneSoThatItRunsAsItStandsAndEveryKeyIsExplained) {
  ScratchDirectory const scratch;
  int scenes = 0;
  for (auto const& entry : std::filesystem::directory_iterator(shipped)) {
    if (entry.is_directory())
      continue; // the models that they name
    auto const file = scratch / entry.path().filename().string();
    auto const wrote = outcome({"new", entry.path().stem().string(), "-o", file.string()});
    ASSERT_EQ(wrote.code, 0) << wrote.errors;
    EXPECT_EQ(with_models_at(load_scene(file), scratch.path()),
              with_models_at(load_scene(entry.path()), shipped));
    auto const checked = outcome({"check", file.string()});
    EXPECT_EQ(checked.code, 0) << checked.errors;
    EXPECT_GE(commented_keys(read_text_file(file)), 12);
    ++scenes;
  }
  EXPECT_GE(scenes, 5);
}

TEST(New, ReplacesNoFile) {
  ScratchDirectory const scratch;
  auto const file = scratch / "mine.toml";
  write_text_file(file, "mine");
  auto const result = outcome({"new", "ideal-gas", "-o", file.string()});
  EXPECT_EQ(result.code, 2);
  EXPECT_NE(result.errors.find(file.string()), std::string::npos) << result.errors;
  EXPECT_EQ(read_text_file(file), "mine");
}

TEST(New, LeavesModelsThatAreThere) {
  ScratchDirectory const scratch;
  auto const model = scratch / "models" / "comp-b.toml";
  std::filesystem::create_directories(model.parent_path());
  auto const mine = "# mine\n" + read_text_file(shipped / "models" / "comp-b.toml");
  write_text_file(model, mine);
  auto const file = scratch / "mine.toml";
  auto const wrote = outcome({"new", "detonation-comp-b", "-o", file.string()});
  ASSERT_EQ(wrote.code, 0) << wrote.errors;
  EXPECT_EQ(read_text_file(model), mine);
  EXPECT_EQ(load_scene(file).fluid.eos, model.string());
  EXPECT_TRUE(std::filesystem::exists(scratch / "models" / "comp-b-products.toml"));
}

TEST(New, NamesTheScenesThereAre) {
  auto const result = outcome({"new", "idealgas"});
  EXPECT_EQ(result.code, 2);
  EXPECT_NE(result.errors.find("did you mean 'ideal-gas'"), std::string::npos) << result.errors;
  EXPECT_NE(result.errors.find("dpde-fluid"), std::string::npos) << result.errors;
}

} // namespace
} // namespace mesobridge::workflows
