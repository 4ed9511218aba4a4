#include "workflows/eos/detonation_view.hpp"
#include "fitting/isentrope.hpp"
#include "workflows/eos/curve_output.hpp"
#include "workflows/eos_fit/row_numbers.hpp"
#include "workflows/text_file.hpp"
#include <algorithm>

namespace mesobridge::workflows {
namespace {

using fitting::EosState;

/// P over the volume relative to that at rest.
Series over_volume(std::string const& label, std::vector<EosState> const& states, double rho_0,
                   bool reduced) {
  auto series = pressure_series(label, states, reduced);
  for (auto& x : series.x)
    x = rho_0 / x;
  return series;
}

/// From the Chapman-Jouguet state to the density, or as far as the model goes.
std::vector<EosState> release(DetonationView const& view, fitting::Shock const& cj, double rho_last,
                              int steps) {
  fitting::Isentrope const isentrope(view.product, cj.behind);
  std::vector<EosState> states;
  try {
    for (int i = 0; i <= steps; ++i)
      states.push_back(isentrope.at_density(cj.behind.rho + (rho_last - cj.behind.rho) * i / steps));
  } catch (PhysicsError const&) { // the products end before
  }
  return states;
}

std::optional<EosState> von_neumann_state(DetonationView const& view, fitting::Shock const& cj) {
  try {
    return fitting::Hugoniot(view.reactant, cj.ahead).from_speed(cj.v_S).behind;
  } catch (PhysicsError const&) {
    return std::nullopt;
  }
}

Series slice_series(SliceStates const& slices, double rho_0, bool reduced) {
  Series series{.label = plain(slices.label), .style = SeriesStyle::points};
  for (double const rho : slices.rho)
    series.x.push_back(rho_0 / rho);
  for (double const P : slices.P)
    series.y.push_back(P / pressure_unit(reduced));
  for (double const error : slices.P_error)
    series.y_error.push_back(error / pressure_unit(reduced));
  return series;
}

double thinnest(double rho_0, std::vector<SliceStates> const& slices) {
  for (auto const& of : slices)
    for (double const rho : of.rho)
      rho_0 = std::min(rho_0, rho);
  return rho_0;
}

} // namespace

SliceStates read_slices(std::filesystem::path const& file) {
  auto const table = parse_csv_table(read_text_file(file), file.string());
  SliceStates slices{.label = file.stem().string(), .rho = {}, .P = {}};
  for (auto const& row : table.rows) {
    auto const numbers = numbers_of(row, table.columns);
    auto const rho = numbers.value(fitting::Quantity::rho), P = numbers.value(fitting::Quantity::P);
    if (!rho || !P)
      throw InputError(fmt::format(
          "{}: a slice needs a density and a pressure (columns such as rho_kg_m3 and P_GPa)", row.origin));
    require(*rho > 0, row.origin + ": density", *rho, "must be > 0");
    slices.rho.push_back(*rho);
    slices.P.push_back(*P);
    if (auto const error = numbers.error(fitting::Quantity::P))
      slices.P_error.push_back(*error);
  }
  if (slices.P_error.size() != slices.P.size())
    slices.P_error.clear(); // not every slice has one
  return slices;
}

DetonationView view_of(fitting::ReactiveFluid const& fluid, std::string reactant_name,
                       std::string product_name, bool reduced) {
  return {.reactant_name = std::move(reactant_name),
          .product_name = std::move(product_name),
          .reactant = fitting::Fluid(fluid.mixture.reactant().eos()),
          .product = fitting::Fluid(fluid.mixture.product().eos()),
          .at_rest = fluid.at_rest,
          .crussard = fluid.crussard(),
          .reduced = reduced};
}

Plot detonation_plot(DetonationView const& view, std::vector<fitting::Shock> const& curve,
                     std::vector<SliceStates> const& slices) {
  bool const reduced = view.reduced;
  auto const cj = view.crussard.chapman_jouguet();
  auto const spike = von_neumann_state(view, cj);
  double const rho_0 = cj.ahead.rho, unit = pressure_unit(reduced);
  int const points = static_cast<int>(curve.size());
  auto products = states_behind(curve);
  products.insert(products.begin(), view.crussard.constant_volume_state());
  auto const P_last = products.back().P;
  auto reactant = states_behind(fitting::Hugoniot(view.reactant, view.at_rest).curve(P_last, points));
  reactant.insert(reactant.begin(), view.at_rest);
  auto const& line_end = spike ? *spike : cj.behind;
  Series special{.label = spike ? "Chapman-Jouguet and von Neumann states" : "Chapman-Jouguet",
                 .x = {rho_0 / cj.behind.rho},
                 .y = {cj.behind.P / unit}};
  if (spike)
    special.x.push_back(rho_0 / spike->rho), special.y.push_back(spike->P / unit);
  Plot plot{.name = "crussard",
            .title = plain(fmt::format("Detonation of {}: D = {:.5g}{}", view.reactant_name, cj.v_S,
                                       reduced ? "" : " m/s")),
            .x = {.label = "rho_0/rho"},
            .panels = {Panel{}}};
  auto& panel = plot.panels[0];
  panel.y.label = pressure_label(reduced);
  panel.series = {
      over_volume("Crussard, " + view.product_name, products, rho_0, reduced),
      over_volume("Hugoniot, " + view.reactant_name, reactant, rho_0, reduced),
      Series{.label = "Rayleigh line",
             .x = {1, rho_0 / line_end.rho},
             .y = {cj.ahead.P / unit, line_end.P / unit},
             .style = SeriesStyle::dashes},
      over_volume("isentrope", release(view, cj, thinnest(rho_0, slices), points), rho_0, reduced),
      special,
  };
  for (auto const& of : slices)
    panel.series.push_back(slice_series(of, rho_0, reduced));
  return plot;
}

Plot detonation_plot(DetonationView const& view, double P_last, int points,
                     std::vector<SliceStates> const& slices) {
  return detonation_plot(view, view.crussard.curve(P_last, points), slices);
}

} // namespace mesobridge::workflows
