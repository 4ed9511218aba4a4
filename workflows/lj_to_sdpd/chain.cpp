#include "workflows/lj_to_sdpd/chain.hpp"
#include "fitting/model_file.hpp"
#include "workflows/interrupt.hpp"
#include "workflows/job_pool.hpp"
#include "workflows/lj/state_grid_file.hpp"
#include "workflows/ranks.hpp"
#include "workflows/text_file.hpp"
#include "workflows/version.hpp"
#include <chrono>
#include <mutex>
#include <optional>

namespace mesobridge::workflows {
namespace {

namespace fs = std::filesystem;

class Stopwatch {
 public:
  double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

void make_directory(fs::path const& directory) {
  std::error_code error;
  fs::create_directories(directory, error);
  if (error)
    throw EnvironmentError(
        fmt::format("cannot create directory '{}': {}", directory.string(), error.message()));
}

/// What cut-off, 500 atoms and time step may do to U and P beyond their statistical errors: halving the time
/// step changes them by less than 0.1 %. Without it the strong correlation of U and P would make a
/// combination of the two look exact.
constexpr double md_systematic_error = 1e-3;

/// Molecular dynamics, on ranks of its own: MPI stays out of this process.
void sample(std::string const& preset, std::uint64_t seed, fs::path const& directory,
            Context const& context) {
  std::vector<std::string> words{"md",   "lj-grid",          "--preset",
                                 preset, "--seed",           std::to_string(seed),
                                 "-o",   directory.string(), "--started-by-ourselves"};
  if (context.options.quiet)
    words.push_back("--quiet");
  run_on_ranks(ranks_of(context), words);
}

void write_model(fs::path const& file, fitting::LjBwrFit const& fit, fs::path const& data,
                 Context const& context) {
  auto const model = fitting::model_of(fit, argon_units, sha256_of_file(data),
                                       {{"program", fmt::format("mesobridge {}", version())},
                                        {"git_commit", std::string(git_commit())},
                                        {"command", context.command_line()},
                                        {"data", data.filename().string()}});
  write_text_file(file, fitting::to_toml(model));
}

/// All planned runs, each on one thread, as many at a time as there are threads.
void run_sdpd(SdpdPlan const& plan, fs::path const& directory, Context const& context,
              ChainResults& results) {
  struct Group {
    std::vector<PlannedRun> const& planned;
    std::vector<RunResult>& results;
    std::vector<std::optional<RunResult>> done = std::vector<std::optional<RunResult>>(planned.size());
  };
  std::vector<Group> groups{{plan.fluid, results.fluid},
                            {plan.published, results.published},
                            {plan.ideal, results.ideal},
                            {plan.drift, results.drift}};
  double total = 0;
  for (auto const& group : groups)
    for (auto const& run : group.planned)
      total += static_cast<double>(run.scene.run.equilibrate + run.scene.run.steps);
  auto progress = context.progress("SDPD", total);
  std::mutex mutex;
  double steps_done = 0;
  std::vector<std::function<void()>> jobs;
  for (auto& group : groups)
    for (std::size_t k = 0; k < group.planned.size(); ++k)
      jobs.push_back([&, k] {
        auto const& run = group.planned[k];
        auto const folder = directory / run.name;
        make_directory(folder);
        std::uint64_t told = 0;
        group.done[k] = run_scene(run.scene, {.directory = folder,
                                              .threads = 1,
                                              .command = context.command_line(),
                                              .keep_going = [&](std::uint64_t steps) {
                                                std::lock_guard const lock(mutex);
                                                steps_done += static_cast<double>(steps - told);
                                                told = steps;
                                                progress.update(steps_done, run.scene.title);
                                                return !interrupt_requested();
                                              }});
      });
  run_jobs(jobs, context.options.threads.value_or(available_threads()));
  progress.finish();
  for (auto& group : groups)
    for (auto& run : group.done)
      group.results.push_back(std::move(run).value());
}

} // namespace

ChainResults run_chain(md::Preset preset, std::string const& preset_name, fs::path const& directory,
                       Context const& context) {
  std::uint64_t const seed = context.options.seed.value_or(1);
  make_directory(directory / "md");
  Stopwatch const md_watch;
  sample(preset_name, seed, directory / "md", context);
  double const md_seconds = md_watch.seconds();
  throw_if_interrupted();

  Stopwatch const fit_watch;
  auto const samples = directory / "md" / "lj-grid.h5", table = directory / "state-grid.h5",
             model = directory / "lj-bwr.toml";
  auto const data = read_lj_grid(samples);
  auto const grid = analyse_lj_grid(data).grid;
  write_state_grid(table, grid, {context.command_line(), seed, "", {samples}});
  ChainResults results{.grid = grid,
                       .md_description = data.description,
                       .fit = fitting::fit_lj_bwr(grid, {.relative_error_floor = md_systematic_error})};
  write_model(model, results.fit, table, context);
  results.seconds.fit = fit_watch.seconds();
  results.seconds.md = md_seconds;

  Stopwatch const sdpd_watch;
  auto const plan = sdpd_plan(preset, fs::absolute(model), static_cast<std::int64_t>(seed));
  run_sdpd(plan, directory / "sdpd", context, results);
  results.seconds.sdpd = sdpd_watch.seconds();
  return results;
}

} // namespace mesobridge::workflows
