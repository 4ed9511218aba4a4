#include "fitting/model_file.hpp"
#include "program.hpp"
#include "scratch_directory.hpp"
#include "workflows/command.hpp"
#include "workflows/text_file.hpp"
#include <gtest/gtest.h>
#include <sstream>

// Another explosive through files alone: the commands of workflows/README.md, as they stand there.

namespace mesobridge::workflows {
namespace {

using tests::ScratchDirectory;

std::string const source = MESOBRIDGE_SOURCE_DIR "/workflows/";

/// The words of a command line, of which quotes hold some together.
std::vector<std::string> words_of(std::string const& line) {
  std::vector<std::string> words;
  std::istringstream stream(line);
  for (std::string word; stream >> word;) {
    for (std::string more; word.starts_with('"') && !word.ends_with('"') && stream >> more;)
      word += " " + more;
    if (word.starts_with('"'))
      word = word.substr(1, word.size() - 2);
    words.push_back(word);
  }
  return words;
}

/// The commands that README shows for the explosive, lines that end with \ joined, in the order of the page;
/// its folders out/ and workflows/ in their places here.
std::vector<std::vector<std::string>> documented(std::string const& out) {
  std::istringstream readme(read_text_file(source + "README.md"));
  std::vector<std::vector<std::string>> commands;
  bool ours = false;
  for (std::string line, more; std::getline(readme, line);) {
    ours = line.starts_with("#") ? line == "## Another explosive" : ours;
    for (; line.ends_with('\\') && std::getline(readme, more); line += more)
      line.pop_back();
    if (!ours || !line.starts_with("    build/mesobridge "))
      continue;
    auto words = words_of(line);
    words.erase(words.begin());
    for (auto& word : words)
      for (auto const& [from, to] :
           {std::pair<std::string, std::string>{"out/", out + "/"}, {"workflows/", source}})
        if (word.starts_with(from))
          word = to + word.substr(from.size());
    commands.push_back(words);
  }
  return commands;
}

/// The parameters of a shipped model are those of the file that a command has written.
template <class Model>
void expect_shipped(std::string const& name, std::string const& fitted) {
  auto const path = source + "scenes/models/" + name;
  auto const ours = std::get<Model>(fitting::parse_model(read_text_file(path), path).eos).parameters(),
             theirs = std::get<Model>(fitting::parse_model(read_text_file(fitted), fitted).eos).parameters();
  for (auto const& parameter : Model::description().parameters) {
    double const value = ours.*parameter.member;
    EXPECT_NEAR(theirs.*parameter.member, value, 1e-4 * std::abs(value)) << parameter.name;
  }
}

TEST(AnotherExplosive, ComesFromFilesAloneByTheCommandsOfTheReadme) {
  ScratchDirectory const scratch;
  std::map<std::string, Json> said;
  for (auto words : documented(scratch.path().string())) {
    std::string const name =
        words.at(0) == "eos" || words.at(0) == "fit" ? words.at(0) + " " + words.at(1) : words.at(0);
    if (name == "run") // the beginning of it
      for (auto const* word :
           {"--set", "run.steps=64", "--set", "run.sample_every=2", "--threads", "1", "--quiet"})
        words.emplace_back(word);
    words.emplace_back("--json");
    auto const result = tests::program(words);
    ASSERT_TRUE(result.status == 0 || (name == "run" && result.status == 3)) << name << "\n" << result.errors;
    said[name] = Json::parse(result.output);
  }
  ASSERT_EQ(said.size(), 7u); // new, two fits, eval, cj, znd, run
  auto const folder = scratch.path().string() + "/comp-b/models/";
  expect_shipped<fitting::MieGruneisen>("comp-b.toml", folder + "comp-b.toml");
  expect_shipped<fitting::Jwl>("comp-b-products.toml", folder + "comp-b-products.toml");
  // Dobratz and Crawford 1985: 7980 m/s, 29.5 GPa.
  EXPECT_NEAR(said["eos cj"]["D_m_s"].get<double>(), 7980, 0.01 * 7980);
  EXPECT_NEAR(said["eos cj"]["P_Pa"].get<double>(), 29.5e9, 0.01 * 29.5e9);
  // What its energies count from: q = E_0 - e.
  EXPECT_NEAR(said["eos eval"]["e_J_kg"].get<double>() + said["eos cj"]["q_J_kg"].get<double>(), 4.9505e6,
              100);
  // Near the line of the rows, at the von Neumann state: D = 3030 m/s + 1.73 v_P, P = rho_0 D v_P.
  auto const& zone = said["eos znd"];
  double const D = zone["D_m_s"], v_P = (D - 3030) / 1.73;
  EXPECT_NEAR(zone["von_neumann_P_Pa"].get<double>(), 1717 * D * v_P, 0.05 * 1717 * D * v_P);
}

} // namespace
} // namespace mesobridge::workflows
