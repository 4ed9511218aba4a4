#pragma once
#include "md/error.hpp"
#include "md/units.hpp"
#include <cmath>

namespace mesobridge::fitting {

/// k(T) = Z exp(-E_a/(k_B T)), SI.
struct Arrhenius {
  double Z;   ///< [1/s], > 0
  double E_a; ///< of one molecule [J], >= 0

  double activation_temperature() const { return E_a / k_B; }
  double rate(double T) const { return Z * std::exp(-activation_temperature() / T); }
};

/// What a molecule meets: the sum of the weights of its neighbours in the thesis's second-order law, whose
/// value in a uniform fluid depends on how the weights are made.
enum class NeighbourSum {
  density,            ///< rho/rho_bar: the weights are the kernel's in the particles' units
  density_minus_self, ///< rho/rho_bar less the particle's own weight: the thesis's sum over j != i
  unit                ///< 1: weights by the neighbours' volumes
};

/// Irreversible kinetics of a uniform fluid (fitting/README.md, Eq. (F23)):
///   dlambda/dt = k(T) (1 - lambda)^2 S(rho)   (second order)   or   k(T) (1 - lambda)   (first order).
struct Kinetics {
  enum class Order { first, second };

  Arrhenius arrhenius;
  Order order = Order::second;
  NeighbourSum sum = NeighbourSum::density;
  double rho_bar = 1;     ///< density at which the sum over all is one [kg/m^3]
  double self_weight = 0; ///< the particle's own part of it, W(0) in the particles' units

  /// Throws InputError.
  void validate() const {
    require(arrhenius.Z > 0 && std::isfinite(arrhenius.Z), "prefactor Z", arrhenius.Z,
            "must be > 0 and finite");
    require(arrhenius.E_a >= 0 && std::isfinite(arrhenius.E_a), "activation energy", arrhenius.E_a,
            "must be >= 0 and finite");
    require(rho_bar > 0 && std::isfinite(rho_bar), "density of the neighbours' sum", rho_bar,
            "must be > 0 and finite");
    require(self_weight >= 0 && std::isfinite(self_weight), "weight of the particle itself", self_weight,
            "must be >= 0 and finite");
  }

  /// S; 1 in first order, where no neighbour takes part.
  double neighbour_sum(double rho) const {
    if (order == Order::first || sum == NeighbourSum::unit)
      return 1;
    return rho / rho_bar - (sum == NeighbourSum::density_minus_self ? self_weight : 0);
  }
  /// dlambda/dt [1/s]
  double rate(double lambda, double rho, double T) const {
    double const left = 1 - lambda;
    return arrhenius.rate(T) * neighbour_sum(rho) * (order == Order::second ? left * left : left);
  }
  /// The same; throws PhysicsError where nothing reacts.
  double positive_rate(double lambda, double rho, double T) const {
    double const found = rate(lambda, rho, T);
    if (!(found > 0))
      throw PhysicsError(fmt::format("the reaction stands still at progress {}, density {}, temperature {}: "
                                     "its rate is {}",
                                     lambda, rho, T, found));
    return found;
  }
};

} // namespace mesobridge::fitting
