#pragma once
#include "fitting/eos/any_model.hpp"
#include "fitting/eos/mixture.hpp"
#include "fitting/shock_relations.hpp"

namespace mesobridge::fitting {

extern template class Mixture<AnyModel, AnyModel>; // compiled once

/// An explosive between its reactant and its products, which releases the heat q lambda per mass.
struct ReactiveFluid {
  Mixture<AnyModel, AnyModel> mixture;
  EosState at_rest; ///< of the reactant; its pressure may be stated instead of the model's
  double q;         ///< heat of reaction per mass, on top of what the zeros of energy of the models hold

  ReactiveFluid(AnyEos reactant, AnyEos product, VolumeLaw law, EosState const& at_rest, double q)
      : mixture(AnyModel(std::move(reactant)), AnyModel(std::move(product)), law), at_rest(at_rest), q(q) {}

  Hugoniot hugoniot() const { return {Fluid(mixture.reactant().eos()), at_rest}; }
  Hugoniot crussard() const { return {at_rest, Fluid(mixture.product().eos()), q}; }

  /// The state when the reaction has come to lambda at constant volume without loss of heat, from the
  /// density and energy before it.
  MixtureState exploded(double rho, double e, double lambda,
                        std::optional<MixtureSplit> const& guess = std::nullopt) const {
    return mixture.state(lambda, rho, e + q * lambda, guess);
  }
};

} // namespace mesobridge::fitting
