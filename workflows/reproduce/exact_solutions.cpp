#include "sdpd/observe/profile.hpp"
#include "sdpd/simulation.hpp"
#include "workflows/interrupt.hpp"
#include "workflows/report/number_text.hpp"
#include "workflows/reproduce/exact_cases.hpp"
#include "workflows/reproduce/list.hpp"
#include "workflows/reproduce/sound_wave.hpp"
#include "workflows/sdpd/riemann_problem.hpp"
#include "workflows/sdpd/settings.hpp"
#include <algorithm>

namespace mesobridge::workflows {
namespace {

/// One tube at one resolution. Errors in the largest exact value of each quantity along the tube.
struct Solved {
  std::int64_t n;
  RiemannComparison found;
  double rho_error, u_error, P_error, energy_drift;
  double as_stated = 0; ///< where another program's tests state an error
};

double largest(std::vector<fitting::FlowState> const& exact, double (*of)(fitting::FlowState const&)) {
  double most = 0;
  for (auto const& state : exact)
    most = std::max(most, std::abs(of(state)));
  return most;
}

/// The profile at the end of a run that has not been written to files.
RiemannComparison profile_of(sdpd::Simulation const& simulation, Scene const& scene, double time) {
  auto const& units = simulation.units();
  sdpd::Slices const slices{2, static_cast<std::size_t>(scene.profile.bins)};
  auto const of = sdpd::profile(simulation.snapshot(), simulation.box(), slices, 1 / units.K);
  RiemannComparison found{.time = time};
  double const width = scene.box.size[2] / static_cast<double>(slices.count);
  for (std::size_t s = 0; s < slices.count; ++s) {
    found.place.push_back((static_cast<double>(s) + 0.5) * width);
    found.rho.push_back(of.rho[s] * units.density), found.u.push_back(of.velocity[s].z * units.velocity());
    found.P.push_back(of.P[s] * units.pressure()), found.T.push_back(of.T_int[s] * units.temperature);
  }
  return found;
}

Solved solve(TubeCase const& of, std::int64_t n, int threads, Progress& progress, double done, double share) {
  Scene const scene = tube_scene(of, n);
  auto const settings = settings_of(scene, threads);
  auto const problem = riemann_problem(scene, settings).value();
  sdpd::Simulation simulation(settings);
  double const energy = simulation.observe().energy();
  constexpr std::int64_t slice = 10;
  for (std::int64_t step = 0; step < scene.run.steps; step += slice) {
    simulation.advance(static_cast<std::uint64_t>(std::min(slice, scene.run.steps - step)));
    progress.update(done + share * static_cast<double>(step) / static_cast<double>(scene.run.steps),
                    fmt::format("{}, {} particles along the tube", of.name, n));
    if (interrupt_requested())
      throw Interrupted("stopped");
  }
  double const time = static_cast<double>(scene.run.steps) * scene.scheme.dt.value;
  auto const found = compare(problem, profile_of(simulation, scene, time));
  using State = fitting::FlowState const&;
  return {n,
          found,
          found.rho_error / largest(found.exact, [](State at) { return at.state.rho; }),
          found.u_error / largest(found.exact, [](State at) { return at.u; }),
          found.P_error / largest(found.exact, [](State at) { return at.state.P; }),
          simulation.observe().energy() / energy - 1,
          of.stated ? error_as_stated(*of.stated, found, problem.membrane) : 0};
}

/// How fast an error falls from the second last resolution to the last: error ~ n^-order.
std::optional<double> order(std::vector<Solved> const& runs, double Solved::*error) {
  if (runs.size() < 2)
    return std::nullopt;
  auto const &fine = runs.back(), &coarse = runs[runs.size() - 2];
  return std::log(coarse.*error / fine.*error) /
         std::log(static_cast<double>(fine.n) / static_cast<double>(coarse.n));
}

Table table_of(TubeCase const& of, std::vector<Solved> const& runs) {
  Table table{.header = {"particles along it", "error of the density", "of the velocity", "of the pressure",
                         "drift of the energy"},
              .caption =
                  of.title + ". Means of |particles - exact| over the tube, in the largest exact value."};
  for (auto const& run : runs) {
    table.rows.push_back({std::to_string(run.n), number_text(100 * run.rho_error, 3) + " %",
                          number_text(100 * run.u_error, 3) + " %", number_text(100 * run.P_error, 3) + " %",
                          number_text(run.energy_drift, 2)});
    if (of.stated)
      table.rows.back().push_back(number_text(run.as_stated, 2));
  }
  auto const text = [&](double Solved::*error) {
    auto const found = order(runs, error);
    return found ? number_text(*found, 2) : std::string();
  };
  table.rows.push_back(
      {"order", text(&Solved::rho_error), text(&Solved::u_error), text(&Solved::P_error), ""});
  if (of.stated) {
    auto const& [program, where, reach, unit, below] = *of.stated;
    table.header.push_back("of the velocity as " + program + " takes it");
    table.rows.back().push_back(text(&Solved::as_stated));
    table.rows.push_back({program, "", "", "", "", fmt::format("< {:g}", below)});
    table.caption +=
        fmt::format(" {}: {} asks that the mean over the particles near the membrane be less, in "
                    "the root of P/rho on the left.",
                    program, where);
  }
  return table;
}

Json json_of(TubeCase const& of, std::vector<Solved> const& runs) {
  Json json{{"name", of.name}, {"rows", Json::array()}};
  for (auto const& run : runs) {
    json["rows"].push_back({{"particles_along", run.n},
                            {"L1_rho", run.rho_error},
                            {"L1_u", run.u_error},
                            {"L1_P", run.P_error},
                            {"energy_drift", run.energy_drift}});
    if (of.stated)
      json["rows"].back()["u_error_as_stated"] = run.as_stated;
  }
  if (of.stated)
    json["stated"] = {
        {"program", of.stated->program}, {"where", of.stated->where}, {"u_error_below", of.stated->below}};
  if (auto const falls = order(runs, &Solved::rho_error))
    json["order_rho"] = *falls, json["order_u"] = *order(runs, &Solved::u_error),
    json["order_P"] = *order(runs, &Solved::P_error);
  return json;
}

/// Sound in air and in argon over the length of the wave.
Section sound_section(std::vector<std::int64_t> const& lengths, int threads, Json& json) {
  Table table{.header = {"fluid", "length in particles", "velocity [m/s]", "of the equation of state",
                         "error", "damping [1/s]", "of the viscosity", "error"},
              .caption = "A standing wave on a cubic lattice, followed over two periods. A kernel of finite "
                         "support sees short waves less: the errors fall with the square of the length."};
  json = Json::array();
  for (auto const& [eos, rho, T] : {std::tuple("air", 1.0, 300.0), {"argon", 1150.0, 1000.0}})
    for (auto const n : lengths) {
      auto const of = measure_sound(sound_scene(eos, rho, T, n), n, threads,
                                    [](double) { return !interrupt_requested(); });
      auto const percent = [](double error) { return number_text(100 * error, 2) + " %"; };
      table.rows.push_back({eos, std::to_string(n), number_text(of.c, 6), number_text(of.c_exact, 6),
                            percent(of.c_error()), number_text(of.damping, 4),
                            number_text(of.damping_exact, 4), percent(of.damping_error())});
      json.push_back({{"eos", eos},
                      {"particles_along", n},
                      {"c_m_s", of.c},
                      {"c_exact_m_s", of.c_exact},
                      {"damping_per_s", of.damping},
                      {"damping_exact_per_s", of.damping_exact}});
    }
  return {"Sound", {std::move(table)}};
}

} // namespace

Reproduced reproduce_exact_solutions(ReproduceOptions const& options, Context const& context) {
  std::vector<std::int64_t> resolutions{40, 60, 100, 200};
  if (options.preset != md::Preset::quick)
    resolutions = {100, 200, 400, 800};
  auto progress = context.progress("Exact solutions", 1);
  double work = 0, done = 0;
  for (auto const n : resolutions)
    work += static_cast<double>(n * n * std::ssize(tube_cases()));
  Reproduced found;
  found.summary["cases"] = Json::array();
  found.report.title = "Flows with exact solutions, in the limit without noise";
  for (auto const& of : tube_cases()) {
    std::vector<Solved> runs;
    for (auto const n : resolutions) {
      double const share = static_cast<double>(n * n) / work;
      runs.push_back(solve(of, n, options.threads, progress, done, share)), done += share;
    }
    found.summary["cases"].push_back(json_of(of, runs));
    auto section = riemann_section(
        runs.back().found,
        OutputUnits(settings_of(tube_scene(of, resolutions[0]), 1).units(), UnitSystem::SI), of.name);
    section.title = of.title;
    section.content.emplace_back(table_of(of, runs));
    found.report.sections.push_back(std::move(section));
  }
  std::vector<std::int64_t> lengths{40, 80};
  if (options.preset != md::Preset::quick)
    lengths.push_back(160);
  found.report.sections.push_back(sound_section(lengths, options.threads, found.summary["sound"]));
  progress.finish();
  found.report.sources = {"Hubber et al. 2018"};
  found.report.lead =
      "Viscous smoothed particle hydrodynamics, which is what SDPD becomes without noise, against exact "
      "solutions of Riemann problems. The viscosity falls with the distance between particles, so that the "
      "strongest shock stays two or three of them wide: the errors of smooth parts fall with the square of "
      "that "
      "distance or with the viscosity, those of shocks and contacts in proportion to it.";
  return found;
}

} // namespace mesobridge::workflows
