#include "fitting/fit_dpde.hpp"
#include "fitting/particle_model_file.hpp"
#include "md/error.hpp"
#include "workflows/coarse/structure_of_blobs.hpp"
#include "workflows/command/options.hpp"
#include "workflows/report/number_text.hpp"
#include "workflows/sdpd/column_file.hpp"
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
  std::optional<std::filesystem::path> potential, friction,
      conduction; ///< what two particles do to each other
};

/// The tables that the user has, and the hashes of their files.
void put_tables(FitDpdeOptions const& options, fitting::ParticleModel& model) {
  auto const read = [&](std::optional<std::filesystem::path> const& file, char const* what,
                        std::vector<std::string> const& required, std::vector<std::string> const& optional,
                        fitting::PairColumns& columns) {
    if (!file)
      return;
    columns = read_columns(*file, required, optional);
    model.provenance[what] = fmt::format("{}, SHA-256 {}", file->filename().string(), sha256_of_file(*file));
  };
  read(options.potential, "potential", {"r", "u"}, {"f", "u_se"}, model.potential);
  read(options.friction, "friction", {"r", "gamma_par"}, {"gamma_perp", "gamma_par_se", "gamma_perp_se"},
       model.friction);
  read(options.conduction, "conduction", {"r", "kappa"}, {"kappa_se"}, model.conduction);
}

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
  auto const head = data.head;
  bool const melt = head.kind == "melt";
  auto const& name = head.name;
  fitting::ParticleModel model{.internal_energy = fitting::ConstantHeatCapacity(1), .reduced = true};
  model.mass = head.mass;
  if (melt)
    model.state = {head.rho * head.mass / head.atoms, kT_of(data)};
  EntropyFiles files{.melt = {}, .vacuum = {}, .microcanonical = {}, .order = options.order};
  (melt ? files.melt : files.vacuum) = std::move(data);
  auto const routes = entropy_routes(std::move(files));
  std::string const route =
      std::string(melt ? "melt" : "vacuum") + (options.route == "kinetic" ? "_kinetic" : "");
  auto const* const curve = routes.curve(route);
  auto const fit = fitting::fit_dpde(curve->fit, options.range);
  model.internal_energy = internal_energy_of(fit);
  model.data_hash = sha256_of_file(options.file);
  model.provenance = {{"program", fmt::format("mesobridge {}", version())},
                      {"git_commit", std::string(git_commit())},
                      {"command", context.command_line()},
                      {"data", options.file.filename().string()},
                      {"molecule", name},
                      {"route", route},
                      {"sampled_T", fmt::format("{:.4g} ... {:.4g}; beyond, C is constant", fit.T_sampled_low,
                                                fit.T_sampled_high)}};
  put_tables(options, model);
  auto const directory = context.output_directory("out/dpde");
  auto const file = directory / fmt::format("{}-{}.toml", name, melt ? "melt" : "vacuum");
  write_text_file(file, fitting::to_toml(model));
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
  app.add_option("--potential", options.potential,
                 "Of two particles: CSV with columns r,u, from `cg potential`")
      ->type_name("FILE.csv");
  app.add_option("--friction", options.friction,
                 "CSV with columns r,gamma_par,gamma_perp, from `cg friction`")
      ->type_name("FILE.csv");
  app.add_option("--conduction", options.conduction, "CSV with columns r,kappa")->type_name("FILE.csv");
  app.add_option("--T-min", options.range.T_min, "Lowest temperature of the model (default 0.05)");
  app.add_option("--T-max", options.range.T_max, "Highest temperature of the model (default 10)");
}

} // namespace

extern Declaration const fit_dpde_command = with_options<FitDpdeOptions, declare, fit_dpde>;

} // namespace mesobridge::workflows
