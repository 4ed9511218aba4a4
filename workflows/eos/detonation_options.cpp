#include "workflows/eos/detonation_options.hpp"
#include <CLI/CLI.hpp>

namespace mesobridge::workflows {

void DetonationOptions::declare(CLI::App& app) {
  app.add_option("--reactant", reactant, "The explosive: a name of `eos list`, or a model's file")
      ->required()
      ->type_name("NAME|FILE");
  app.add_option("--product", product, "Its detonation products")->required()->type_name("NAME|FILE");
  initial.declare(app);
  app.add_option(
         "--q", q,
         "Heat of reaction per mass (SI: J/kg), on top of what the zeros of energy of the two models hold")
      ->required();
  app.add_option(
      "--P0", P0,
      "Pressure of the explosive at rest (SI: Pa). A liquid stands at about zero, while the model of the "
      "reactant may put the given density and temperature under tension");
}

Explosive explosive(DetonationOptions const& options, Context const& context) {
  auto reactant = load_fluid(options.reactant), product = load_fluid(options.product);
  require_same_units(reactant, product);
  require(std::isfinite(options.P0), "--P0", options.P0, "must be finite");
  auto const at_rest = options.initial.of(reactant, context);
  auto ahead = at_rest;
  ahead.P = options.P0;
  return {.reactant = reactant,
          .product = product,
          .at_rest = at_rest,
          .crussard = fitting::Hugoniot(ahead, product.fluid, options.q),
          .from_model_pressure = fitting::Hugoniot(at_rest, product.fluid, options.q)};
}

} // namespace mesobridge::workflows
