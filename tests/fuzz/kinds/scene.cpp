#include "fuzz/change_text.hpp"
#include "fuzz/kinds/kinds.hpp"
#include "fuzz/kinds/tiny_run.hpp"
#include "soft_scene.hpp"
#include "workflows/command.hpp"
#include "workflows/scene/keys.hpp"
#include "workflows/text_file.hpp"
#include <fmt/format.h>

// Scenes with odd values: `check` and `run` refuse the same, with the same words, and nothing runs away.

namespace mesobridge::fuzz {
namespace {

constexpr double dear = 2; ///< seconds by check's own estimate (of a build without sanitizers): not run then

void prepare(std::filesystem::path const& folder) {
  workflows::write_text_file(folder / "sdpd.toml", tiny_scene);
  workflows::write_text_file(folder / "soft.toml",
                             tests::SoftScene{.run = "equilibrate = 10\nsteps = 64\nsample_every = 2\n",
                                              .friction = "gamma_par = 4.5\ngamma_perp = 2\ncutoff = 1\n"}
                                 .text());
}

/// "section.key=value" of any key that there is.
std::string odd_assignment(Random& random) {
  static std::vector<std::string> const texts{
      "argon", "0.05 tau", "auto",      "plain",      "given", "calibrated", "langevin", "strang",
      "off",   "1 K",      "-5 m/s",    "1e-30 s",    "kept",  "ems",        "ser",      "dpd",
      "dpde",  "x",        "[\"rho\"]", "1150 kg/m3", "tin",   "water"};
  static std::vector<std::string> const usual{"1",   "2",   "3",   "5",   "10",   "64",
                                              "100", "0.1", "0.5", "1.5", "1e-3", "1e3"};
  auto const& key = random.of(workflows::scene_keys());
  auto const value = key.choices.empty() ? (random.chance(0.4)   ? random.of(usual)
                                            : random.chance(0.6) ? odd_number(random)
                                                                 : random.of(texts))
                                         : random.of(key.choices);
  return fmt::format("{}={}", key.path(), value);
}

std::string without_time(std::string text) {
  return text.substr(0, text.find('\n'));
}

std::string differ(Trial const&, std::vector<Outcome> const& outcomes) {
  if (outcomes.size() < 2)
    return "";
  auto const &check = outcomes[0], &run = outcomes[1];
  if (check.status == 0 && run.status == 2)
    return "check accepts what run refuses";
  if (check.status == 2 && run.status != 2)
    return "check refuses what run accepts";
  if (check.status == 2 && without_time(check.printed) != without_time(run.printed))
    return "check and run refuse with different words";
  return "";
}

bool cheap(Outcome const& check) {
  if (check.status != 0)
    return true;
  auto const json =
      workflows::Json::parse(check.printed.substr(0, check.printed.rfind('}') + 1), nullptr, false);
  return json.is_object() && json.value("estimated_time_s", 1e9) < dear;
}

void change(Random& random, Trial& trial) {
  std::string const file = random.chance(0.6) ? "sdpd.toml" : "soft.toml";
  std::vector<std::string> check{"check", file, "--threads", "1", "--json"},
      run{"run", file, "--threads", "1", "-o", "out", "--quiet"};
  if (random.chance(0.4))
    trial.change = change_text(random, trial.folder / file);
  for (std::size_t k = 0; trial.change.empty() && k < 1 + random.below(3); ++k) {
    auto const assignment = odd_assignment(random);
    for (auto* words : {&check, &run})
      words->insert(words->end(), {"--set", assignment});
  }
  trial.commands = {check, run};
  trial.goes_on = cheap;
  trial.judge = differ;
}

} // namespace

Kind scene_kind() {
  return {.name = "scene", .prepare = prepare, .change = change};
}

} // namespace mesobridge::fuzz
