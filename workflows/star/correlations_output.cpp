#include "workflows/report/number_text.hpp"
#include "workflows/star/blob_analysis.hpp"
#include "workflows/summary.hpp"
#include <cmath>

namespace mesobridge::workflows {

namespace {

Json profile_json(cg::Profile const& profile, char const* x, char const* y) {
  Json json{{x, profile.x}, {y, Json::array()}, {std::string(y) + "_se", Json::array()}};
  for (auto const& estimate : profile.y) {
    json[y].push_back(estimate.mean);
    json[std::string(y) + "_se"].push_back(estimate.se);
  }
  return json;
}

Json map_json(cg::RelativeErrorMap const& map) {
  Json json{
      {"K", map.K}, {"U", map.U}, {"relative_error", Json::array()}, {"relative_error_se", Json::array()}};
  for (std::size_t bin = 0; bin < map.error.size(); ++bin) { // null: too few samples
    json["relative_error"].push_back(map.computed[bin] ? Json(map.error[bin].mean) : Json());
    json["relative_error_se"].push_back(map.computed[bin] ? Json(map.error[bin].se) : Json());
  }
  json["typical"] = map.typical;
  json["typical_from_noise"] = map.typical_from_noise;
  return json;
}

void put_time(Json& json, char const* key, cg::MemoryTime const& time) {
  json[key] = time.tau;
  json[std::string(key) + "_se"] = time.se;
}

/// Beyond any number of standard errors there is nothing to tell apart.
double told_deviation(double in_se) {
  return std::isfinite(in_se) ? in_se : std::copysign(1e6, in_se);
}

} // namespace

cg::BlobSeries series_of(BlobData data) {
  cg::BlobSeries series{.molecules = std::size_t(data.head.molecules),
                        .atoms = data.head.atoms,
                        .mass = data.head.mass,
                        .free_atoms = data.head.T > 0, // a melt of our own
                        .times = std::move(data.times),
                        .boxes = std::move(data.boxes),
                        .R = std::move(data.R),
                        .P = std::move(data.P),
                        .U_kin = std::move(data.U_kin)};
  for (std::size_t k = 0; k < series.U_kin.size(); ++k)
    series.U.push_back(series.U_kin[k] + data.U_pot[k]);
  return series;
}

double default_h(BlobFileHead const& head) {
  return 10 * std::cbrt(0.3 / head.rho * head.atoms / 19);
}

std::size_t default_pair_stride(cg::BlobSeries const& series) {
  double const tau = cg::memory_time(series.U, series.molecules, series.interval()).tau;
  return std::max<std::size_t>(1, std::size_t(tau / (8 * series.interval())));
}

Json correlations_json(cg::Correlations const& found) {
  Json json;
  put(json, "beta", found.beta);
  put(json, "C_KU", found.C_KU);
  json["C_KU_expected"] = found.C_KU_expected;
  put(json, "C_UD", found.C_UD);
  put(json, "C_UD_configurational", found.configurational.C_UD);
  put(json, "U_mean", found.U_mean);
  put(json, "U_variance", found.U_variance);
  put(json, "K_mean", found.K_mean);
  put(json, "P_x_kurtosis", found.kurtosis);
  put(json, "density_mean", found.density_mean);
  put(json, "density_variance", found.density_variance);
  put_time(json, "tau_P", found.tau_P);
  put_time(json, "tau_U", found.tau_U);
  put_time(json, "tau_density", found.tau_rho);
  json["tau_R"] = found.tau_R;
  put(json, "diffusion", found.D);
  json["blocks"] = found.blocks;
  json["block_time"] = found.block_time;
  json["contact_r"] = found.contact;
  put(json, "contact_energy", found.contact_energy);
  put(json, "contact_energy_configurational", found.configurational.contact_energy);
  json["tests"] = Json::array();
  for (auto const& test : found.tests)
    json["tests"].push_back({{"test", test.name},
                             {"deviation", test.deviation.mean},
                             {"deviation_se", test.deviation.se},
                             {"in_standard_errors", told_deviation(test.in_se)},
                             {"statement", test.statement}});
  json["P_x"] = profile_json(found.P_x, "P_x", "density");
  json["P_U"] = profile_json(found.P_U, "U", "density");
  json["g"] = profile_json(found.g, "r", "g");
  json["u"] = profile_json(found.u, "r", "u");
  json["u_minus_g"] = profile_json(found.u_minus_g, "r", "u_minus_g");
  json["pair_energy"] = profile_json(found.pair_energy, "r", "U1U2_over_U_squared");
  json["u_minus_g_configurational"] = profile_json(found.configurational.u_minus_g, "r", "u_minus_g");
  json["pair_energy_configurational"] =
      profile_json(found.configurational.pair_energy, "r", "U1U2_over_U_squared");
  json["U_of_density_configurational"] =
      profile_json(found.configurational.U_of_density, "rho", "U_relative_deviation");
  json["U_of_density"] = profile_json(found.U_of_density, "rho", "U_relative_deviation");
  json["relative_error_map"] = map_json(found.map);
  return json;
}

std::string correlations_text(cg::Correlations const& found) {
  std::string text = fmt::format(
      "beta  {}\nC_KU  {}\nC_UD  {}\n<U>   {}\n"
      "autocorrelation times: P {:.3g}, U {:.3g}, local density {:.3g}; a centre diffuses a mean distance in "
      "{:.3g}\nerrors from {} blocks of {:.3g} time units\n\n{:<47} {:>12} {:>10}  {}\n",
      with_error_text(found.beta), with_error_text(found.C_KU), with_error_text(found.C_UD),
      with_error_text(found.U_mean), found.tau_P.tau, found.tau_U.tau, found.tau_rho.tau, found.tau_R,
      found.blocks, found.block_time, "test of the key approximation", "deviation", "in se", "");
  for (auto const& test : found.tests)
    text += fmt::format("{:<47} {:>12.3g} {:>10.2f}  {}\n", test.name, test.deviation.mean, test.in_se,
                        test.statement);
  return text;
}

} // namespace mesobridge::workflows
