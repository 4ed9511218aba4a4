#include "workflows/eos/detonation_options.hpp"
#include "workflows/shared_options.hpp"

namespace mesobridge::workflows {

void DetonationOptions::declare(CLI::App& app, std::string const& default_of_P0) {
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
      "Pressure of the explosive at rest (SI: Pa); the model of the reactant may put the given density and "
      "temperature under tension. If not given: " +
          default_of_P0);
}

void ReactionOptions::declare(CLI::App& app) {
  detonation.declare(app, "that of the reactant's model, as in a simulation");
  add_choice(
      app, "--volume-law", volume_law, {"additive-volume", "paper"},
      "How the volumes of reactant and products make that of the mixture: 1/rho = (1 - lambda)/rho_0 + "
      "lambda/rho_1, or the thesis's rho = (1 - lambda) rho_0 + lambda rho_1");
}

Explosive explosive(DetonationOptions const& options, Context const& context) {
  auto reactant = load_fluid(options.reactant), product = load_fluid(options.product);
  require_same_units(reactant, product);
  double const P0 = options.P0.value_or(0);
  require(std::isfinite(P0), "--P0", P0, "must be finite");
  require(std::isfinite(options.q), "--q", options.q, "must be finite");
  auto const at_rest = options.initial.of(reactant, context);
  auto ahead = at_rest;
  ahead.P = P0;
  return {.reactant = reactant,
          .product = product,
          .at_rest = at_rest,
          .crussard = fitting::Hugoniot(ahead, product.fluid, options.q),
          .from_model_pressure = fitting::Hugoniot(at_rest, product.fluid, options.q)};
}

fitting::ReactiveFluid ReactionOptions::fluid(Context const& context) const {
  auto const of = explosive(detonation, context);
  if (of.reactant.reduced)
    throw InputError(
        fmt::format("'{}' is in Lennard-Jones units: an explosive must be in SI", of.reactant.name));
  auto at_rest = of.at_rest;
  at_rest.P = detonation.P0.value_or(at_rest.P);
  auto const law = volume_law == "paper" ? fitting::VolumeLaw::paper : fitting::VolumeLaw::additive_volume;
  return {of.reactant.model.eos, of.product.model.eos, law, at_rest, detonation.q};
}

} // namespace mesobridge::workflows
