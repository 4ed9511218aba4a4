#pragma once
#include <cmath>

namespace mesobridge::fitting {

/// How the volumes of the parts make that of the mixture (fitting/README.md, Eq. (F12)).
enum class VolumeLaw {
  additive_volume, ///< 1/rho = (1 - lambda)/rho_0 + lambda/rho_1: the parts lie beside each other
  paper            ///< rho = (1 - lambda) rho_0 + lambda rho_1, thesis (6.7)
};

/// Where a particle that reacts counts as one of the pure components, which moves no energy: a trace of the
/// other one changes P by less than 1e-4, and may have no stable state (a reactant in hot thin products).
struct PureProgress {
  double reactant_below = 1e-4, product_above = 1 - 1e-6;
};

/// The densities of the parts at r = ln(rho_1/rho_0), of the same total by the law, for one state or a Pack.
template <class X>
struct MixtureDensities {
  X reactant, product;
  X share; ///< of the product in the volume (additive) or the density (paper): d ln rho_0/dr = -share
};

template <class X>
MixtureDensities<X> mixture_densities(VolumeLaw law, X lambda, X rho, X r) {
  using std::exp;
  bool const additive = law == VolumeLaw::additive_volume;
  X const ratio = exp(r), product_weight = additive ? lambda / ratio : lambda * ratio;
  X const sum = 1.0 - lambda + product_weight, reactant = additive ? rho * sum : rho / sum;
  return {reactant, reactant * ratio, product_weight / sum};
}

/// One part of a mixture at its density and the common temperature, with derivatives by ln rho at constant T.
template <class X, class Isochore>
class MixturePart {
 public:
  MixturePart(Isochore isochore, X density, X T)
      : rho(density), P(isochore.pressure(T)), P_T(isochore.pressure_slope(T)),
        rho_P_rho(density * isochore.pressure_density_slope(T)), T_(T), isochore_(std::move(isochore)) {}

  X rho, P;
  X P_T;       ///< dP/dT at constant rho
  X rho_P_rho; ///< dP/d ln rho at constant T

  X energy() const { return isochore_.energy(T_); }
  X entropy() const { return isochore_.entropy(T_); }
  X heat_capacity() const { return isochore_.heat_capacity(T_); }
  X energy_slope() const { return (P - T_ * P_T) / rho; }
  X entropy_slope() const { return -P_T / rho; }

 private:
  X T_;
  Isochore isochore_;
};

/// A step of Newton's method in T and r = ln(rho_1/rho_0).
template <class X>
struct MixtureStep {
  X dT, dr;
  X slope; ///< of the quantity that is looked for, by T along the balance
};

/// A mixture of reactant and product at equal temperature, for one state or a Pack: its pressures need not
/// balance yet. What it says of the whole, but for the gap and the derivatives by T and r, holds where they
/// do. X is double or Pack, R and P are the isochores of the parts.
template <class X, class R, class P>
struct MixtureAt {
  X lambda, rho, T, share;
  MixturePart<X, R> reactant;
  MixturePart<X, P> product;

  X energy() const { return (1.0 - lambda) * reactant.energy() + lambda * product.energy(); }
  X entropy() const { return (1.0 - lambda) * reactant.entropy() + lambda * product.entropy(); }
  X pressure() const { return (1.0 - share) * reactant.P + share * product.P; }

  /// P_1 - P_0, zero at equilibrium.
  X pressure_gap() const { return product.P - reactant.P; }
  // Derivatives by r = ln(rho_1/rho_0) at constant T and density of the whole, and by T at constant r.
  X gap_r() const { return (1.0 - share) * product.rho_P_rho + share * reactant.rho_P_rho; }
  X gap_T() const { return product.P_T - reactant.P_T; }
  X energy_r() const { return by_ratio(reactant.energy_slope(), product.energy_slope()); }
  X energy_T() const { return (1.0 - lambda) * reactant.heat_capacity() + lambda * product.heat_capacity(); }
  X entropy_r() const { return by_ratio(reactant.entropy_slope(), product.entropy_slope()); }
  X entropy_T() const { return energy_T() / T; }

  /// dr/dT along the equilibrium, and the heat capacity there.
  X r_T() const { return -gap_T() / gap_r(); }
  X heat_capacity() const { return energy_T() + energy_r() * r_T(); }
  /// Towards the balance and a given value of a quantity of the whole (energy, entropy), of which `missing`
  /// is missing; by_r and by_T are its derivatives.
  MixtureStep<X> step(X missing, X by_r, X by_T) const {
    X const inverse = 1.0 / gap_r(), along = -gap_T() * inverse, r_gap = -pressure_gap() * inverse;
    X const slope = by_T + by_r * along, dT = (missing - by_r * r_gap) / slope;
    return {dT, r_gap + along * dT, slope};
  }
  /// At constant entropy and progress; with the paper's law that of de = -P dv.
  X sound_speed_squared() const {
    // How the split follows the density of the whole, ln rho.
    X const r_rho = (reactant.rho_P_rho - product.rho_P_rho) / gap_r();
    X const by_reactant = 1.0 - share * r_rho, by_product = 1.0 + (1.0 - share) * r_rho;
    X const e_log_rho =
        (1.0 - lambda) * reactant.energy_slope() * by_reactant + lambda * product.energy_slope() * by_product;
    X const P_T = reactant.P_T - share * reactant.rho_P_rho * r_T();
    return (reactant.rho_P_rho * by_reactant + P_T / heat_capacity() * (pressure() / rho - e_log_rho)) / rho;
  }

 private:
  /// Of the whole, from slopes by ln rho of the parts.
  X by_ratio(X reactant_slope, X product_slope) const {
    return lambda * (1.0 - share) * product_slope - (1.0 - lambda) * share * reactant_slope;
  }
};

} // namespace mesobridge::fitting
