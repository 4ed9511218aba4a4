#include "workflows/reproduce/stability.hpp"
#include "workflows/interrupt.hpp"
#include "workflows/report/number_text.hpp"
#include "workflows/reproduce/ideal_gas_study.hpp"
#include <algorithm>

namespace mesobridge::workflows {
namespace {

constexpr double time_of_a_run = 50; ///< reduced; the thesis took 500 to 20000

Scene fluid(std::string const& eos, double rho, double T, double K, double eta, std::string const& scheme) {
  Scene scene;
  scene.title = eos;
  scene.fluid = {.eos = eos, .rho = rho, .T = T, .m0 = {}};
  if (eos == "ideal-gas")
    scene.fluid.m0 = 1e-25;
  scene.particles.K = K;
  scene.particles.kernel = "cubic", scene.particles.density = "plain"; // the thesis's
  scene.transport.eta = eta;
  scene.scheme.name = scheme;
  return scene;
}

void add(std::vector<StabilityCase>& cases, std::string group, Scene scene, double dt,
         std::string expected = "") {
  scene.scheme.dt = {.value = dt, .reduced = true};
  std::string name = fmt::format("{}, {}, K = {:g}, {:g} kg/m³, {:g} K, η = {:g} Pa s, dt = {:g}",
                                 scene.fluid.eos, scene.scheme.name, scene.particles.K, scene.fluid.rho,
                                 scene.fluid.T, scene.transport.eta, dt);
  if (scene.scheme.conservative == "mclachlan")
    name += ", mclachlan";
  if (scene.scheme.energy == "kept")
    name += ", energy kept";
  cases.push_back({std::move(group), std::move(name), std::move(scene), std::move(expected)});
}

/// What the thesis says of schemes and time steps (sections 4.2.2, 4.3.3).
void add_schemes(std::vector<StabilityCase>& cases) {
  std::string const alone = "fluctuation and dissipation alone";
  auto in_place = [&](std::string const& scheme, double K, double dt, std::string const& expected) {
    Scene scene = fluid("ideal-gas", 1150, 1000, K, 2e-3, scheme);
    scene.scheme.conservative = "none";
    add(cases, alone, scene, dt, expected);
  };
  in_place("ssa", 5, 0.02, "runs"), in_place("ssa", 5, 0.1, "fails");
  for (double const dt : {0.001, 0.02})
    in_place("ssa", 2, dt, "fails");
  in_place("ssa", 50, 1, "runs");
  for (std::string const scheme : {"ems", "ams"})
    for (double const dt : {1.0, 5.0})
      in_place(scheme, 5, dt, "runs"), in_place(scheme, 2, dt, "runs");
  std::string const whole = "the whole dynamics";
  auto moving = [&](std::string const& scheme, double K, double dt, std::string const& expected) {
    add(cases, whole, fluid("ideal-gas", 1150, 1000, K, 2e-3, scheme), dt, expected);
  };
  for (std::string const scheme : {"ems", "ams"})
    for (double const dt : {0.1, 0.3, 0.4, 0.8})
      moving(scheme, 5, dt, dt < 0.35 ? "runs" : "");
  // Verlet itself ends near 0.5; two evaluations of the forces a step reach the 0.8 that the thesis names.
  for (std::string const scheme : {"ems", "ams"})
    for (double const K : {2.0, 5.0}) {
      Scene scene = fluid("ideal-gas", 1150, 1000, K, 2e-3, scheme);
      scene.scheme.conservative = "mclachlan", scene.scheme.energy = "kept";
      add(cases, whole, scene, 0.8, "runs");
    }
  moving("ems", 2, 0.1, "runs"), moving("ams", 2, 0.1, "runs");
  moving("ssa", 10, 0.3, "runs");
  moving("ser", 10, 0.01, "runs"), moving("ser", 10, 0.035, ""), moving("ser", 10, 0.2, "fails");
}

/// States far from everyday ones.
void add_states(std::vector<StabilityCase>& cases) {
  std::string const group = "extreme states";
  double const dt = 0.05;
  for (std::string const scheme : {"ssa", "ams", "ems"}) {
    for (double const T : {1.0, 100.0, 1e4, 1e5})
      for (std::string const eos : {"ideal-gas", "argon"})
        add(cases, group, fluid(eos, 1150, T, 50, 2e-3, scheme), dt);
    for (double const rho : {0.1, 10.0, 100.0, 2300.0})
      for (std::string const eos : {"ideal-gas", "argon"})
        add(cases, group, fluid(eos, rho, 1000, 50, 2e-3, scheme), dt);
    for (double const eta : {1e-6, 0.05, 1.0})
      for (std::string const eos : {"ideal-gas", "argon"})
        add(cases, group, fluid(eos, 1150, 1000, 50, eta, scheme), dt);
    for (double const T : {300.0, 3000.0})
      add(cases, group, fluid("tin", 7775, T, 50, 1e-3, scheme), dt),
          add(cases, group, fluid("nitromethane", 1140, T, 50, 2e-3, scheme), dt);
  }
}

std::string outcome(sdpd::TrialResult const& result) {
  return result.failed() ? "fails" : "runs";
}

} // namespace

std::vector<StabilityCase> stability_cases() {
  std::vector<StabilityCase> cases;
  add_schemes(cases);
  add_states(cases);
  return cases;
}

std::vector<sdpd::TrialResult> run_stability(std::vector<StabilityCase> const& cases, double time,
                                             StudyOptions const& options) {
  std::vector<PlannedTrial> plan;
  for (auto const& one : cases) {
    Scene scene = small_sample(one.scene, 216);
    set_times(scene, one.scene.scheme.dt.value, 0, time);
    plan.push_back({fmt::format("case{}-{}", plan.size(), one.scene.fluid.eos), scene,
                    cg::Bins{.lower = 0, .upper = 1e4, .count = 1}});
  }
  return run_study(plan, options);
}

Reproduced reproduce_stability(ReproduceOptions const& options, Context const& context) {
  auto const cases = stability_cases();
  auto progress = context.progress("Stability", 1);
  std::error_code ignored;
  std::filesystem::create_directories(options.directory / "trials",
                                      ignored); // writing there says what is wrong
  auto const results = run_stability(cases, time_of_a_run * run_length_of(options.preset).length,
                                     {.directory = options.directory / "trials",
                                      .threads = options.threads,
                                      .keep_going = [&](double share, std::string const& name) {
                                        progress.update(share, name);
                                        return !interrupt_requested();
                                      }});
  progress.finish();
  Reproduced found;
  std::vector<Section> sections;
  std::size_t failed = 0, unexpected = 0;
  for (std::size_t k = 0; k < cases.size(); ++k) {
    auto const& [group, name, scene, expected] = cases[k];
    if (sections.empty() || sections.back().title != group)
      sections.push_back(
          {group, {Table{.header = {"run", "outcome", "expected", "T_kin / T", "what it says"}}}});
    auto const& result = results[k];
    bool const surprise = !expected.empty() && expected != outcome(result);
    failed += result.failed(), unexpected += surprise;
    std::get<Table>(sections.back().content[0])
        .rows.push_back({name, outcome(result) + (surprise ? " (!)" : ""), expected,
                         result.failed() ? "" : with_error_text(result.T_kin), result.failure});
    Json row{{"name", name}, {"outcome", outcome(result)}};
    if (!expected.empty())
      row["expected"] = expected;
    if (result.failed())
      row["failure"] = result.failure;
    found.summary["runs"].push_back(row);
  }
  found.summary["failed"] = failed, found.summary["unexpected"] = unexpected;
  found.report = {
      .title = "Stability at the extremes",
      .lead = fmt::format("{} runs, of which {} could not go on and said why; {} differ from what the thesis "
                          "or an independent code found.",
                          cases.size(), failed, unexpected),
      .verdicts = {},
      .sections = std::move(sections),
      .provenance = {}};
  return found;
}

} // namespace mesobridge::workflows
