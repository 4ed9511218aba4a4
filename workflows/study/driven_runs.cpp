#include "workflows/study/driven_runs.hpp"
#include "workflows/sdpd/run_folder.hpp"
#include <algorithm>

namespace mesobridge::workflows {
namespace {

/// From where the run that is in the folder goes on, as whose the scene then goes on; nothing where there is
/// none of this scene.
std::optional<PastRun> past_in(RunFolder const& folder, Scene& scene) {
  if (!folder.has_checkpoint())
    return std::nullopt;
  try {
    auto stored = read_checkpoint(folder.checkpoint());
    auto const resumed = resumed_scene(scene, stored.scene, stored.inputs, folder.checkpoint());
    auto past = past_run(std::move(stored));
    scene = resumed;
    return past;
  } catch (InputError const&) {
    return std::nullopt; // of another scene, or damaged: it begins again
  }
}

double work_of(Scene const& scene, std::int64_t steps) {
  return static_cast<double>(scene.particles.N) * static_cast<double>(steps);
}

} // namespace

RunResult run_or_go_on(Scene scene, std::filesystem::path const& directory, Context const& context,
                       std::function<bool(std::uint64_t)> const& keep_going) {
  std::error_code ignored;
  std::filesystem::create_directories(directory, ignored); // writing there says what is wrong
  RunFolder const folder(directory);
  auto past = past_in(folder, scene);
  return run_scene(scene, {.directory = directory,
                           .threads = 1,
                           .past = std::move(past),
                           .command = context.command_line(),
                           .keep_going = keep_going});
}

StudyProgress::StudyProgress(std::vector<DrivenRun> const& runs, Progress& progress) : progress_(progress) {
  for (auto const& [name, scene] : runs)
    total_ += work_of(scene, scene.run.equilibrate + scene.run.steps);
}

void StudyProgress::tell(Scene const& scene, std::uint64_t steps, double& told) {
  std::lock_guard const lock(mutex_);
  double const now = work_of(scene, static_cast<std::int64_t>(steps));
  done_ += now - told, told = now;
  progress_.update(std::min(1.0, done_ / total_), scene.title);
}

} // namespace mesobridge::workflows
