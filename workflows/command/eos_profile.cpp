#include "fitting/shock_profile.hpp"
#include "md/error.hpp"
#include "workflows/command/options.hpp"
#include "workflows/eos/curve_output.hpp"
#include "workflows/eos/named_fluid.hpp"
#include <CLI/CLI.hpp>

namespace mesobridge::workflows {

namespace {

struct EosProfileOptions {
  EosOptions eos;
  InitialState initial;
  double v_P = 0;
  fitting::Transport transport{.shear_viscosity = 0};
};

Columns profile_columns(fitting::ShockProfile const& profile) {
  Columns columns{{"x", "_m", "m", {}}, {"v", "_m_s", "m/s", {}}};
  std::vector<fitting::EosState> states;
  for (auto const& point : profile.points) {
    columns[0].values.push_back(point.x);
    columns[1].values.push_back(point.v);
    states.push_back(point.state);
  }
  for (auto& of_state : state_columns(states))
    columns.push_back(std::move(of_state));
  return columns;
}

/// Velocity and temperature, in two panels.
Plot profile_plot(NamedFluid const& model, fitting::ShockProfile const& profile) {
  double const length = model.reduced ? 1 : 1e-9; // drawn in nm
  Series velocity{.style = SeriesStyle::lines}, temperature = velocity;
  for (auto const& point : profile.points) {
    velocity.x.push_back(point.x / length);
    velocity.y.push_back(point.v);
    temperature.x.push_back(point.x / length);
    temperature.y.push_back(point.state.T);
  }
  bool const r = model.reduced;
  return {
      .name = "profile",
      .title = plain("Shock front in " + model.name),
      .x = {.label = r ? "x*" : "x [nm]"},
      .panels = {Panel{.series = {velocity}, .y = {.label = r ? "v*" : "v [m/s]"}, .legend = Legend::none},
                 Panel{.series = {temperature}, .y = {.label = r ? "T*" : "T [K]"}, .legend = Legend::none}}};
}

Result profile(EosProfileOptions const& options, Context const& context) {
  if (context.options.output)
    curve_file(*context.options.output);
  auto const model = load_fluid(options.eos);
  fitting::Hugoniot const hugoniot(model.fluid, options.initial.of(model, context));
  auto const profile =
      fitting::shock_profile(model.fluid, hugoniot.from_piston(options.v_P), options.transport);
  Columns head{{"thickness", "_m", "m", {profile.thickness}}};
  for (auto& of_shock : shock_columns({profile.shock}))
    head.push_back(std::move(of_shock));
  auto const columns = profile_columns(profile);
  Result result;
  result.json["model"] = options.eos.model;
  tell_first_row(result, head, model.reduced);
  put_curve(context, result, columns, model.reduced, [&] { return profile_plot(model, profile); });
  return result;
}

void declare(CLI::App& app, EosProfileOptions& options) {
  options.eos.declare(app);
  options.initial.declare(app);
  app.add_option("--vp", options.v_P, "Velocity of the piston (SI: m/s)")->required();
  app.add_option("--eta", options.transport.shear_viscosity, "Shear viscosity (SI: Pa s)")->required();
  app.add_option("--zeta", options.transport.bulk_viscosity, "Bulk viscosity (SI: Pa s)");
  app.add_option("--kappa", options.transport.conductivity, "Heat conductivity (SI: W/(m K))");
}

} // namespace

extern Declaration const eos_profile_command = with_options<EosProfileOptions, declare, profile>;

} // namespace mesobridge::workflows
