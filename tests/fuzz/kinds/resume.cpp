#include "fuzz/change_hdf5.hpp"
#include "fuzz/change_text.hpp"
#include "fuzz/child.hpp"
#include "fuzz/judge.hpp"
#include "fuzz/kinds/kinds.hpp"
#include "fuzz/kinds/tiny_run.hpp"
#include "hdf5_numbers.hpp"
#include "workflows/text_file.hpp"
#include <algorithm>
#include <csignal>
#include <fmt/format.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

// A run that was killed, its files damaged, and resumed: it equals the unbroken one, or is refused.

namespace mesobridge::fuzz {
namespace {

namespace fs = std::filesystem;
using tests::numbers_of;

/// Starts the run and kills it once its first checkpoint is there.
void kill_a_run(fs::path const& folder) {
  pid_t const child = start_in_child(folder, tiny_run({}));
  for (int k = 0; k < 20000 && !fs::exists(folder / "out" / "checkpoint.h5"); ++k)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  kill(child, SIGKILL);
  waitpid(child, nullptr, 0);
}

void prepare(fs::path const& folder) {
  workflows::write_text_file(folder / "scene.toml", tiny_scene);
  auto const whole = run_in_child(folder, tiny_run({}), 60);
  if (whole.status != 0)
    throw std::runtime_error("the run that is to be damaged failed: " + whole.printed);
  fs::rename(folder / "out", folder / "reference");
  kill_a_run(folder);
}

std::string unlike_reference(Trial const& trial, std::vector<Outcome> const& outcomes) {
  if (outcomes.back().status != 0)
    return "";
  for (char const* file : {"run.h5", "trajectory.h5md", "trajectory.vtkhdf"}) {
    auto const made = numbers_of(trial.folder / "out" / file),
               wanted = numbers_of(trial.folder / "reference" / file);
    if (made != wanted)
      return fmt::format("{} differs from the unbroken run's, with success", file);
  }
  for (char const* file : {"trajectory.xyz", "summary.json"})
    if (workflows::read_text_file(trial.folder / "out" / file) !=
        workflows::read_text_file(trial.folder / "reference" / file))
      return fmt::format("{} differs from the unbroken run's, with success", file);
  return "";
}

void change_files(Random& random, Trial& trial) {
  trial.commands = {tiny_run({"--resume"})};
  trial.judge = unlike_reference;
  static std::vector<std::string> const files{"checkpoint.h5", "checkpoint.h5", "run.h5", "trajectory.h5md",
                                              "trajectory.vtkhdf"};
  auto const file = trial.folder / "out" / random.of(files);
  trial.change = random.chance(0.5) ? change_bytes(random, file) : change_hdf5(random, file);
}

void change_journals(Random& random, Trial& trial) {
  trial.commands = {tiny_run({"--resume"})};
  trial.judge = unlike_reference;
  std::vector<fs::path> journals;
  for (auto const& entry : fs::directory_iterator(trial.folder / "out"))
    if (entry.path().extension() == ".undo" || entry.path().extension() == ".xyz" ||
        entry.path().extension() == ".toml")
      journals.push_back(entry.path());
  std::ranges::sort(journals);
  auto const file = random.of(journals);
  trial.change = file.extension() == ".toml" ? change_text(random, file) : change_bytes(random, file);
}

} // namespace

Kind resume_kind() {
  return {.name = "resume", .prepare = prepare, .change = change_files};
}

Kind journal_kind() {
  return {.name = "journal", .prepare = prepare, .change = change_journals};
}

} // namespace mesobridge::fuzz
