#include "sdpd/scheme/list.hpp"
#include "sdpd/simulation.hpp"
#include "workflows/bench/detonation.hpp"
#include "workflows/bench/faces.hpp"
#include "workflows/bench/ranks.hpp"
#include "workflows/bench/settle.hpp"
#include "workflows/command/options.hpp"
#include "workflows/sdpd/settings.hpp"
#include "workflows/shared_options.hpp"
#include <algorithm>
#include <chrono>
#include <numbers>

namespace mesobridge::workflows {
namespace {

struct BenchEngineOptions {
  std::string method = "sdpd", scheme = "ssa", eos = "ideal-gas", kernel = Scene().particles.kernel;
  double neighbours = 62;
  std::uint32_t side = 22, along = 0, fluctuate_every = 1;
  bool faces = false, detonation = false, on_ranks = false;
  double K = 100, kappa = 0, progress = 0.5;
  int steps = 20, repeats = 5;
};

sdpd::SimulationSettings settings_of(BenchEngineOptions const& options, int threads, sdpd::AnyMethod method) {
  return {.method = std::move(method),
          .lattice = {options.side, options.side, options.along > 0 ? options.along : options.side},
          .disorder = 0.15,
          .noise = sdpd::method_named(options.method).noise,
          .scheme = {.pairs = options.scheme, .verlet_steps = options.fluctuate_every},
          .threads = threads};
}

/// Compressed and hot nitromethane that is burnt to a part, and burns so slowly that it stays so.
sdpd::SimulationSettings burning_nitromethane(BenchEngineOptions const& options, int threads) {
  auto settings = settings_of(
      options, threads,
      sdpd::Sdpd{.eos = fitting::material("nitromethane").eos,
                 .K = options.K,
                 .kernel = options.kernel,
                 .eta = 2e-3,
                 .kappa = options.kappa,
                 .reaction = sdpd::SdpdReaction{.product = fitting::material("nitromethane-products").eos,
                                                .heat = 4.7159e6,
                                                .kinetics = sdpd::SecondOrder{{1e6, 3e-19}, {}},
                                                .progress = options.progress}});
  settings.rho = 1700, settings.T = 2500, settings.dt = 0.02;
  settings.disorder = 0.05; // the reactant has no densities above 2280 kg/m^3
  return settings;
}

sdpd::SimulationSettings make(std::type_identity<sdpd::Sdpd>, BenchEngineOptions const& options,
                              int threads) {
  if (options.eos == "burning-nitromethane")
    return burning_nitromethane(options, threads);
  bool const ideal = options.eos == "ideal-gas";
  auto settings = settings_of(options, threads,
                              sdpd::Sdpd{.eos = ideal ? fitting::AnyEos(fitting::IdealGas(1e-25))
                                                      : fitting::material(options.eos).eos,
                                         .K = options.K,
                                         .kernel = options.kernel,
                                         .eta = 2e-3,
                                         .kappa = options.kappa});
  settings.rho = 1150, settings.T = 1000, settings.dt = ideal ? 0.1 : 0.05;
  return settings;
}

/// The soft fluid of Groot and Warren at its density 3, with a repulsion that keeps its pressure and a
/// friction that keeps its viscosity about the same when the cut-off, which is the unit of length, reaches
/// more neighbours.
template <std::derived_from<sdpd::PairFluid> Method>
sdpd::SimulationSettings make(std::type_identity<Method>, BenchEngineOptions const& options, int threads) {
  double const customary = 3, rho = options.neighbours / (4 * std::numbers::pi / 3);
  sdpd::PairFluid const particles{.mass = 1,
                                  .potential = sdpd::SoftPotential(25 * customary / rho, 1),
                                  .friction = sdpd::PowerFriction(4.5 * customary / rho, 0, 1, 2)};
  auto settings = settings_of(options, threads, sdpd::Dpd{particles});
  if constexpr (Method::features.energies) {
    settings.method = sdpd::Dpde{particles, fitting::ConstantHeatCapacity(options.K)};
    if (options.kappa > 0)
      settings.as<sdpd::Dpde>().conduction = sdpd::PowerFriction(options.kappa, 0, 1, 2);
  } else if (options.kappa > 0)
    throw InputError("heat conduction: DPD has no internal energies that could be exchanged; take DPDE");
  settings.rho = rho, settings.T = 1, settings.dt = 0.01;
  return settings;
}

/// What faces cost that are not periodic.
Result run_faces(BenchEngineOptions const& options, int threads) {
  Json rows;
  sdpd::for_method(options.method, [&](auto type) {
    rows = time_faces(make(type, options, threads), {.steps = options.steps, .repeats = options.repeats});
  });
  std::size_t const across = options.side, along = options.along > 0 ? options.along : options.side;
  return {.json = {{"faces", rows},
                   {"threads", threads},
                   {"method", options.method},
                   {"scheme", options.scheme},
                   {"n", across * across * along},
                   {"lattice", {across, across, along}},
                   {"repeats", options.repeats}},
          .text = faces_text(rows)};
}

/// What a detonation costs beside the ideal gas.
Result run_detonation(BenchEngineOptions options, int threads) {
  require(options.method == "sdpd", "--method", options.method, "must be sdpd with --detonation: it reacts");
  auto const settings = [&](char const* eos) {
    options.eos = eos;
    return make(std::type_identity<sdpd::Sdpd>(), options, threads);
  };
  std::uint32_t const along = options.along > 0 ? options.along : options.side;
  auto const rows = time_detonation(settings("ideal-gas"), settings("burning-nitromethane"),
                                    {.across = options.side,
                                     .along = along,
                                     .steps = options.steps,
                                     .repeats = options.repeats,
                                     .threads = threads});
  return {.json = {{"fluids", rows},
                   {"threads", threads},
                   {"lattice", {options.side, options.side, along}},
                   {"repeats", options.repeats}},
          .text = detonation_times_text(rows)};
}

/// What a step costs inside LAMMPS.
Result run_inside_lammps(BenchEngineOptions const& options, int threads, Context const& context) {
  Result result;
  sdpd::for_method(options.method, [&](auto type) {
    RanksTiming const timing{options.method, options.scheme, options.steps, options.repeats};
    result = time_on_ranks(make(type, options, threads), timing, context);
  });
  return result;
}

Result run(BenchEngineOptions const& options, Context const& context) {
  int const threads = context.options.threads.value_or(1);
  if (options.faces)
    return run_faces(options, threads);
  if (options.detonation)
    return run_detonation(options, threads);
  if (options.on_ranks)
    return run_inside_lammps(options, threads, context);
  bool const densities = sdpd::method_named(options.method).features.densities;
  std::optional<sdpd::Simulation> made;
  sdpd::for_method(options.method, [&](auto type) { made.emplace(make(type, options, threads)); });
  auto& simulation = made.value();
  // A disordered start settles first: lists, densities and caches are then those of a fluid.
  settle(simulation);
  std::vector<double> cost;
  double const work = static_cast<double>(simulation.size()) * options.steps;
  for (int repeat = 0; repeat < options.repeats; ++repeat) {
    auto const begin = std::chrono::steady_clock::now();
    simulation.advance(static_cast<std::uint64_t>(options.steps));
    std::chrono::duration<double, std::micro> const spent = std::chrono::steady_clock::now() - begin;
    cost.push_back(spent.count() / work);
  }
  std::sort(cost.begin(), cost.end());
  Result result;
  result.json = {{"us_per_particle_step", cost[cost.size() / 2]},
                 {"us_per_particle_step_min", cost.front()},
                 {"us_per_particle_step_max", cost.back()},
                 {"neighbours", simulation.neighbours()},
                 {"threads", threads},
                 {"method", options.method},
                 {"scheme", options.scheme},
                 {"fluctuate_every", options.fluctuate_every},
                 {"eos", densities ? options.eos : "none"},
                 {"kernel", densities ? options.kernel : "none"},
                 {densities ? "kappa_W_m_K" : "kappa_reduced", options.kappa},
                 {"n", simulation.size()},
                 {"K", options.K},
                 {"repeats", options.repeats}};
  result.text =
      fmt::format("{:.3f} us per particle and step (median of {}, {:.3f} ... {:.3f}); {} particles, {:.1f} "
                  "neighbours, {} thread(s), {}, {}",
                  cost[cost.size() / 2], options.repeats, cost.front(), cost.back(), simulation.size(),
                  simulation.neighbours(), threads, options.scheme, densities ? options.eos : options.method);
  return result;
}

void declare(CLI::App& app, BenchEngineOptions& options) {
  add_choice(app, "--method", options.method, sdpd::method_names(), "what is timed");
  add_bounded(app, "--neighbours", options.neighbours, 5.0, 200.0,
              "within the cut-off, for dpde and dpd; the kernel decides for sdpd");
  add_choice(app, "--scheme", options.scheme, sdpd::pair_integrator_names(), "time-stepping scheme");
  add_bounded(app, "--fluctuate-every", options.fluctuate_every, 1, 1000,
              "conservative steps for one of fluctuation and dissipation");
  add_choice(app, "--eos", options.eos, {"ideal-gas", "argon", "burning-nitromethane"},
             "equation of state; the last: particles of reactant and product, whose mixture is solved");
  add_bounded(app, "--progress", options.progress, 0.0, 1.0,
              "of burning-nitromethane; 0 and 1: pure particles, which look at their kinetics alone");
  add_choice(app, "--kernel", options.kernel, sdpd::kernel_names(), "smoothing kernel of sdpd");
  add_bounded(app, "--kappa", options.kappa, 0.0, 1e3,
              "conduction: sdpd's thermal conductivity in W/(m K), dpde's pair coefficient in reduced "
              "units; 0: none");
  add_bounded(app, "--side", options.side, 6, 400, "particles along an edge of the cubic box");
  add_bounded(app, "--along", options.along, 0, 10000, "particles along z, if not as many; 0: as many");
  app.add_flag("--faces", options.faces,
               "walls, open faces and a box with 90 % vacuum beside the periodic one, across z");
  app.add_flag("--detonation", options.detonation,
               "a detonation of nitromethane between walls, half way through its box, and nitromethane that "
               "is half "
               "burnt all over, beside the ideal gas; --side 7 --along 172: the box of its scene")
      ->excludes("--faces");
  app.add_flag("--on-ranks", options.on_ranks,
               "the same steps inside LAMMPS on --ranks, beside the built-in engine on --threads (default 1)")
      ->excludes("--faces", "--detonation");
  add_bounded(app, "--K", options.K, 2.0, 1e9, "size of a particle; for dpde its heat capacity in k_B");
  add_bounded(app, "--steps", options.steps, 1, 1000000, "steps of one measurement");
  add_bounded(
      app, "--repeats", options.repeats, 1, 1000,
      "measurements, of which the median is given; with --faces, --detonation and --on-ranks their mean, and "
      "the ratio with its standard error");
}

} // namespace

extern Declaration const bench_engine_command = with_options<BenchEngineOptions, declare, run>;

} // namespace mesobridge::workflows
