#include "workflows/eos_fit/fit_report.hpp"
#include "workflows/eos_fit/fit_figures.hpp"
#include "workflows/eos_fit/fit_summary.hpp"
#include "workflows/report/number_text.hpp"
#include <algorithm>

namespace mesobridge::workflows {
namespace {

using fitting::Datum;
using fitting::EosFit;

/// "tin.csv:12" of a path and line.
std::string without_folder(std::string const& origin) {
  auto const slash = origin.substr(0, origin.find(':')).rfind('/');
  return slash == origin.npos ? origin : origin.substr(slash + 1);
}

std::size_t number_of_data(EosFit const& fit) {
  return static_cast<std::size_t>(fit.outcome.residuals.size());
}

std::vector<VerdictLine> verdicts(EosFit const& fit) {
  auto const& outcome = fit.outcome;
  auto const line = [](std::string what, bool passed, std::string found, std::string expected) {
    return VerdictLine{std::move(what), std::move(found), std::move(expected),
                       passed ? Verdict::passed : Verdict::failed};
  };
  std::vector<VerdictLine> lines;
  lines.push_back(line("The search came to its end", outcome.converged,
                       outcome.converged ? "no step lowers chi² by more than 1e-6" : "a better fit may exist",
                       "a minimum"));
  if (auto const probability = chi_2_probability(outcome))
    lines.push_back(line("Model and data agree within the stated errors", *probability > 0.001,
                         fmt::format("chi² = {:.4g} for {} degrees of freedom, probability {:.2g}",
                                     outcome.chi_2(), outcome.degrees_of_freedom(), *probability),
                         "probability > 0.001"));
  lines.push_back(line(
      "Independent searches end at the same fit", outcome.starts_at_best * 2 >= outcome.starts,
      fmt::format("{} of {} at the best chi²", outcome.starts_at_best, outcome.starts), "at least half"));
  lines.push_back(line("The data determine all free parameters", outcome.undetermined().empty(),
                       fmt::format("{} undetermined combinations", outcome.undetermined().size()), "none"));
  lines.push_back(line("(dP/drho)_s > 0 over the region of the data", fit.c_2_min > 0 && !outcome.constrained,
                       fmt::format("least c² = {:.4g} m²/s²{}", fit.c_2_min,
                                   outcome.constrained ? ", held by the constraint" : ""),
                       "> 0, without a constraint that bites"));
  return lines;
}

Table parameter_table(EosFit const& fit) {
  auto const& outcome = fit.outcome;
  Table table{.header = {"parameter", "value", "unit", "bounds", "state"},
              .caption = "Standard errors are those of the linearised fit at its best."};
  if (fit.bootstrap)
    table.header.insert(table.header.begin() + 2, {"bootstrap se", "bootstrap 95 %"});
  for (Eigen::Index i = 0; i < outcome.values.size(); ++i) {
    auto const& parameter = outcome.parameters[static_cast<std::size_t>(i)];
    auto const at = std::ranges::find(outcome.free, i);
    bool const free = at != outcome.free.end();
    auto const k = at - outcome.free.begin();
    bool const held = std::ranges::find(outcome.at_bound, i) != outcome.at_bound.end();
    std::vector<std::string> row{parameter.name, with_error_text({outcome.values[i], outcome.se(i), 0})};
    if (fit.bootstrap)
      row.insert(row.end(), {free ? number_text(fit.bootstrap->se(k), 3) : "",
                             free ? fmt::format("{} … {}", number_text(fit.bootstrap->quantile(k, 0.025)),
                                                number_text(fit.bootstrap->quantile(k, 0.975)))
                                  : ""});
    row.insert(
        row.end(),
        {parameter.unit,
         free ? fmt::format("{} … {}", number_text(parameter.lower), number_text(parameter.upper)) : "",
         !free                    ? "fixed"
         : held                   ? "on its bound"
         : !outcome.determined(i) ? "not determined"
                                  : "fitted"});
    table.rows.push_back(std::move(row));
  }
  return table;
}

Table correlation_table(EosFit const& fit) {
  Table table{.header = {""}, .caption = "Correlation of the errors."};
  auto const correlation = fit.outcome.correlation();
  for (auto const i : fit.outcome.free)
    table.header.push_back(fit.outcome.parameters[static_cast<std::size_t>(i)].name);
  for (Eigen::Index k = 0; k < correlation.rows(); ++k) {
    std::vector<std::string> row{table.header[static_cast<std::size_t>(k + 1)]};
    for (Eigen::Index l = 0; l < correlation.cols(); ++l)
      row.push_back(fmt::format("{:+.3f}", correlation(k, l)));
    table.rows.push_back(std::move(row));
  }
  return table;
}

Table data_table(EosFit const& fit) {
  Table table{.header = {"from", "quantity", "data", "fit", "deviation [se]"},
              .caption = "Every datum in SI units beside the fit; ± are standard errors."};
  for (auto const& fitted : fit.observations)
    for (auto const& datum : fitted.data)
      table.rows.push_back({without_folder(fitted.observation.origin), std::string(symbol(datum.quantity)),
                            with_error_text({datum.value, datum.se, 0}),
                            with_error_text({datum.fit, datum.fit_se, 0}),
                            fmt::format("{:+.2f}", datum.deviation())});
  return table;
}

/// A datum as the file has it, in SI units.
std::string stated(Datum const& datum) {
  auto const name = symbol(datum.quantity);
  return datum.se > 0
             ? fmt::format("{} = {} ± {}", name, number_text(datum.value, 6), number_text(datum.se, 2))
             : fmt::format("{} = {}", name, number_text(datum.value, 6));
}

std::string listed(std::vector<Datum> const& data) {
  std::string text;
  for (auto const& datum : data)
    text += (text.empty() ? "" : ", ") + stated(datum);
  return text;
}

std::string start_text(std::optional<fitting::StartState> const& start) {
  if (!start)
    return "";
  std::string text = fmt::format("rho0 = {}", number_text(start->rho, 6));
  for (auto const& [name, value] :
       {std::pair{"T0", start->T}, std::pair{"e0", start->e}, std::pair{"P0", start->P}})
    if (value)
      text += fmt::format(", {} = {}", name, number_text(*value, 6));
  return text;
}

Table raw_data_table(EosFit const& fit) {
  constexpr std::string_view kinds[] = {"state", "hugoniot", "isentrope", "cj"};
  Table table{.header = {"from", "kind", "start", "given", "measured"},
              .caption = "The data as they were read, in SI units; ± are their own standard errors."};
  for (auto const& [observation, state, data] : fit.observations)
    table.rows.push_back(
        {without_folder(observation.origin), std::string(kinds[static_cast<std::size_t>(observation.path)]),
         start_text(observation.start), listed(observation.given), listed(observation.measured)});
  return table;
}

Section parameter_section(EosFit const& fit) {
  Section section{"Parameters", {parameter_table(fit), correlation_table(fit)}};
  for (auto const& sentence : fit.outcome.undetermined())
    section.content.emplace_back(Paragraph{sentence});
  if (auto const rest = fitted_rest(fit))
    section.content.emplace_back(
        Paragraph{fmt::format("At rest, at {:.6g} kg/m³ and {:.6g} K, the model has P = {} Pa, e = {} J/kg "
                              "(on the data's scale) and the "
                              "sound speed {} m/s.",
                              rest->rho, rest->T, with_error_text(rest->P), with_error_text(rest->e),
                              with_error_text(rest->sound_speed))});
  if (auto const cj = fitted_detonation(fit))
    section.content.emplace_back(
        Paragraph{fmt::format("Chapman-Jouguet state of the fitted model from an explosive of {:.6g} kg/m³, "
                              "{:.6g} J/kg and {:.6g} Pa: D = "
                              "{} m/s, density {} kg/m³, P = {} Pa, T = {} K.",
                              cj->explosive.rho, *cj->explosive.e, *cj->explosive.P, with_error_text(cj->D),
                              with_error_text(cj->rho), with_error_text(cj->P), with_error_text(cj->T))});
  return section;
}

Section data_section(EosFit const& fit, std::vector<std::string> const& notes) {
  Section section{"Data and fit", {}};
  for (auto const& note : notes)
    section.content.emplace_back(Paragraph{note});
  for (auto const& plot : eos_fit_figures(fit))
    section.content.emplace_back(
        Figure{{draw_svg(plot)},
               "Points: data with their standard errors. Line and band: the fit and two standard errors "
               "of it. Below: deviations in standard errors."});
  section.content.emplace_back(data_table(fit));
  section.content.emplace_back(raw_data_table(fit));
  return section;
}

} // namespace

std::string eos_fit_report(EosFit const& fit, std::vector<std::string> const& notes,
                           Provenance const& provenance) {
  Report const report{
      .title = fmt::format("Fit of the equation of state {}", fit.family.name),
      .lead = fmt::format(
          "{} parameters fitted to {} data of {} observations: chi² = {:.4g} for {} degrees of "
          "freedom. The model had to be stable for rho = {:g} … {:g} kg/m³{}, and at all states of "
          "shocks.",
          fit.outcome.free.size(), number_of_data(fit), fit.observations.size(), fit.outcome.chi_2(),
          fit.outcome.degrees_of_freedom(), fit.region.rho_min, fit.region.rho_max,
          fit.region.T_max > 0 ? fmt::format(", T = {:g} … {:g} K", fit.region.T_min, fit.region.T_max) : ""),
      .verdicts = verdicts(fit),
      .sections = {parameter_section(fit), data_section(fit, notes)},
      .provenance = provenance};
  return report.html();
}

} // namespace mesobridge::workflows
