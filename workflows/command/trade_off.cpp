#include "sdpd/scheme/list.hpp"
#include "workflows/command/options.hpp"
#include "workflows/folder_lock.hpp"
#include "workflows/interrupt.hpp"
#include "workflows/sdpd/settings.hpp"
#include "workflows/shared_options.hpp"
#include "workflows/study/target.hpp"
#include "workflows/study/trade_off_summary.hpp"
#include "workflows/study/tries.hpp"
#include "workflows/summary.hpp"

namespace mesobridge::workflows {
namespace {

struct TradeOffOptions {
  std::string scene;
  std::vector<std::string> set;
  TradeOffPlan plan{.schemes = {},
                    .splittings = {"lie-trotter"},
                    .integrators = {"verlet", "mclachlan"},
                    .dt = {},
                    .K = {}};
  std::optional<std::string> drift, bias, dynamics;
  bool no_limit = false;
};

/// What the options leave open. DPD has no energies that ams and ems could look at.
TradeOffPlan completed(TradeOffPlan plan, Scene const& scene) {
  if (plan.schemes.empty())
    plan.schemes = scene.features().energies ? std::vector<std::string>{"ssa", "ams", "ems"}
                                             : std::vector<std::string>{"ssa", "ser"};
  if (plan.dt.empty())
    plan.dt = tries_of(scene).compared;
  if (plan.K.empty())
    plan.K = {scene.particles.K};
  else
    require(scene.features().densities, "--K", plan.K.front(),
            "belongs to SDPD: the particles of this scene have no size");
  return plan;
}

void check_plan(TradeOffPlan const& plan, Scene const& scene) {
  auto const settings = settings_of(scene, 1);
  for (auto const& name : plan.schemes)
    if (auto const why = sdpd::refusal(sdpd::pair_integrator(name), settings.features(), settings.noise))
      throw InputError(fmt::format("--schemes = {}: {}", name, *why));
  for (auto const& name : plan.integrators)
    sdpd::conservative_integrator(name);
  for (auto const& name : plan.splittings)
    require(name == "lie-trotter" || name == "strang", "--splittings", name, "must be lie-trotter or strang");
  for (double const dt : plan.dt)
    require(dt > 0 && std::isfinite(dt), "--dt", dt, "must be > 0 (reduced units)");
  for (double const K : plan.K)
    require(!scene.features().densities || sdpd::Sdpd::sizes.contains(K), "--K", K,
            "must be " + sdpd::Sdpd::sizes.text());
}

Target target_of(TradeOffOptions const& options, Scene const& scene) {
  auto read = [&](char const* option, std::optional<std::string> const& text, auto const& parse) {
    try {
      parse();
    } catch (InputError const& error) {
      throw InputError(fmt::format("{} {}: {}", option, *text, error.what()));
    }
  };
  Target target;
  if (options.drift)
    require(scene.features().energies, "--drift", *options.drift,
            "the thermostat of DPD keeps no energy that could drift; give a --bias");
  double const time = settings_of(scene, 1).units().time();
  read("--drift", options.drift,
       [&] { target.drift = parse_target(options.drift, {}, {}, scene.units, time).drift; });
  read("--bias", options.bias,
       [&] { target.bias = parse_target({}, options.bias, {}, scene.units, time).bias; });
  read("--dynamics", options.dynamics,
       [&] { target.dynamics = parse_target({}, {}, options.dynamics, scene.units, time).dynamics; });
  return target;
}

Result measure_trade_off(TradeOffOptions const& options, Context const& context) {
  auto overrides = options.set;
  if (context.options.seed)
    overrides.push_back(fmt::format("run.seed={}", *context.options.seed));
  Scene const scene = load_scene(options.scene, overrides);
  auto plan = completed(options.plan, scene);
  plan.stability_limit = !options.no_limit;
  check_plan(plan, scene);
  auto const target = target_of(options, scene);
  auto const directory =
      context.output_directory("out/trade-off-" + std::filesystem::path(options.scene).stem().string());
  FolderLock const lock(directory, context.command_line());
  std::error_code ignored;
  std::filesystem::create_directories(directory / "trials", ignored); // writing there says what is wrong
  auto progress = context.progress("Trade-off", 1);
  auto const found = trade_off(scene, plan,
                               {.directory = directory / "trials",
                                .threads = context.options.threads.value_or(available_threads()),
                                .keep_going = [&](double share, std::string const& name) {
                                  progress.update(share, name);
                                  return !interrupt_requested();
                                }});
  progress.finish();
  auto report = trade_off_report(found, target);
  report.provenance = {
      context.command_line(), static_cast<std::uint64_t>(scene.run.seed), resolved_toml(scene), {}};
  auto result = with_report(directory, trade_off_json(found, target), report.html());
  if (target.any())
    result.text = recommendation_text(found, target) + result.text;
  return result;
}

void declare(CLI::App& app, TradeOffOptions& options) {
  auto& plan = options.plan;
  add_scene(app, options.scene, options.set);
  app.add_option("--schemes", plan.schemes, "pair schemes (default: ssa, ams, ems; of DPD ssa, ser)")
      ->delimiter(',');
  app.add_option("--splittings", plan.splittings, "lie-trotter, strang")->delimiter(',');
  app.add_option("--integrators", plan.integrators, "of the conservative forces")->delimiter(',');
  app.add_option("--dt", plan.dt,
                 "time steps, reduced (default: five from 0.05 to 0.3; of soft particles from 0.01 to 0.06)")
      ->delimiter(',');
  app.add_option("--K", plan.K, "sizes of particles (default: the scene's)")->delimiter(',');
  app.add_option("--time", plan.time, "reduced time that each run samples")->check(CLI::Range(20., 1e7));
  app.add_option("--particles", plan.particles, "of a run, at least")->check(CLI::Range(125, 1000000));
  app.add_option("--drift", options.drift, "Wanted energy drift, such as 1e-6/ps")->type_name("RATE");
  app.add_option("--bias", options.bias, "Wanted bias of T_kin, T_int and P, such as 0.5%")
      ->type_name("SHARE");
  app.add_option("--dynamics", options.dynamics,
                 "By how much the time step may change self-diffusion, such as 5%")
      ->type_name("SHARE");
  app.add_flag("--no-limit", options.no_limit, "do not search for the largest stable time steps");
}

} // namespace

extern Declaration const trade_off_command = with_options<TradeOffOptions, declare, measure_trade_off>;

} // namespace mesobridge::workflows
