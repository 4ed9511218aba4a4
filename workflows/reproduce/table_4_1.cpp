#include "md/processor_clock.hpp"
#include "sdpd/setup/equilibration.hpp"
#include "sdpd/simulation.hpp"
#include "workflows/interrupt.hpp"
#include "workflows/report/number_text.hpp"
#include "workflows/reproduce/list.hpp"
#include "workflows/reproduce/published.hpp"
#include "workflows/summary.hpp"

namespace mesobridge::workflows {
namespace {

constexpr double dt = 2.24e-2, K = 5;

struct Timed {
  std::string name; ///< row of the published table
  sdpd::Scheme scheme;
  std::vector<double> us{}; ///< per particle and step, one value a round
};

std::vector<Timed> schemes() {
  constexpr std::uint32_t never = 1'000'000'000; // conservative steps alone
  return {{"verlet", {.pairs = "ssa", .verlet_steps = never}},
          {"ssa", {.pairs = "ssa"}},
          {"ems", {.pairs = "ems"}},
          {"ams", {.pairs = "ams"}},
          {"ems-mts5", {.pairs = "ems", .verlet_steps = 5}},
          {"ams-mts5", {.pairs = "ams", .verlet_steps = 5}}};
}

sdpd::SimulationSettings settings(sdpd::Scheme const& scheme, std::uint64_t seed) {
  return {.method = sdpd::Sdpd{.eos = fitting::IdealGas(1e-25), .K = K, .eta = 2e-3},
          .rho = 1150,
          .T = 1000,
          .lattice = {10, 10, 10},
          .disorder = 0.15,
          .dt = dt,
          .scheme = scheme,
          .seed = seed};
}

/// Times `steps` steps from the same start; nothing when the scheme cannot make them.
std::optional<double> time_steps(Timed const& timed, sdpd::Checkpoint const& start, std::uint64_t steps,
                                 std::uint64_t seed) {
  sdpd::Simulation simulation(settings(timed.scheme, seed));
  simulation.begin_from(start);
  try {
    simulation.advance(steps / 10); // caches and lists settle
    md::ProcessorClock const clock;
    simulation.advance(steps);
    return clock.seconds() * 1e6 / static_cast<double>(steps * simulation.size());
  } catch (PhysicsError const&) {
    return std::nullopt; // SSA, now and then, at this size: the round goes without it
  }
}

cg::Estimate mean(std::vector<double> const& values) {
  double sum = 0, square = 0;
  for (double const x : values)
    sum += x;
  double const n = static_cast<double>(values.size()), average = sum / n;
  for (double const x : values)
    square += (x - average) * (x - average);
  return {average, std::sqrt(square / (n * (n - 1))), n};
}

/// Means of the ratios to Verlet, round by round: the machine's moods cancel.
cg::Estimate ratio(Timed const& timed, Timed const& verlet) {
  std::vector<double> ratios;
  for (std::size_t k = 0; k < timed.us.size(); ++k)
    ratios.push_back(timed.us[k] / verlet.us[k]);
  return mean(ratios);
}

/// Rounds in which every scheme could be timed.
std::vector<Timed> time_all(int rounds, std::uint64_t steps, std::uint64_t seed, Progress& progress) {
  auto timed = schemes();
  sdpd::Simulation start(settings({.pairs = "ems"}, seed));
  sdpd::equilibrate(start, 400, [] { return !interrupt_requested(); });
  for (int round = 0; round < rounds; ++round) {
    throw_if_interrupted();
    start.advance(20); // another start each round
    auto const from = start.checkpoint();
    std::vector<std::optional<double>> us(timed.size());
    for (std::size_t k = 0; k < timed.size(); ++k) {
      std::size_t const which =
          (k + static_cast<std::size_t>(round)) % timed.size(); // no scheme always first
      us[which] = time_steps(timed[which], from, steps, seed);
    }
    progress.update(round + 1);
    if (std::any_of(us.begin(), us.end(), [](auto const& value) { return !value; }))
      continue;
    for (std::size_t k = 0; k < timed.size(); ++k)
      timed[k].us.push_back(*us[k]);
  }
  return timed;
}

} // namespace

Reproduced reproduce_table_4_1(ReproduceOptions const& options, Context const& context) {
  int const rounds = options.preset == md::Preset::quick      ? 24
                     : options.preset == md::Preset::standard ? 200
                                                              : 1000;
  constexpr std::uint64_t steps = 100;
  auto progress = context.progress("Table 4.1", rounds);
  auto const timed = time_all(rounds, steps, options.seed, progress);
  progress.finish();
  auto const& verlet = timed.front();
  if (verlet.us.size() < 4)
    throw PhysicsError(fmt::format("only {} of {} rounds could be timed: SSA fails at K = {:g}, dt = {:g}",
                                   verlet.us.size(), rounds, K, dt));
  auto const printed = published("thesis-table-4.1.csv");
  Reproduced found;
  Table table{.header = {"scheme", "ours [us]", "ours / Verlet", "printed [us]", "printed / Verlet"},
              .caption =
                  fmt::format("Processor time per particle and conservative step on one core, ideal gas, K = "
                              "{:g}, N = 1000, dt = {:g}; {} rounds of {} steps from common starts, "
                              "in which the schemes take turns.",
                              K, dt, verlet.us.size(), steps)};
  for (auto const& scheme : timed) {
    double const theirs = printed.value(scheme.name, "us_per_particle_step"),
                 their_ratio = theirs / printed.value("verlet", "us_per_particle_step");
    auto const us = mean(scheme.us), to_verlet = ratio(scheme, verlet);
    Json row{{"scheme", scheme.name}};
    put(row, "us_per_particle_step", us);
    put(row, "ratio_to_verlet", to_verlet);
    row["printed_us_per_particle_step"] = theirs;
    row["printed_ratio_to_verlet"] = their_ratio;
    found.summary["schemes"].push_back(row);
    table.rows.push_back({scheme.name, with_error_text(us), with_error_text(to_verlet),
                          number_text(theirs, 4), number_text(their_ratio, 3)});
  }
  found.summary["rounds"] = verlet.us.size();
  found.summary["K"] = K;
  found.summary["dt_reduced"] = dt;
  found.report = {
      .title = "Table 4.1: time per particle and step",
      .lead = fmt::format("Ours beside the printed times. Absolute times compare machines of 2017 and of "
                          "today; the ratios compare the schemes. Verlet with SSA takes {} times "
                          "as long as Verlet alone, the Metropolis test {} times.",
                          with_error_text(ratio(timed[1], verlet)), with_error_text(ratio(timed[2], verlet))),
      .verdicts = {},
      .sections = {{"Times", {table, Paragraph{printed.source}}}},
      .provenance = {}};
  return found;
}

} // namespace mesobridge::workflows
