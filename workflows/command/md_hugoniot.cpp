#include "cg/hugoniot_plan.hpp"
#include "md/error.hpp"
#include "workflows/command/options.hpp"
#include "workflows/metal/hugoniostat_check.hpp"
#include "workflows/metal/metal_options.hpp"
#include "workflows/metal/metal_sampler.hpp"
#include "workflows/metal/metal_table.hpp"
#include "workflows/ranks.hpp"
#include "workflows/report/number_text.hpp"
#include "workflows/shared_options.hpp"
#include "workflows/summary.hpp"
#include "workflows/text_file.hpp"
#include <algorithm>
#include <spdlog/logger.h>

namespace mesobridge::workflows {

namespace {

constexpr char const* meaning = "equilibrium states of even compression: behind a shock whose shear stress "
                                "has relaxed, without an elastic "
                                "precursor; solid or liquid as a run of picoseconds from this start stays";

struct MdHugoniotOptions {
  MetalOptions metal;
  cg::HugoniotRequest request;
  bool hugoniostat = false;
};

cg::Phase start_of(md::MetalSettings const& settings) {
  return settings.start == md::MetalStart::solid ? cg::Phase::solid : cg::Phase::liquid;
}

/// Refuses what cannot be sampled before any rank starts.
void check_request(cg::HugoniotRequest request, md::MetalSettings const& settings) {
  md::check({.rho = request.rho0.value_or(md::stated_density(settings.potential)), .T = request.T0},
            settings);
  for (double compression : request.compressions)
    require(compression >= 1.01, "--compression", compression, "must be at least 1.01");
  for (double v_P : request.v_P)
    require(v_P > 0 && std::isfinite(v_P), "--vp [m/s]", v_P, "must be > 0");
  md::QuasiharmonicMetal metal(md::MpiWorld(), settings);
  if (!request.rho0)
    request.rho0 = metal.zero_pressure_density(request.T0);
  for (auto const& state : cg::plan_hugoniot(request, metal, start_of(settings), {}).missing)
    md::check(state, settings);
}

/// On the ranks that run already: samples what the plan asks for until it asks for nothing.
void sample(MetalJob const& job, cg::HugoniotRequest const& request, Context const& context) {
  guard_ranks([&] {
    md::MpiWorld const world;
    if (!world.is_root())
      return MetalSampler::serve(world, job);
    MetalSampler sampler(world, job, context);
    md::QuasiharmonicMetal metal(world, job.settings);
    for (;;) {
      auto const curve = cg::plan_hugoniot(request, metal, start_of(job.settings), sampler.points());
      if (curve.missing.empty())
        break;
      sampler.sample(curve.missing,
                     curve.initial ? "states about the Hugoniot curve" : "states about zero pressure");
    }
    sampler.close();
  });
}

Json line_json(cg::Line const& line, std::size_t points) {
  return {{"c0_m_s", line.a},
          {"c0_m_s_se", std::sqrt(line.var_a)},
          {"s", line.b},
          {"s_se", std::sqrt(line.var_b)},
          {"chi_2", line.chi_2},
          {"degrees_of_freedom", points - 2},
          {"correlation", line.cov_ab / std::sqrt(line.var_a * line.var_b)}};
}

std::string line_text(cg::Line const& line, std::size_t points) {
  return fmt::format("v_S = c0 + s v_P: c0 = {} m/s, s = {}, chi^2 = {:.4g} for {} degrees of freedom{}\n",
                     with_error_text({line.a, std::sqrt(line.var_a), 0}),
                     with_error_text({line.b, std::sqrt(line.var_b), 0}), line.chi_2, points - 2,
                     line.chi_2 > 3 * double(points - 2) ? " (a curve: the errors are those of the scatter)"
                                                         : "");
}

/// Rereads what was sampled and writes the curve.
Result curve(MetalJob const& job, cg::HugoniotRequest const& request, bool hugoniostat,
             Context const& context) {
  auto const directory = job.runs.parent_path();
  auto const description = job.settings.description();
  auto const sampled = read_metal_points(job.runs, job.settings).points;
  md::QuasiharmonicMetal metal(md::MpiWorld(), job.settings);
  auto const found = cg::plan_hugoniot(request, metal, start_of(job.settings), sampled);
  if (found.points.empty())
    throw PhysicsError(
        fmt::format("no point of the Hugoniot curve was found: {}", fmt::join(found.unsolved, "; ")));
  Provenance const provenance{.command = context.command_line(),
                              .seed = job.settings.seed,
                              .scene = "",
                              .inputs = {job.settings.potential.file, job.runs}};
  auto const h5 = directory / "hugoniot.h5", csv = directory / "hugoniot.csv";
  write_hugoniot(h5, found.points, description, provenance);
  write_text_file(csv, hugoniot_csv(found.points));

  Result result;
  auto warnings = warnings_on(sampled, job.settings);
  for (auto const& reason : found.unsolved)
    warnings.push_back("left out: " + reason);
  if (!found.missing.empty())
    warnings.push_back(fmt::format("{} more states are needed: go on with --resume", found.missing.size()));
  for (auto const& warning : warnings)
    context.log->warn("{}", warning);
  result.json = {{"file", h5.string()},
                 {"csv", csv.string()},
                 {"runs", job.runs.string()},
                 {"settings", description},
                 {"meaning", meaning},
                 {"rho0_kg_m3", found.rho0.mean},
                 {"rho0_kg_m3_se", found.rho0.se},
                 {"T0_K", request.T0},
                 {"warnings", warnings},
                 {"points", hugoniot_json(found.points)},
                 {"states", metal_grid_json(sampled)}};
  result.text = fmt::format("{};\n{}\nfrom {} kg/m^3, {} K\n{}", description, meaning,
                            with_error_text(found.rho0), request.T0, hugoniot_text(found.points));
  if (found.points.size() >= 3) {
    auto const line = cg::fit_us_up(found.points);
    result.json["us_up"] = line_json(line, found.points.size());
    result.text += line_text(line, found.points.size());
  }
  if (hugoniostat) {
    auto const is_initial = [&](auto const& point) { return point.state == *found.initial; };
    auto const initial = std::find_if(sampled.begin(), sampled.end(), is_initial);
    auto const checks = check_by_hugoniostat(*initial, found.points, job.settings, context);
    result.json["hugoniostat"] = hugoniostat_json(checks);
    result.text += hugoniostat_text(checks);
  }
  result.text += csv.string();
  write_summary(directory / "hugoniot.json", result.json);
  return result;
}

Result sample_hugoniot(MdHugoniotOptions const& options, Context const& context) {
  MetalJob job{.settings = settings_of(options.metal, context), .runs = {}, .resume = options.metal.resume};
  auto request = options.request;
  if (request.compressions.empty() && request.v_P.empty())
    request.compressions = {1.06, 1.1, 1.14, 1.18, 1.22};
  require(!options.hugoniostat || job.settings.start == md::MetalStart::solid, "--start", options.metal.start,
          "must be solid with --hugoniostat, which begins with the crystal");
  auto const directory = context.output_directory("out/hugoniot");
  job.runs = directory / "hugoniot-runs.h5";
  job.settings.log_file = directory / "lammps.log";
  check_request(request, job.settings);
  keep_earlier_results(options.metal, job, directory, "hugoniot", context);
  if (!work_and_tell(context, options.metal.started_by_ourselves, [&] { sample(job, request, context); }))
    return told_elsewhere();
  return curve(job, request, options.hugoniostat, context);
}

void declare(CLI::App& app, MdHugoniotOptions& options) {
  add_options(app, options.metal);
  app.add_option("--T0", options.request.T0, "Temperature before the shock [K]");
  app.add_option("--rho0", options.request.rho0, "Density before it [kg/m^3] (default: of zero pressure)")
      ->type_name("REAL");
  add_list(app, "--compression", options.request.compressions,
           "Densities behind it in units of rho0 (default: 1.06 ... 1.22)");
  add_list(app, "--vp", options.request.v_P,
           "Velocities behind it [m/s]; met about, and measured at the density that is taken for each");
  app.add_flag("--hugoniostat", options.hugoniostat,
               "Also let LAMMPS's Hugoniostat (fix nphug) find each state at its pressure, and compare");
}

} // namespace

extern Declaration const md_hugoniot_command = with_options<MdHugoniotOptions, declare, sample_hugoniot>;

} // namespace mesobridge::workflows
