#include "workflows/sdpd/lammps_run.hpp"
#include "md/mpi_world.hpp"
#include "sdpd/lammps/lammps_engine.hpp"
#include "workflows/ranks.hpp"
#include "workflows/shared_options.hpp"

namespace mesobridge::workflows {
namespace {

/// The same call on ranks, of which the first tells the result.
void start_ranks(Context const& context, std::filesystem::path const& directory) {
  constexpr int by_signal = 128; // and more: how shells tell of it
  yield_when_idle();
  try {
    run_on_ranks(ranks_of(context), context.arguments);
  } catch (AlreadyReported const& end) {
    constexpr int interrupted = 130;
    if (end.exit_code <= by_signal || end.exit_code == interrupted)
      throw;
    throw EnvironmentError(
        fmt::format("a rank was ended by signal {}: what was stored until then is in '{}'; "
                    "go on with --resume",
                    end.exit_code - by_signal, directory.string()));
  }
}

} // namespace

void add_engine(CLI::App& app, std::string& engine) {
  add_choice(app, "--engine", engine, {"built-in", "lammps"},
             "Who advances the particles: this program on --threads, or the same physics inside LAMMPS, "
             "distributed over --ranks");
}

Result run_on_lammps(Scene const& scene, std::filesystem::path const& directory, Context const& context,
                     std::function<Result(OtherEngine const&)> const& run) {
  if (must_start_ranks(context)) {
    start_ranks(context, directory);
    return told_elsewhere();
  }
  Result result = told_elsewhere();
  guard_ranks([&] {
    md::MpiWorld const world;
    sdpd::LammpsEngine engine(world, settings_of(scene, 1), directory / "lammps.log");
    if (!world.is_root())
      return engine.serve();
    result = run({.name = "lammps",
                  .ranks = world.size(),
                  .settle = [&](sdpd::SimulationSettings const& settings) { engine.settle(settings); },
                  .advance = [&](sdpd::Simulation& simulation,
                                 std::uint64_t steps) { engine.advance(simulation, steps); }});
  });
  return result;
}

} // namespace mesobridge::workflows
