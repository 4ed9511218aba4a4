#include "workflows/eos_fit/fit_command.hpp"
#include "fitting/state_at_rest.hpp"
#include "md/error.hpp"
#include "workflows/eos_fit/column_guide.hpp"
#include "workflows/eos_fit/data_columns.hpp"
#include "workflows/eos_fit/data_file.hpp"
#include "workflows/eos_fit/fit_report.hpp"
#include "workflows/eos_fit/fit_summary.hpp"
#include "workflows/interrupt.hpp"
#include "workflows/provenance.hpp"
#include "workflows/quantity.hpp"
#include "workflows/text_file.hpp"
#include "workflows/version.hpp"
#include <CLI/CLI.hpp>
#include <charconv>
#include <spdlog/logger.h>

namespace mesobridge::workflows {
namespace {

struct Options {
  std::vector<std::filesystem::path> data;
  std::vector<std::string> fixed, bounds, start, free, relative_errors;
  std::string from, m0, region_rho, region_T;
  int bootstrap = 0;
  double error_floor = 0;
  bool local = false, columns = false;
};

double number(std::string const& text, std::string const& option, std::string const& whole) {
  double value = 0;
  auto const [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  bool const good = error == std::errc() && end == text.data() + text.size() && std::isfinite(value);
  require(good, option, whole, fmt::format("'{}' must be a finite number", text));
  return value;
}

/// "name=value"
std::pair<std::string, std::string> assignment(std::string const& text, std::string const& option,
                                               std::string const& form) {
  auto const equals = text.find('=');
  require(equals != text.npos && equals > 0, option, text, "must have the form " + form);
  return {text.substr(0, equals), text.substr(equals + 1)};
}

/// "low:high"
std::pair<double, double> range(std::string const& text, std::string const& option,
                                std::string const& whole) {
  auto const colon = text.find(':');
  require(colon != text.npos, option, whole, "must have the form low:high");
  return {number(text.substr(0, colon), option, whole), number(text.substr(colon + 1), option, whole)};
}

std::map<std::string, double> assignments(std::vector<std::string> const& texts, std::string const& option) {
  std::map<std::string, double> values;
  for (auto const& text : texts) {
    auto const [name, value] = assignment(text, option, "name=value");
    values[name] = number(value, option, text);
  }
  return values;
}

std::optional<fitting::EosRegion> region_of(Options const& options) {
  require(options.region_rho.empty() == options.region_T.empty(), "--region-rho, --region-T", "one of them",
          "must be given together");
  if (options.region_rho.empty())
    return std::nullopt;
  auto const [rho_min, rho_max] = range(options.region_rho, "--region-rho", options.region_rho);
  auto const [T_min, T_max] = range(options.region_T, "--region-T", options.region_T);
  return fitting::EosRegion{rho_min, rho_max, T_min, T_max};
}

fitting::EosFitOptions fit_options(Options const& options, Context const& context) {
  fitting::EosFitOptions fit{.fixed = assignments(options.fixed, "--fix"),
                             .start = assignments(options.start, "--start"),
                             .bounds = {},
                             .free = options.free,
                             .from = std::nullopt,
                             .region = region_of(options),
                             .search = {.seed = context.options.seed.value_or(1),
                                        .keep_going = [] { return !interrupt_requested(); }},
                             .bootstrap = options.bootstrap};
  for (auto const& text : options.bounds) {
    auto const [name, bounds] = assignment(text, "--bound", "name=low:high");
    fit.bounds[name] = range(bounds, "--bound", text);
  }
  if (options.local)
    fit.search.global_evaluations = 0;
  if (!options.from.empty())
    fit.from =
        fitting::load_eos(options.from, [](std::string const& file) { return read_text_file(file); }).eos;
  if (!options.m0.empty())
    try {
      fit.fixed["m0"] = parse_quantity(options.m0, Dimension::mass);
    } catch (InputError const& error) {
      throw InputError(fmt::format("--m0 '{}': {}", options.m0, error.what()));
    }
  require(
      fit.from || fit.fixed.contains("m0") || fit.fixed.contains("m0_kg"), "--m0", "nothing",
      "the mass of one atom or molecule must be given, like \"118.71 u\", or a model that has it (--from)");
  require(options.bootstrap == 0 || options.bootstrap >= 2, "--bootstrap", options.bootstrap,
          "must be 0 or at least 2");
  return fit;
}

EosData read_all(Options const& options) {
  RelativeErrors errors;
  for (auto const& text : options.relative_errors)
    add_relative_error(errors, text);
  EosData all;
  for (auto const& file : options.data) {
    auto data = read_eos_data(file, errors);
    std::ranges::move(data.observations, std::back_inserter(all.observations));
    std::ranges::move(data.notes, std::back_inserter(all.notes));
  }
  fitting::add_systematic_errors(all.observations, options.error_floor);
  std::ranges::move(fitting::add_states_at_rest(all.observations), std::back_inserter(all.notes));
  return all;
}

/// One hash for all files of data, in their order.
std::string hash_of(std::vector<std::filesystem::path> const& files) {
  if (files.size() == 1)
    return sha256_of_file(files.front());
  std::string hashes;
  for (auto const& file : files)
    hashes += sha256_of_file(file);
  return sha256(hashes);
}

std::map<std::string, std::string> model_provenance(fitting::EosFit const& fit, Options const& options,
                                                    Context const& context) {
  std::string files;
  for (auto const& file : options.data)
    files += (files.empty() ? "" : ", ") + file.string();
  return {{"program", fmt::format("mesobridge {}", version())},
          {"git_commit", std::string(git_commit())},
          {"command", context.command_line()},
          {"data", files},
          {"energy_offset_J_kg", fmt::format("{}", fit.energy_offset)}};
}

Result explain_columns() {
  Result result{.text = column_guide()};
  for (auto const& [symbol, units] : data_columns_and_units())
    result.json["units"][symbol] = units;
  return result;
}

Result run(fitting::FittableKind const& kind, Options const& options, Context const& context) {
  if (options.columns)
    return explain_columns();
  if (options.data.empty())
    throw InputError(fmt::format(
        "fit {}: DATA, a file at least, must be given (--columns explains what is in it)", kind.name));
  auto const settings = fit_options(options, context);
  auto const data = read_all(options);
  for (auto const& note : data.notes)
    context.log->info(note);
  auto const fit = fitting::fit_eos(kind.family(data.observations), data.observations, settings);
  for (auto const& sentence : fit.outcome.undetermined())
    context.log->warn(sentence);
  if (!fit.outcome.converged)
    context.log->warn("the search stopped before the fit was at its best");
  if (auto const complaint = bad_fit(fit.outcome))
    context.log->warn(*complaint);
  interrupts_end_at_once(); // drawing takes seconds, and every file is whole once it is there
  auto const file = context.options.output.value_or(kind.name + ".toml");
  auto report = file;
  report.replace_extension(".html");
  if (!file.parent_path().empty())
    std::filesystem::create_directories(file.parent_path());
  write_text_file(
      file, fitting::to_toml(fit.model(hash_of(options.data), model_provenance(fit, options, context))));
  write_text_file(report, eos_fit_report(fit, data.notes,
                                         {.command = context.command_line(),
                                          .seed = settings.search.seed,
                                          .scene = {},
                                          .inputs = {options.data.begin(), options.data.end()}}));
  Result result;
  result.json = {{"model", file.string()}, {"report", report.string()}, {"seed", settings.search.seed}};
  result.json.update(eos_fit_json(fit));
  result.json["notes"] = data.notes;
  result.text = eos_fit_text(fit) + file.string() + "\n" + report.string();
  return result;
}

void declare_options(CLI::App& app, Options& options) {
  app.add_option("data", options.data,
                 "CSV or HDF5 files. Columns: " + known_data_columns() +
                     ". A shock from rho0, T0 also says P(rho0, T0) = P0 (0 if there is none)")
      ->type_name("DATA");
  app.add_flag("--columns", options.columns, "Explain the rows and columns of data files, and end");
  auto const list = [&](char const* name, auto& target, char const* type, char const* text) {
    app.add_option(name, target, text)->type_name(type)->allow_extra_args(false);
  };
  list("--fix", options.fixed, "NAME=VALUE", "Keep a parameter at a value (SI); repeatable");
  list("--bound", options.bounds, "NAME=LOW:HIGH", "Fit a parameter within these bounds; repeatable");
  list("--start", options.start, "NAME=VALUE", "Begin the search here; repeatable");
  list("--free", options.free, "NAME", "Fit a parameter that is fixed by default; repeatable");
  list("--relative-error", options.relative_errors, "[QUANTITY=]FRACTION",
       "Standard error of data that have none, relative to their values; repeatable");
  app.add_option("--from", options.from, "Start values, and those of fixed parameters, from this model")
      ->type_name("NAME|FILE");
  app.add_option("--m0", options.m0, "Mass of one atom or molecule, \"118.71 u\" (default: that of --from)")
      ->type_name("MASS");
  app.add_option("--region-rho", options.region_rho,
                 "Densities [kg/m^3] where the model must be stable (default: those of the data)")
      ->type_name("LOW:HIGH");
  app.add_option("--region-T", options.region_T, "Temperatures [K] for it")->type_name("LOW:HIGH");
  app.add_option(
      "--error-floor", options.error_floor,
      "Systematic relative error of the data and the model's form, added in quadrature (of pressures at "
      "least of their spread, of energies of theirs)");
  app.add_option("--bootstrap", options.bootstrap, "Refit that many times to data drawn anew from the fit");
  app.add_flag("--local", options.local, "Only descend from the start values, without a global search");
}

} // namespace

Command fit_kind_command(fitting::FittableKind const& kind) {
  return {.name = "fit " + kind.name,
          .summary = "Fit the equation of state of " + kind.material + " to data",
          .example = "mesobridge fit " + kind.name + " " + kind.example,
          .declare = [kind](CLI::App& app) -> Command::Action {
            auto options = std::make_shared<Options>();
            declare_options(app, *options);
            return [kind, options](Context& context) { return run(kind, *options, context); };
          }};
}

} // namespace mesobridge::workflows
