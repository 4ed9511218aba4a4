#pragma once
#include "workflows/interrupt.hpp"
#include "workflows/job_pool.hpp"
#include "workflows/sdpd/run_scene.hpp"
#include "workflows/store/store.hpp"
#include "workflows/study/stored_part.hpp"
#include "workflows/study/study.hpp"
#include "workflows/version.hpp"
#include <mutex>

namespace mesobridge::workflows {

/// A run of a study, and the name of its folder, unique in the study.
struct DrivenRun {
  std::string name;
  Scene scene;
};

/// Runs the scene on one thread in the folder, which need not exist; what a run of this scene has left there
/// is gone on with. Throws what run_scene throws.
RunResult run_or_go_on(Scene scene, std::filesystem::path const& folder, Context const& context,
                       std::function<bool(std::uint64_t)> const& keep_going);

/// The part of all steps of a study that is done, of runs that work side by side.
class StudyProgress {
 public:
  StudyProgress(std::vector<DrivenRun> const& runs, Progress& progress);
  /// `told` is what the run has told before, from 0 on.
  void tell(Scene const& scene, std::uint64_t steps, double& told);

 private:
  Progress& progress_;
  std::mutex mutex_;
  double total_ = 0, done_ = 0;
};

/// A row of each run, several at a time, each on one thread: row_of(k, RunResult, Store) of a run that has
/// come to its end, failed(k, reason) of one that could not go on. Finished ones are stored under the
/// directory and read back, others go on from their checkpoints. Throws Interrupted.
template <class Row, class RowOf, class Failed>
std::vector<Row> run_study(std::string const& title, std::vector<DrivenRun> const& runs,
                           StudyOptions const& options, Context const& context, RowOf const& row_of,
                           Failed const& failed) {
  auto const directory = options.directory / "runs";
  auto progress = context.progress(title, 1);
  StudyProgress share(runs, progress);
  std::vector<Row> rows(runs.size());
  std::vector<std::function<void()>> jobs;
  for (std::size_t k = 0; k < runs.size(); ++k)
    jobs.push_back([&, k] {
      auto const& [name, scene] = runs[k];
      auto const folder = directory / name;
      double told = 0;
      rows[k] =
          stored_or_made(folder / "row.json", fmt::format("{}\n{}", resolved_toml(scene), git_commit()), [&] {
            try {
              auto const run = run_or_go_on(scene, folder, context, [&](std::uint64_t steps) {
                share.tell(scene, steps, told);
                return !interrupt_requested();
              });
              return row_of(k, run, Store(folder / "run.h5", Store::Mode::read));
            } catch (PhysicsError const& error) {
              return failed(k, error.what());
            }
          });
    });
  run_jobs(jobs, options.threads);
  progress.finish();
  return rows;
}

} // namespace mesobridge::workflows
