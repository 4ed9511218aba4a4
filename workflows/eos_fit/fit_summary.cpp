#include "workflows/eos_fit/fit_summary.hpp"
#include "md/error.hpp"
#include "workflows/report/number_text.hpp"
#include "workflows/summary.hpp"
#include <algorithm>
#include <gsl/gsl_cdf.h>

namespace mesobridge::workflows {
namespace {

using fitting::EosFit;
using fitting::Quantity;

bool contains(std::vector<Eigen::Index> const& list, Eigen::Index i) {
  return std::ranges::find(list, i) != list.end();
}

Json parameter_json(EosFit const& fit, Eigen::Index i) {
  auto const& outcome = fit.outcome;
  auto const& parameter = outcome.parameters[static_cast<std::size_t>(i)];
  bool const free = contains(outcome.free, i);
  Json json{{"key", parameter.key},
            {"meaning", parameter.meaning},
            {"value", outcome.values[i]},
            {"value_se", outcome.se(i)},
            {"free", free}};
  if (!free)
    return json;
  json["lower"] = parameter.lower;
  json["upper"] = parameter.upper;
  json["at_bound"] = contains(outcome.at_bound, i);
  json["determined"] = outcome.determined(i);
  if (fit.bootstrap) {
    auto const column = std::ranges::find(outcome.free, i) - outcome.free.begin();
    json["bootstrap_se"] = fit.bootstrap->se(column);
    json["bootstrap_quantile_0.025"] = fit.bootstrap->quantile(column, 0.025);
    json["bootstrap_quantile_0.975"] = fit.bootstrap->quantile(column, 0.975);
  }
  return json;
}

Json correlation_json(EosFit const& fit) {
  Json json{{"parameters", Json::array()}, {"matrix", Json::array()}};
  auto const correlation = fit.outcome.correlation();
  for (Eigen::Index k = 0; k < correlation.rows(); ++k) {
    json["parameters"].push_back(fit.outcome.parameters[static_cast<std::size_t>(fit.outcome.free[k])].key);
    Json row = Json::array();
    for (Eigen::Index l = 0; l < correlation.cols(); ++l)
      row.push_back(correlation(k, l));
    json["matrix"].push_back(row);
  }
  return json;
}

std::string_view path_name(fitting::DataPath path) {
  constexpr std::string_view names[] = {"state", "hugoniot", "isentrope", "cj"};
  return names[static_cast<std::size_t>(path)];
}

Json observation_json(fitting::FittedObservation const& fitted) {
  Json json{{"origin", fitted.observation.origin},
            {"kind", path_name(fitted.observation.path)},
            {"model_rho_kg_m3", fitted.state.rho},
            {"model_T_K", fitted.state.T}};
  for (auto const& given : fitted.observation.given)
    json["given_" + std::string(symbol(given.quantity)) + si_suffix(given.quantity)] = given.value;
  for (auto const& datum : fitted.data) {
    auto const name = std::string(symbol(datum.quantity)), unit = si_suffix(datum.quantity);
    json[name + unit] = datum.value;
    json[name + unit + "_se"] = datum.se;
    json[name + "_fit" + unit] = datum.fit;
    json[name + "_fit" + unit + "_se"] = datum.fit_se;
    json[name + "_deviation"] = datum.deviation();
  }
  return json;
}

std::string bootstrap_text(EosFit const& fit, Eigen::Index i) {
  auto const& free = fit.outcome.free;
  if (!fit.bootstrap || !contains(free, i))
    return "";
  auto const column = std::ranges::find(free, i) - free.begin();
  return fmt::format("  bootstrap: se {:.2g}, 95 % within {:.5g} ... {:.5g}", fit.bootstrap->se(column),
                     fit.bootstrap->quantile(column, 0.025), fit.bootstrap->quantile(column, 0.975));
}

} // namespace

std::string si_suffix(Quantity quantity) {
  switch (quantity) {
  case Quantity::rho:
    return "_kg_m3";
  case Quantity::T:
    return "_K";
  case Quantity::e:
    return "_J_kg";
  case Quantity::P:
    return "_Pa";
  case Quantity::c_v:
    return "_J_kg_K";
  case Quantity::sound_speed:
  case Quantity::v_P:
  case Quantity::v_S:
    return "_m_s";
  }
  throw std::logic_error("a quantity without unit");
}

std::optional<double> chi_2_probability(fitting::FitOutcome const& outcome) {
  if (outcome.degrees_of_freedom() == 0)
    return std::nullopt;
  return gsl_cdf_chisq_Q(outcome.chi_2(), outcome.degrees_of_freedom());
}

std::optional<std::string> bad_fit(fitting::FitOutcome const& outcome) {
  constexpr double least = 1e-3;
  auto const probability = chi_2_probability(outcome);
  if (!probability || *probability >= least)
    return std::nullopt;
  return fmt::format(
      "bad fit: chi^2 = {:.4g} for {} degrees of freedom (probability {:.2g}): the model does not agree "
      "with the data within their errors; {} of {} searches ended here",
      outcome.chi_2(), outcome.degrees_of_freedom(), *probability, outcome.starts_at_best, outcome.starts);
}

std::optional<FittedRest> fitted_rest(EosFit const& fit) {
  std::optional<std::pair<double, double>> place;
  for (auto const& fitted : fit.observations)
    if (auto const& start = fitted.observation.start; start && start->T)
      place = {start->rho, *start->T};
  if (!place)
    for (auto const& fitted : fit.observations)
      if (fitted.observation.path == fitting::DataPath::state &&
          (!place || std::pair(fitted.state.rho, fitted.state.T) < *place))
        place = {fitted.state.rho, fitted.state.T};
  if (!place)
    return std::nullopt;
  fitting::Observation const rest{.given = {{Quantity::rho, place->first}, {Quantity::T, place->second}}};
  try {
    return FittedRest{.rho = place->first,
                      .T = place->second,
                      .P = fit.estimate(rest, Quantity::P),
                      .e = fit.estimate(rest, Quantity::e),
                      .sound_speed = fit.estimate(rest, Quantity::sound_speed)};
  } catch (PhysicsError const&) {
    return std::nullopt; // mechanically unstable there
  }
}

std::optional<FittedDetonation> fitted_detonation(EosFit const& fit) {
  std::optional<fitting::StartState> explosive;
  if (auto const* const jwl = std::get_if<fitting::Jwl>(&fit.eos))
    explosive = {.rho = jwl->parameters().rho_0, .e = jwl->parameters().E_0 + fit.energy_offset, .P = 0.0};
  for (auto const& fitted : fit.observations)
    if (fitted.observation.path == fitting::DataPath::cj)
      explosive = fitted.observation.start;
  if (!explosive)
    return std::nullopt;
  fitting::Observation const cj{.path = fitting::DataPath::cj, .start = explosive};
  return FittedDetonation{.explosive = *explosive,
                          .D = fit.estimate(cj, Quantity::v_S),
                          .rho = fit.estimate(cj, Quantity::rho),
                          .P = fit.estimate(cj, Quantity::P),
                          .T = fit.estimate(cj, Quantity::T)};
}

Json eos_fit_json(EosFit const& fit) {
  auto const& outcome = fit.outcome;
  Json json{{"kind", fit.family.name},
            {"chi_2", outcome.chi_2()},
            {"degrees_of_freedom", outcome.degrees_of_freedom()},
            {"converged", outcome.converged},
            {"constrained", outcome.constrained},
            {"evaluations", outcome.evaluations},
            {"starts", outcome.starts},
            {"starts_at_best", outcome.starts_at_best}};
  if (auto const probability = chi_2_probability(outcome))
    json["chi_2_probability"] = *probability;
  json["bad_fit"] = bad_fit(outcome).has_value();
  if (auto const rest = fitted_rest(fit)) {
    Json state{{"rho_kg_m3", rest->rho}, {"T_K", rest->T}};
    put(state, "P_Pa", rest->P);
    put(state, "e_J_kg", rest->e);
    put(state, "sound_speed_m_s", rest->sound_speed);
    json["at_rest"] = state;
  }
  for (Eigen::Index i = 0; i < outcome.values.size(); ++i)
    json["parameters"][outcome.parameters[static_cast<std::size_t>(i)].name] = parameter_json(fit, i);
  json["correlation"] = correlation_json(fit);
  json["undetermined"] = outcome.undetermined();
  if (fit.bootstrap)
    json["bootstrap"] = {{"refits", fit.bootstrap->values.rows()}, {"failed", fit.bootstrap->failed}};
  if (auto const cj = fitted_detonation(fit)) {
    Json state{{"rho0_kg_m3", cj->explosive.rho},
               {"e0_J_kg", cj->explosive.e.value()},
               {"P0_Pa", cj->explosive.P.value()}};
    put(state, "D_m_s", cj->D);
    put(state, "rho_kg_m3", cj->rho);
    put(state, "P_Pa", cj->P);
    put(state, "T_K", cj->T);
    json["chapman_jouguet"] = state;
  }
  json["required_physical"] = {{"rho_min_kg_m3", fit.region.rho_min},
                               {"rho_max_kg_m3", fit.region.rho_max},
                               {"T_min_K", fit.region.T_min},
                               {"T_max_K", fit.region.T_max},
                               {"least_sound_speed_squared_m2_s2", fit.c_2_min}};
  json["observations"] = Json::array();
  for (auto const& observation : fit.observations)
    json["observations"].push_back(observation_json(observation));
  return json;
}

std::string eos_fit_text(EosFit const& fit) {
  auto const& outcome = fit.outcome;
  std::string text;
  for (Eigen::Index i = 0; i < outcome.values.size(); ++i) {
    auto const& parameter = outcome.parameters[static_cast<std::size_t>(i)];
    std::string const remark = !contains(outcome.free, i)      ? "fixed"
                               : contains(outcome.at_bound, i) ? "on its bound"
                               : !outcome.determined(i)        ? "not determined"
                                                               : "";
    text += fmt::format("{:<14} {:<28} {:<9} {}{}\n", parameter.name,
                        with_error_text({outcome.values[i], outcome.se(i), 0}), parameter.unit, remark,
                        bootstrap_text(fit, i));
  }
  text +=
      fmt::format("chi^2 {:.4g} for {} degrees of freedom", outcome.chi_2(), outcome.degrees_of_freedom());
  if (auto const probability = chi_2_probability(outcome))
    text += fmt::format(" (probability {:.2g})", *probability);
  text += fmt::format("; {} of {} searches ended here\n", outcome.starts_at_best, outcome.starts);
  if (auto const complaint = bad_fit(outcome))
    text += "BAD FIT: model and data do not agree within the stated errors.\n";
  if (auto const rest = fitted_rest(fit))
    text += fmt::format(
        "At rho {:.6g} kg/m^3, T {:.6g} K the model has P {} Pa, e {} J/kg, sound speed {} m/s\n", rest->rho,
        rest->T, with_error_text(rest->P), with_error_text(rest->e), with_error_text(rest->sound_speed));
  if (auto const cj = fitted_detonation(fit))
    text += fmt::format(
        "Chapman-Jouguet state of the model, from rho {:.6g} kg/m^3, e {:.6g} J/kg, P {:.6g} Pa: D {} "
        "m/s, rho {} kg/m^3, P {} Pa, T {} K\n",
        cj->explosive.rho, *cj->explosive.e, *cj->explosive.P, with_error_text(cj->D),
        with_error_text(cj->rho), with_error_text(cj->P), with_error_text(cj->T));
  for (auto const& sentence : outcome.undetermined())
    text += sentence + "\n";
  if (outcome.constrained)
    text += "The condition (dP/drho)_s > 0 holds the fit off a better one: its errors are one-sided.\n";
  if (!outcome.converged)
    text += "The search stopped before the fit was at its best: bounds or constraints hold it, or the data "
            "determine too little.\n";
  return text;
}

} // namespace mesobridge::workflows
