#pragma once
#include "fitting/reactive_fluid.hpp"
#include "workflows/eos/named_fluid.hpp"

namespace mesobridge::workflows {

/// An explosive at rest, the products of its reaction and the heat that it releases.
struct DetonationOptions {
  std::string reactant, product;
  InitialState initial;
  double q = 0;
  std::optional<double> P0;

  /// The help says what P0 is where none is given.
  void declare(CLI::App& app, std::string const& default_of_P0 = "0, at which a liquid stands about");
  /// The names of reactant and product, with which every result begins.
  Json names() const { return {{"reactant", reactant}, {"product", product}}; }
};

/// An explosive with the mixtures that it goes through. Where no --P0 is given it rests at the pressure of
/// the reactant's model, as in a simulation.
struct ReactionOptions {
  DetonationOptions detonation;
  std::string volume_law = "additive-volume";

  void declare(CLI::App& app);
  /// Throws InputError as explosive(), and for reduced models, which have no rates in SI. Warns as that.
  fitting::ReactiveFluid fluid(Context const& context) const;
};

struct Explosive {
  NamedFluid reactant, product;
  fitting::EosState at_rest;  ///< with the pressure of the reactant's model
  fitting::Hugoniot crussard; ///< from the pressure --P0, or zero
  fitting::Hugoniot from_model_pressure;
};

/// Throws InputError for unknown models, mixed units or numbers that are not finite. Warns where the reactant
/// at rest is outside its model's data.
Explosive explosive(DetonationOptions const& options, Context const& context);

} // namespace mesobridge::workflows
