#pragma once
#include "fitting/shock_relations.hpp"
#include "workflows/eos/named_fluid.hpp"

namespace mesobridge::workflows {

/// An explosive at rest, the products of its reaction and the heat that it releases.
struct DetonationOptions {
  std::string reactant, product;
  InitialState initial;
  double q = 0, P0 = 0;

  void declare(CLI::App& app);
};

struct Explosive {
  NamedFluid reactant, product;
  fitting::EosState at_rest;  ///< with the pressure of the reactant's model
  fitting::Hugoniot crussard; ///< from the pressure --P0
  fitting::Hugoniot from_model_pressure;
};

/// Throws InputError for unknown models or mixed units. Warns where the reactant at rest is outside its
/// model's data.
Explosive explosive(DetonationOptions const& options, Context const& context);

} // namespace mesobridge::workflows
