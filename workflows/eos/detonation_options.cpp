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

void VolumeLawOption::declare(CLI::App& app) {
  add_choice(
      app, "--volume-law", name, {"additive-volume", "paper"},
      "How the volumes of reactant and products make that of the mixture: 1/rho = (1 - lambda)/rho_0 + "
      "lambda/rho_1, or the thesis's rho = (1 - lambda) rho_0 + lambda rho_1");
}

fitting::VolumeLaw VolumeLawOption::law() const {
  return name == "paper" ? fitting::VolumeLaw::paper : fitting::VolumeLaw::additive_volume;
}

Explosive explosive(DetonationOptions const& options, Context const& context) {
  auto reactant = load_fluid(options.reactant), product = load_fluid(options.product);
  require_same_units(reactant, product);
  double const P0 = options.P0.value_or(0);
  require(std::isfinite(P0), "--P0", P0, "must be finite");
  auto const at_rest = options.initial.of(reactant, context);
  auto ahead = at_rest;
  ahead.P = P0;
  return {.reactant = reactant,
          .product = product,
          .at_rest = at_rest,
          .crussard = fitting::Hugoniot(ahead, product.fluid, options.q),
          .from_model_pressure = fitting::Hugoniot(at_rest, product.fluid, options.q)};
}

fitting::ReactiveFluid reactive_fluid(DetonationOptions const& options, VolumeLawOption const& law,
                                      Context const& context) {
  auto const reactant = load_fluid(options.reactant), product = load_fluid(options.product);
  require_same_units(reactant, product);
  if (reactant.reduced)
    throw InputError(
        fmt::format("'{}' is in Lennard-Jones units: an explosive must be in SI", reactant.name));
  require(std::isfinite(options.q), "--q", options.q, "must be finite");
  auto at_rest = options.initial.of(reactant, context);
  if (options.P0) {
    require(std::isfinite(*options.P0), "--P0", *options.P0, "must be finite");
    at_rest.P = *options.P0;
  }
  return {reactant.model.eos, product.model.eos, law.law(), at_rest, options.q};
}

} // namespace mesobridge::workflows
