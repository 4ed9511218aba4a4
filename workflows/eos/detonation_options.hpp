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
};

/// --volume-law of the mixture of reactant and products.
struct VolumeLawOption {
  std::string name = "additive-volume";

  void declare(CLI::App& app);
  fitting::VolumeLaw law() const;
};

struct Explosive {
  NamedFluid reactant, product;
  fitting::EosState at_rest;  ///< with the pressure of the reactant's model
  fitting::Hugoniot crussard; ///< from the pressure --P0, or zero
  fitting::Hugoniot from_model_pressure;
};

/// Throws InputError for unknown models or mixed units. Warns where the reactant at rest is outside its
/// model's data.
Explosive explosive(DetonationOptions const& options, Context const& context);

/// What declare says of P0 for commands whose explosive rests at its model's own pressure, as in a
/// simulation.
inline constexpr char const* pressure_of_the_model = "that of the reactant's model, as in a simulation";

/// The same explosive with its mixtures, at rest at --P0 or at the pressure of the reactant's model. Throws
/// InputError also for reduced models, which have no rates in SI.
fitting::ReactiveFluid reactive_fluid(DetonationOptions const& options, VolumeLawOption const& law,
                                      Context const& context);

} // namespace mesobridge::workflows
