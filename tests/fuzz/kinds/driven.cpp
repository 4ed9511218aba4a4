#include "fuzz/kinds/driven_scene.hpp"
#include "fuzz/kinds/kinds.hpp"
#include "hdf5_numbers.hpp"
#include "workflows/text_file.hpp"

// Pistons, walls and open faces: what leaves equilibrium ends well, or says why it does not.

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

} // namespace mesobridge::fuzz
