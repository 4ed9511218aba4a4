#include "fitting/fit_dpde.hpp"
#include "md/error.hpp"
#include "workflows/command/options.hpp"
#include "workflows/report/number_text.hpp"
#include "workflows/star/blob_analysis.hpp"
#include "workflows/summary.hpp"
#include "workflows/text_file.hpp"
#include "workflows/version.hpp"
#include <CLI/CLI.hpp>

namespace mesobridge::workflows {

namespace {

struct FitDpdeOptions {
  std::filesystem::path file;
  std::string route;
  std::size_t order = 3;
  fitting::DpdeRange range;
};

Json json_of(fitting::DpdeFit const& fit) {
  Json json{{"T_sampled_low", fit.T_sampled_low}, {"T_sampled_high", fit.T_sampled_high}, {"T", fit.T}};
  for (char const* key : {"C", "C_se", "U", "U_se"})
    json[key] = Json::array();
  for (std::size_t k = 0; k < fit.T.size(); ++k) {
    json["C"].push_back(fit.C[k].mean);
    json["C_se"].push_back(fit.C[k].se);
    json["U"].push_back(fit.eps[k].mean);
    json["U_se"].push_back(fit.eps[k].se);
  }
  json["C_covariance"] = fit.covariance;
  return json;
}

Result fit_dpde(FitDpdeOptions const& options, Context const& context) {
  auto data = read_blobs(options.file);
  bool const melt = data.head.kind == "melt";
  auto const name = data.head.name;
  EntropyFiles files{.melt = {}, .vacuum = {}, .microcanonical = {}, .order = options.order};
  (melt ? files.melt : files.vacuum) = std::move(data);
  auto const routes = entropy_routes(std::move(files));
  std::string const route =
      std::string(melt ? "melt" : "vacuum") + (options.route == "kinetic" ? "_kinetic" : "");
  auto const* const curve = routes.curve(route);
  auto const fit = fitting::fit_dpde(curve->fit, options.range);
  std::map<std::string, std::string> const provenance{
      {"program", fmt::format("mesobridge {}", version())},
      {"git_commit", std::string(git_commit())},
      {"command", context.command_line()},
      {"data", options.file.filename().string()},
      {"molecule", name},
      {"route", route},
      {"sampled_T",
       fmt::format("{:.4g} ... {:.4g}; beyond, C is constant", fit.T_sampled_low, fit.T_sampled_high)}};
  auto const directory = context.output_directory("out/dpde");
  auto const file = directory / fmt::format("{}-{}.toml", name, melt ? "melt" : "vacuum");
  write_text_file(file, fitting::to_toml(fit, sha256_of_file(options.file), provenance));
  Result result;
  result.json = json_of(fit);
  result.json["model"] = file.string();
  result.json["route"] = route;
  put(result.json, "heat_capacity", curve->C);
  write_summary(std::filesystem::path(file).replace_extension(".json"), result.json);
  result.text =
      fmt::format("C = {} k_B at U = {:.5g}; sampled T = {:.3g} ... {:.3g}: {}", with_error_text(curve->C),
                  routes.U_mean, fit.T_sampled_low, fit.T_sampled_high, file.string());
  return result;
}

void declare(CLI::App& app, FitDpdeOptions& options) {
  app.add_option("file", options.file, "What `md star-melt` or `md star-vacuum --T` wrote")
      ->required()
      ->type_name("FILE.h5");
  options.route = "density";
  app.add_option("--route", options.route, "density (ln P(U) + beta U) or kinetic (<1/E_kin>)")
      ->check(CLI::IsMember({"density", "kinetic"}));
  app.add_option("--order", options.order, "Terms of S(ln U), 1 ... 5 (default 3)");
  app.add_option("--T-min", options.range.T_min, "Lowest temperature of the model (default 0.05)");
  app.add_option("--T-max", options.range.T_max, "Highest temperature of the model (default 10)");
}

} // namespace

Command::Action fit_dpde_command(CLI::App& app) {
  return with_options<FitDpdeOptions>(app, declare, fit_dpde);
}

} // namespace mesobridge::workflows
