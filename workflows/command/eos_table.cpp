#include "md/error.hpp"
#include "workflows/command/options.hpp"
#include "workflows/eos/columns.hpp"
#include "workflows/eos/named_fluid.hpp"
#include "workflows/interrupt.hpp"
#include "workflows/provenance.hpp"
#include "workflows/text_file.hpp"
#include <CLI/CLI.hpp>

namespace mesobridge::workflows {

namespace {

struct Range {
  double min = 0, max = 0;
  int points = 0;

  void require_valid(std::string const& name) const {
    require_positive_number("--" + name + "-min", min);
    require(max > min && std::isfinite(max), "--" + name + "-max", max, "must exceed --" + name + "-min");
    require(points >= 2 && points <= 10000, "--" + name + "-points", points, "must lie between 2 and 10000");
  }
  double at(int i) const { return i + 1 == points ? max : min + (max - min) * i / (points - 1); }
};

struct EosTableOptions {
  EosOptions eos;
  Range rho{.points = 50}, T{.points = 50};
};

/// Density runs slowest. The square of the sound speed is there for every state, its root not.
Columns table_columns(NamedFluid const& model, EosTableOptions const& options) {
  std::vector<fitting::EosState> states;
  Column square{"sound_speed_squared", "_m2_s2", "m^2/s^2", {}};
  for (int i = 0; i < options.rho.points; ++i)
    for (int j = 0; j < options.T.points; ++j) {
      throw_if_interrupted();
      states.push_back(model.fluid.at_temperature(options.rho.at(i), options.T.at(j)));
      square.values.push_back(states.back().sound_speed_squared);
    }
  auto columns = state_columns(states);
  columns.push_back(std::move(square));
  return columns;
}

/// Every quantity that all states have as a dataset [density][temperature], its unit as an attribute.
void write_hdf5(Columns const& columns, NamedFluid const& model, EosTableOptions const& options,
                Context const& context) {
  Store store(*context.options.output, Store::Mode::create);
  std::vector<double> rho, T;
  for (int i = 0; i < options.rho.points; ++i)
    rho.push_back(options.rho.at(i));
  for (int j = 0; j < options.T.points; ++j)
    T.push_back(options.T.at(j));
  store.write(model.reduced ? "rho" : "rho_kg_m3", rho);
  store.write(model.reduced ? "T" : "T_K", T);
  for (auto const& c : columns) {
    if (c.key == "rho" || c.key == "T" || c.key == "sound_speed")
      continue;
    std::vector<double> values;
    for (auto const& value : c.values)
      values.push_back(*value);
    store.write(c.name(model.reduced), values, {rho.size(), T.size()});
    store.set_attribute(c.name(model.reduced), "unit", model.reduced ? "reduced" : c.unit);
  }
  store.write("model", model.name);
  bool const from_file = std::filesystem::is_regular_file(model.name);
  write_provenance(store, {.command = context.command_line(),
                           .scene = "",
                           .inputs = from_file ? std::vector<InputFile>{InputFile(model.name)}
                                               : std::vector<InputFile>{}});
  store.close();
}

Result table(EosTableOptions const& options, Context const& context) {
  require(context.options.output.has_value(), "-o", "", "a file must be given: *.csv or *.h5");
  auto const& file = *context.options.output;
  require(file.extension() == ".csv" || file.extension() == ".h5", "-o", file.string(),
          "must end in .csv or .h5");
  options.rho.require_valid("rho");
  options.T.require_valid("T");
  constexpr std::int64_t most = 4'000'000;
  require(std::int64_t{options.rho.points} * options.T.points <= most, "--rho-points times --T-points",
          std::int64_t{options.rho.points} * options.T.points, fmt::format("must be at most {}", most));
  auto const model = load_fluid(options.eos);
  warn_outside_data(model, {options.rho.min, options.rho.max}, {options.T.min, options.T.max}, context);
  auto const columns = table_columns(model, options);
  if (file.extension() == ".csv") {
    interrupts_end_at_once(); // the text of millions of states takes seconds
    write_text_file(file, csv_text(columns, model.reduced));
  } else
    write_hdf5(columns, model, options, context);
  std::size_t unstable = 0;
  for (auto const& value : columns.back().values)
    unstable += *value < 0;
  Result result;
  result.json = {{"model", options.eos.model},
                 {"file", file.string()},
                 {"states", columns[0].values.size()},
                 {"mechanically_unstable_states", unstable}};
  result.text = fmt::format("{} states ({} mechanically unstable, without a sound speed) written to {}\n",
                            columns[0].values.size(), unstable, file.string());
  return result;
}

void declare(CLI::App& app, EosTableOptions& options) {
  options.eos.declare(app);
  app.add_option("--rho-min", options.rho.min, "Least density (SI: kg/m^3)")->required();
  app.add_option("--rho-max", options.rho.max, "Greatest density (SI: kg/m^3)")->required();
  app.add_option("--rho-points", options.rho.points, "Densities, evenly spaced");
  app.add_option("--T-min", options.T.min, "Least temperature (SI: K)")->required();
  app.add_option("--T-max", options.T.max, "Greatest temperature (SI: K)")->required();
  app.add_option("--T-points", options.T.points, "Temperatures, evenly spaced");
}

} // namespace

extern Declaration const eos_table_command = with_options<EosTableOptions, declare, table>;

} // namespace mesobridge::workflows
