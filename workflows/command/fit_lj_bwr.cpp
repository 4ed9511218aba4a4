#include "fitting/model_file.hpp"
#include "md/error.hpp"
#include "workflows/command/options.hpp"
#include "workflows/interrupt.hpp"
#include "workflows/lj/fit_summary.hpp"
#include "workflows/lj/state_csv.hpp"
#include "workflows/lj/state_grid_file.hpp"
#include "workflows/text_file.hpp"
#include "workflows/version.hpp"
#include <CLI/CLI.hpp>
#include <gsl/gsl_cdf.h>
#include <spdlog/logger.h>

namespace mesobridge::workflows {

namespace {

struct FitLjBwrOptions {
  std::filesystem::path data;
  std::string prior = "published", units = "lj";
  std::optional<double> prior_width;
  fitting::LjBwrFitOptions fit;
};

/// What `cg state-grid` wrote, or a table of the user's own.
cg::StateGrid states_of(std::filesystem::path const& file) {
  auto ending = file.extension().string();
  std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return char(std::tolower(c)); });
  return ending == ".csv" || ending == ".tsv" || ending == ".txt" || ending == ".dat"
             ? parse_state_csv(read_text_file(file), file.string())
             : read_state_grid(file);
}

Result fit(FitLjBwrOptions const& options, Context const& context) {
  auto settings = options.fit;
  settings.prior = options.prior == "published" ? fitting::LjBwrPrior::published : fitting::LjBwrPrior::none;
  settings.prior_width = options.prior_width;
  auto const fitted = fitting::fit_lj_bwr(states_of(options.data), settings);
  double const probability =
      fitted.degrees_of_freedom > 0 ? gsl_cdf_chisq_Q(fitted.chi_2, fitted.degrees_of_freedom) : 1;
  constexpr double least = 1e-3;
  if (probability < least)
    context.log->warn(
        "bad fit: chi^2 = {:.4g} for {:.4g} degrees of freedom (probability {:.2g}): the model does not "
        "agree with the data within their errors",
        fitted.chi_2, fitted.degrees_of_freedom, probability);
  throw_if_interrupted();
  auto const units = options.units == "argon" ? std::optional(argon_units) : std::nullopt;
  auto const model = fitting::model_of(fitted, units, sha256_of_file(options.data),
                                       {{"program", fmt::format("mesobridge {}", version())},
                                        {"git_commit", std::string(git_commit())},
                                        {"command", context.command_line()},
                                        {"data", options.data.string()}});
  auto const file = context.options.output.value_or("lj-bwr.toml");
  if (!file.parent_path().empty())
    std::filesystem::create_directories(file.parent_path());
  write_text_file(file, fitting::to_toml(model));
  Result result;
  result.json = {{"model", file.string()}};
  result.json.update(fit_json(fitted));
  result.json["chi_2_probability"] = probability;
  result.json["bad_fit"] = probability < least;
  result.text = fit_text(fitted) + file.string();
  return result;
}

void declare(CLI::App& app, FitLjBwrOptions& options) {
  app.add_option("data", options.data,
                 "What `cg state-grid` wrote, or a CSV file with rho, T, U (or U_res, less 3/2 T), P and "
                 "their errors U_se, P_se")
      ->required()
      ->type_name("DATA.h5|DATA.csv");
  app.add_option("--prior", options.prior, "Start from the 1993 set and correct it, or from nothing")
      ->check(CLI::IsMember({"published", "none"}));
  app.add_option("--prior-width", options.prior_width,
                 "Relative uncertainty of the prior's U and P (default: of largest evidence)");
  app.add_flag("--fit-gamma", options.fit.fit_gamma, "Search gamma as well");
  // U and P are so correlated that errors of cut-off, size and time step show in a combination of the
  // two.
  options.fit.relative_error_floor = 1e-3;
  app.add_option("--error-floor", options.fit.relative_error_floor,
                 "Systematic relative error of the data, added in quadrature");
  app.add_option("--folds", options.fit.folds, "Leave out every k-th state together (0: one at a time)");
  app.add_option("--units", options.units, "Units of the model: lj, or SI of argon")
      ->check(CLI::IsMember({"lj", "argon"}));
}

} // namespace

extern Declaration const fit_lj_bwr_command = with_options<FitLjBwrOptions, declare, fit>;

} // namespace mesobridge::workflows
