#include "md/error.hpp"
#include "workflows/report/number_text.hpp"
#include "workflows/star/blob_analysis.hpp"
#include "workflows/summary.hpp"

namespace mesobridge::workflows {

namespace {

void require_kind(BlobData const& data, std::string const& kind) {
  if (data.head.kind != kind)
    throw InputError(fmt::format("a file of kind '{}' was given where '{}' is needed", data.head.kind, kind));
}

std::optional<cg::LevelSeries> levels_of(std::optional<BlobData> data, std::string const& kind) {
  if (!data)
    return std::nullopt;
  require_kind(*data, kind);
  auto set = data->head.set;
  return cg::LevelSeries{.blobs = series_of(std::move(*data)), .set = std::move(set)};
}

} // namespace

cg::EntropyRoutes entropy_routes(EntropyFiles files) {
  if (!files.melt && !files.vacuum)
    throw InputError("neither --melt nor --vacuum was given: at least one is needed");
  cg::EntropyInputs inputs{.melt = {},
                           .vacuum = levels_of(std::move(files.vacuum), "vacuum canonical"),
                           .microcanonical =
                               levels_of(std::move(files.microcanonical), "vacuum microcanonical"),
                           .order = files.order};
  if (files.melt) {
    require_kind(*files.melt, "melt");
    inputs.melt = series_of(std::move(*files.melt));
  }
  return cg::entropy_routes(inputs);
}

Json entropy_json(cg::EntropyRoutes const& routes) {
  Json json{{"U_mean", routes.U_mean}};
  for (auto const& curve : routes.curves) {
    put(json, "heat_capacity_" + curve.name, curve.C);
    json["heat_capacity_" + curve.name + "_bias"] = curve.C_bias;
  }
  if (routes.C_from_variance)
    put(json, "heat_capacity_melt_from_variance", *routes.C_from_variance);
  if (routes.equipartition) {
    put(json, "heat_capacity_vacuum_equipartition", routes.equipartition->slope_C());
    put(json, "heat_capacity_vacuum_equipartition_at_U_mean", routes.equipartition->C(routes.U_mean));
    put(json, "T_equipartition_at_U_mean", routes.equipartition->T(routes.U_mean));
    json["equipartition_from"] = routes.equipartition_from;
  }
  json["curves"] = Json::object();
  for (auto const& curve : routes.curves) {
    Json columns{{"U", routes.U}};
    for (char const* key : {"S", "S_se", "T", "T_se", "C", "C_se"})
      columns[key] = Json::array();
    auto const put_at = [&](char const* key, cg::Estimate const& estimate) {
      columns[key].push_back(estimate.mean);
      columns[std::string(key) + "_se"].push_back(estimate.se);
    };
    for (double U : routes.U) {
      put_at("S", curve.fit.estimate([&](auto const& c) { return c.S(U) - c.S(routes.U_mean); }));
      put_at("T", curve.fit.estimate([&](auto const& c) { return c.T(U); }));
      put_at("C", curve.fit.estimate([&](auto const& c) { return c.C(U); }));
    }
    columns["U_low"] = curve.fit.curve.U_low();
    columns["U_high"] = curve.fit.curve.U_high();
    columns["samples"] = curve.fit.samples;
    auto const& basis = curve.fit.curve.basis();
    columns["method"] =
        fmt::format("S = sum of theta_j y^j, y = ln((U - {0:.6g})/({1:.6g} - {0:.6g}))/{2:.4g}, {3} terms",
                    basis.U_0, basis.U_ref, basis.width, basis.order);
    json["curves"][curve.name] = std::move(columns);
  }
  if (routes.kinetic_bins) {
    Json bins{{"U", routes.kinetic_bins->U}};
    for (char const* key : {"T_exact", "T_exact_se", "T_equipartition", "T_equipartition_se"})
      bins[key] = Json::array();
    for (std::size_t k = 0; k < routes.kinetic_bins->U.size(); ++k) {
      bins["T_exact"].push_back(routes.kinetic_bins->T_exact[k].mean);
      bins["T_exact_se"].push_back(routes.kinetic_bins->T_exact[k].se);
      bins["T_equipartition"].push_back(routes.kinetic_bins->T_equipartition[k].mean);
      bins["T_equipartition_se"].push_back(routes.kinetic_bins->T_equipartition[k].se);
    }
    json["vacuum_bins"] = std::move(bins);
  }
  if (routes.wham) {
    Json bins{{"U", routes.wham->U}, {"S", Json::array()}, {"S_se", Json::array()}};
    for (auto const& S : routes.wham->S) {
      bins["S"].push_back(S.mean);
      bins["S_se"].push_back(S.se);
    }
    bins["U_reference"] = routes.wham->U_reference;
    json["wham"] = std::move(bins);
  }
  return json;
}

std::string entropy_text(cg::EntropyRoutes const& routes) {
  std::string text = fmt::format("at U = {:.5g}        C                   T\n", routes.U_mean);
  auto const line = [&](std::string const& name, cg::Estimate const& C, cg::Estimate const& T) {
    text += fmt::format("{:<20} {:<19} {}\n", name, with_error_text(C), with_error_text(T));
  };
  for (auto const& curve : routes.curves)
    line(curve.name, curve.C, curve.fit.estimate([&](auto const& c) { return c.T(routes.U_mean); }));
  if (routes.equipartition)
    line("equipartition", routes.equipartition->C(routes.U_mean), routes.equipartition->T(routes.U_mean));
  if (routes.C_from_variance)
    text += fmt::format("{:<20} {}\n", "beta^2 Var(U), melt", with_error_text(*routes.C_from_variance));
  return text;
}

} // namespace mesobridge::workflows
