#include "fitting/riemann.hpp"
#include "fitting/state_at_pressure.hpp"
#include "md/error.hpp"
#include "workflows/command/options.hpp"
#include "workflows/eos/curve_output.hpp"
#include "workflows/eos/named_fluid.hpp"
#include "workflows/interrupt.hpp"
#include <CLI/CLI.hpp>

namespace mesobridge::workflows {

namespace {

struct Side {
  EosOptions model;
  std::string name; ///< "left"
  double rho = 0, u = 0;
  std::optional<double> T, P;

  void declare(CLI::App& app, std::string const& side) {
    name = side;
    app.add_option("--" + name, model.model, "Model of the " + name + " half space")
        ->required()
        ->type_name("NAME|FILE");
    app.add_option("--gamma-" + name, model.gamma, "Of ideal-gas: the ratio of its heat capacities, > 1");
    app.add_option("--rho-" + name, rho, "Its density (SI: kg/m^3)")->required();
    auto* const temperature = app.add_option("--T-" + name, T, "Its temperature (SI: K)");
    app.add_option("--P-" + name, P, "Its pressure (SI: Pa), in place of the temperature")
        ->excludes(temperature);
    app.add_option("--u-" + name, u, "Its velocity to the right (SI: m/s)");
  }
  fitting::EosState state(NamedFluid const& fluid) const {
    require_positive_number("--rho-" + name, rho);
    require(std::isfinite(u), "--u-" + name, u, "must be finite");
    if (P) {
      require(std::isfinite(*P), "--P-" + name, *P, "must be finite");
      try {
        return fitting::state_at_pressure(fluid.fluid, rho, *P);
      } catch (PhysicsError const& error) {
        throw PhysicsError(fmt::format("--P-{}: {}", name, error.what()));
      }
    }
    require(T.has_value(), "--T-" + name, "nothing", "or --P-" + name + " must be given");
    require_positive_number("--T-" + name, *T);
    return fluid.fluid.at_temperature(rho, *T);
  }
};

struct EosRiemannOptions {
  Side left, right;
  int points = 400;
};

/// The flow over x/t, a little beyond the outermost waves.
Columns flow_columns(fitting::RiemannSolution const& solution, int points) {
  double const left = solution.left_wave().head, right = solution.right_wave().head;
  double const margin = 0.1 * (right - left);
  Columns columns{{"x_over_t", "_m_s", "m/s", {}}, {"u", "_m_s", "m/s", {}}};
  std::vector<fitting::EosState> states;
  for (int i = 0; i <= points; ++i) {
    throw_if_interrupted();
    double const xi = left - margin + (right - left + 2 * margin) * i / points;
    auto const flow = solution.at(xi);
    columns[0].values.push_back(xi);
    columns[1].values.push_back(flow.u);
    states.push_back(flow.state);
  }
  for (auto& of_state : state_columns(states))
    columns.push_back(std::move(of_state));
  return columns;
}

Series series_of(Columns const& columns, std::size_t column, double unit) {
  Series series{.style = SeriesStyle::lines};
  for (std::size_t i = 0; i < columns[0].values.size(); ++i) {
    series.x.push_back(*columns[0].values[i]);
    series.y.push_back(*columns[column].values[i] / unit);
  }
  return series;
}

Plot riemann_plot(Columns const& columns, bool reduced) {
  constexpr std::size_t u = 1, rho = 2, P = 4;
  auto const panel = [&](std::size_t column, double unit, std::string label) {
    return Panel{.series = {series_of(columns, column, unit)},
                 .y = {.label = std::move(label)},
                 .legend = Legend::none};
  };
  return {.name = "riemann",
          .title = "Riemann problem",
          .x = {.label = reduced ? "x/t" : "x/t [m/s]"},
          .panels = {panel(rho, 1, density_label(reduced)), panel(u, 1, reduced ? "u*" : "u [m/s]"),
                     panel(P, pressure_unit(reduced), pressure_label(reduced))}};
}

Json wave_json(fitting::RiemannSolution::Speeds const& speeds, bool shock, bool reduced) {
  require_numbers({{"head", "", "", {speeds.head}}, {"tail", "", "", {speeds.tail}}});
  std::string const unit = reduced ? "" : "_m_s";
  return {
      {"kind", shock ? "shock" : "rarefaction"}, {"head" + unit, speeds.head}, {"tail" + unit, speeds.tail}};
}

Result riemann(EosRiemannOptions const& options, Context const& context) {
  if (context.options.output)
    curve_file(*context.options.output);
  require(options.points >= 2 && options.points <= 100000, "--points", options.points,
          "must lie between 2 and 100000");
  auto const left = load_fluid(options.left.model), right = load_fluid(options.right.model);
  auto const at_left = options.left.state(left), at_right = options.right.state(right);
  require_same_units(left, right);
  bool const reduced = left.reduced;
  fitting::RiemannSolution const solution({left.fluid, at_left, options.left.u},
                                          {right.fluid, at_right, options.right.u});
  warn_outside_data(left, at_left.rho, at_left.T, context);
  warn_outside_data(right, at_right.rho, at_right.T, context);
  Columns const head{{"P", "_Pa", "Pa", {solution.P()}}, {"u", "_m_s", "m/s", {solution.u()}}};
  Result result;
  tell_first_row(result, head, reduced);
  result.json["left_wave"] = wave_json(solution.left_wave(), solution.left_shock(), reduced);
  result.json["right_wave"] = wave_json(solution.right_wave(), solution.right_shock(), reduced);
  put_first_row(result.json["left_of_contact"], state_columns({solution.left_of_contact()}), reduced);
  put_first_row(result.json["right_of_contact"], state_columns({solution.right_of_contact()}), reduced);
  for (auto const* name : {"left_wave", "right_wave"})
    result.text += fmt::format("{:<12} {}\n", name, result.json[name].dump());
  auto const columns = flow_columns(solution, options.points);
  put_curve(context, result, columns, reduced, [&] { return riemann_plot(columns, reduced); });
  return result;
}

void declare(CLI::App& app, EosRiemannOptions& options) {
  options.left.declare(app, "left");
  options.right.declare(app, "right");
  app.add_option("--points", options.points, "Points of the curve");
}

} // namespace

extern Declaration const eos_riemann_command = with_options<EosRiemannOptions, declare, riemann>;

} // namespace mesobridge::workflows
