#include "fuzz/kinds/driven_scene.hpp"
#include "fuzz/kinds/kinds.hpp"
#include "hdf5_numbers.hpp"
#include "workflows/text_file.hpp"

// Pistons, walls and open faces, and fluids that react there: what leaves equilibrium ends well, or says why
// it does not.

namespace mesobridge::fuzz {
namespace {

std::string judge(Trial const& trial, std::vector<Outcome> const& outcomes) {
  if (outcomes.back().status == 130) // the time of a trial was over
    return "";
  if (auto const fault = fault_of_driven(outcomes.back().status, outcomes.back().printed); !fault.empty())
    return fault;
  auto const out = trial.folder / "out";
  return std::filesystem::exists(out) ? tests::not_finite_in(out) : "";
}

/// What `check` refuses `run` refuses in the same words, and the other way round; `check` does not run.
std::string judge_reacting(Trial const& trial, std::vector<Outcome> const& outcomes) {
  auto const &checked = outcomes.front(), &ran = outcomes.back();
  if (checked.status != 0 && ran.status != 130 && ran.status != checked.status)
    return fmt::format("check ends with {}, run with {}", checked.status, ran.status);
  if (checked.status == 0 && ran.status == 2)
    return "check takes what run refuses";
  auto const refusal = [](std::string const& printed) {
    auto const from = printed.find("mesobridge: "); // after warnings
    return from == std::string::npos ? printed : printed.substr(from);
  };
  if (checked.status == 2 && refusal(checked.printed) != refusal(ran.printed))
    return "check and run refuse in other words";
  return judge(trial, outcomes);
}

void change_reacting(Random& random, Trial& trial) {
  workflows::write_text_file(trial.folder / "scene.toml", DrivenScene(random, true).text());
  trial.change = "a scene of its own";
  trial.commands = {{"check", "scene.toml"}, {"run", "scene.toml", "-o", "out", "--quiet", "--threads", "1"}};
  if (random.chance(0.9))
    trial.commands.back().push_back("--no-report");
  trial.goes_on = [](Outcome const&) { return true; };
  trial.judge = judge_reacting;
}

void change(Random& random, Trial& trial) {
  workflows::write_text_file(trial.folder / "scene.toml", DrivenScene(random).text());
  trial.change = "a scene of its own";
  trial.commands = {{"run", "scene.toml", "-o", "out", "--quiet", "--no-report", "--threads", "1"}};
  trial.judge = judge;
}

} // namespace

Kind driven_kind() {
  return {.name = "driven", .prepare = [](std::filesystem::path const&) {}, .change = change};
}

Kind reacting_kind() {
  return {.name = "reacting", .prepare = [](std::filesystem::path const&) {}, .change = change_reacting};
}

} // namespace mesobridge::fuzz
