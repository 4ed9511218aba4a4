#include "md/error.hpp"
#include "workflows/command/options.hpp"
#include "workflows/eos/curve_output.hpp"
#include "workflows/eos/named_fluid.hpp"
#include "workflows/eos/shock_options.hpp"
#include <CLI/CLI.hpp>

namespace mesobridge::workflows {

namespace {

struct EosHugoniotOptions {
  EosOptions eos;
  InitialState initial;
  ShockOptions shock;
};

Plot hugoniot_plot(NamedFluid const& model, fitting::Hugoniot const& hugoniot,
                   std::vector<fitting::Shock> const& curve, std::optional<fitting::Shock> const& asked) {
  auto states = states_behind(curve);
  states.insert(states.begin(), hugoniot.ahead());
  Plot plot{.name = "hugoniot",
            .title = plain("Hugoniot curve of " + model.name),
            .x = {.label = density_label(model.reduced)},
            .panels = {Panel{}}};
  auto& panel = plot.panels[0];
  panel.y.label = pressure_label(model.reduced);
  panel.series.push_back(pressure_series("Hugoniot", states, model.reduced));
  panel.series.push_back({.label = "at rest",
                          .x = {hugoniot.ahead().rho},
                          .y = {hugoniot.ahead().P / pressure_unit(model.reduced)}});
  if (asked)
    panel.series.push_back({.label = "behind the shock",
                            .x = {asked->behind.rho},
                            .y = {asked->behind.P / pressure_unit(model.reduced)}});
  return plot;
}

Result hugoniot(EosHugoniotOptions const& options, Context const& context) {
  if (context.options.output)
    curve_file(*context.options.output);
  auto const model = load_fluid(options.eos);
  fitting::Hugoniot const hugoniot(model.fluid, options.initial.of(model, context));
  auto const asked = options.shock.shock(hugoniot);
  Result result;
  result.json["model"] = options.eos.model;
  if (asked) {
    tell_first_row(result, shock_columns({*asked}), model.reduced);
  }
  put_first_row(result.json["ahead"], state_columns({hugoniot.ahead()}), model.reduced);
  if (!options.shock.P_max && !context.options.output)
    return result;
  auto const curve = options.shock.curve(hugoniot, asked);
  auto const columns = shock_columns(curve);
  put_curve(context, result, columns, model.reduced,
            [&] { return hugoniot_plot(model, hugoniot, curve, asked); });
  if (!asked && !context.options.output)
    result.text = csv_text(columns, model.reduced);
  return result;
}

void declare(CLI::App& app, EosHugoniotOptions& options) {
  options.eos.declare(app);
  options.initial.declare(app);
  options.shock.declare(app);
}

} // namespace

extern Declaration const eos_hugoniot_command = with_options<EosHugoniotOptions, declare, hugoniot>;

} // namespace mesobridge::workflows
