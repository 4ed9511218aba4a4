#include "workflows/command/options.hpp"
#include "workflows/eos/curve_output.hpp"
#include "workflows/eos/detonation_options.hpp"
#include "workflows/eos/detonation_view.hpp"
#include "workflows/eos/shock_options.hpp"
#include <CLI/CLI.hpp>

namespace mesobridge::workflows {

namespace {

struct EosCrussardOptions {
  DetonationOptions detonation;
  ShockOptions shock;
  std::vector<std::string> slices;
};

/// Throws InputError where slices cannot be drawn.
std::vector<SliceStates> slices_of(EosCrussardOptions const& options, Context const& context, bool reduced) {
  std::vector<SliceStates> slices;
  if (options.slices.empty())
    return slices;
  auto const& file = context.options.output;
  require(file && curve_file(*file) != CurveFile::csv, "-o", file ? file->string() : "",
          "must name an .svg or .html file, in which --slices are drawn");
  if (reduced)
    throw InputError("--slices: their units are SI, and the models are in Lennard-Jones units");
  for (auto const& name : options.slices)
    slices.push_back(read_slices(name));
  return slices;
}

Result crussard(EosCrussardOptions const& options, Context const& context) {
  if (context.options.output)
    curve_file(*context.options.output);
  auto const explosive = workflows::explosive(options.detonation, context);
  bool const reduced = explosive.product.reduced;
  auto const slices = slices_of(options, context, reduced);
  auto const asked = options.shock.shock(explosive.crussard);
  Result result;
  result.json = options.detonation.names();
  if (asked) {
    warn_outside_data(explosive.product, asked->behind.rho, asked->behind.T, context);
    tell_first_row(result, shock_columns({*asked}), reduced);
  }
  put_first_row(result.json["constant_volume"], state_columns({explosive.crussard.constant_volume_state()}),
                reduced);
  if (!options.shock.P_max && !context.options.output)
    return result;
  auto const curve = options.shock.curve(explosive.crussard, asked);
  auto const columns = shock_columns(curve);
  put_curve(context, result, columns, reduced, [&] {
    return detonation_plot({explosive.reactant.name, explosive.product.name, explosive.reactant.fluid,
                            explosive.product.fluid, explosive.at_rest, explosive.crussard, reduced},
                           curve, slices);
  });
  if (!asked && !context.options.output)
    result.text = csv_text(columns, reduced);
  return result;
}

void declare(CLI::App& app, EosCrussardOptions& options) {
  options.detonation.declare(app);
  options.shock.declare(app);
  app.add_option(
         "--slices", options.slices,
         "States of a simulation to be drawn over the curves: CSV files with columns such as rho_kg_m3 "
         "and P_GPa, maybe P_se_GPa")
      ->type_name("FILE.csv");
}

} // namespace

extern Declaration const eos_crussard_command = with_options<EosCrussardOptions, declare, crussard>;

} // namespace mesobridge::workflows
