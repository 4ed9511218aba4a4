#include "workflows/bench/ranks.hpp"
#include "md/mpi_world.hpp"
#include "sdpd/lammps/lammps_engine.hpp"
#include "workflows/bench/paired_times.hpp"
#include "workflows/bench/settle.hpp"
#include "workflows/ranks.hpp"
#include <chrono>

namespace mesobridge::workflows {
namespace {

struct EngineTimes {
  PairedTimes built_in, inside;
};

EngineTimes time_both(sdpd::Simulation& simulation, sdpd::LammpsEngine& engine, RanksTiming const& timing) {
  auto const steps = static_cast<std::uint64_t>(timing.steps);
  double const scale = 1e6 / (static_cast<double>(simulation.size()) * timing.steps);
  EngineTimes times;
  engine.advance(simulation, 1); // brings the particles there
  for (int repeat = 0; repeat < timing.repeats; ++repeat) {
    simulation.advance(steps); // the particles came back without lists: these get old, as in a run
    auto const start = std::chrono::steady_clock::now();
    simulation.advance(steps);
    std::chrono::duration<double> const built_in = std::chrono::steady_clock::now() - start;
    double const before = engine.seconds_in_steps();
    engine.advance(simulation, steps);
    double const inside = engine.seconds_in_steps() - before;
    times.built_in.cost.push_back(scale * built_in.count()), times.built_in.ratio.push_back(1);
    times.inside.cost.push_back(scale * inside), times.inside.ratio.push_back(inside / built_in.count());
  }
  return times;
}

Result result_of(EngineTimes const& times, sdpd::Simulation const& simulation, RanksTiming const& timing,
                 int ranks, int threads) {
  Json rows = Json::array();
  std::string text = times_head("engine", "beside the built-in") + "\n";
  for (auto const& [name, of] :
       {std::pair{"built-in", &times.built_in}, std::pair{"lammps", &times.inside}}) {
    Json row{{"engine", name}};
    put_times(row, *of);
    row["neighbours"] = simulation.neighbours();
    text += times_line(row, "engine") + "\n";
    rows.push_back(std::move(row));
  }
  text += fmt::format("{}, {}; {} particles; {} thread(s) built in, {} rank(s) of LAMMPS", timing.method,
                      timing.scheme, simulation.size(), threads, ranks);
  return {.json = {{"engines", rows},
                   {"method", timing.method},
                   {"scheme", timing.scheme},
                   {"steps", timing.steps},
                   {"repeats", timing.repeats},
                   {"threads", threads},
                   {"ranks", ranks},
                   {"n", simulation.size()}},
          .text = text};
}

} // namespace

Result time_on_ranks(sdpd::SimulationSettings const& settings, RanksTiming const& timing,
                     Context const& context) {
  sdpd::refuse_for_lammps(settings);
  Result result = told_elsewhere();
  if (must_start_ranks(context)) {
    yield_when_idle();
    run_on_ranks(ranks_of(context), context.arguments);
    return result;
  }
  guard_ranks([&] {
    md::MpiWorld const world;
    sdpd::LammpsEngine engine(world, settings, {});
    if (!world.is_root())
      return engine.serve();
    sdpd::Simulation simulation(settings);
    settle(simulation);
    result =
        result_of(time_both(simulation, engine, timing), simulation, timing, world.size(), settings.threads);
  });
  return result;
}

} // namespace mesobridge::workflows
