#pragma once
#include "fitting/eos/concept.hpp"
#include "fitting/eos/lj_bwr_1993.hpp"
#include "fitting/eos/lj_bwr_isochore.hpp"

namespace mesobridge::fitting {

/// Where the low-temperature continuation begins: 100 K for argon (thesis, section 5.1.2), the same T* for
/// `lj`.
inline constexpr double lj_bwr_T_low = 100.0 * k_B / argon_units.epsilon;

/// The published set. Its simulations cover 0.7 <= T* <= 6 and 0.005 <= rho* <= 1.25; the heat capacity is
/// positive over the whole domain given here (checked by a test), so T(e, rho) is unique there.
inline constexpr LjBwrSet lj_bwr_1993{.x = lj_bwr_1993_parameters,
                                      .gamma = lj_bwr_1993_gamma,
                                      .T_low = lj_bwr_T_low,
                                      .T_max = 100,
                                      .rho_max = 1.3};

/// The Lennard-Jones fluid by the modified Benedict-Webb-Rubin equation (fitting/README.md, Eq. (F8)), with
/// constant heat capacity below T_low (Eq. (F9)). The fundamental relation is A(rho, T);
/// entropies count from the ideal gas at rho* = T* = 1. With units: SI; without: Lennard-Jones units, per
/// atom.
///
/// Functions of (e, rho) invert e(T) first; a state outside domain() throws PhysicsError that names it. Code
/// that stays at one density should hold the isochore.
class LjBwr {
 public:
  static constexpr std::string_view name = "LJ-BWR";
  using Isochore = LjBwrIsochore;

  /// Throws InputError when a parameter is not finite or a bound is not positive.
  explicit LjBwr(LjBwrSet const& set, std::optional<LjUnits> units = std::nullopt);

  /// Throws PhysicsError unless 0 < rho <= rho_max.
  template <class X>
  BasicLjBwrIsochore<X> isochore(X rho) const {
    if (!(real_part(rho) > 0 && real_part(rho) <= rho_max_))
      refuse_density(real_part(rho));
    return {set_, matrix_, scale_, rho};
  }
  /// The same without looking at the densities.
  BasicLjBwrIsochore<Pack> packed_isochore(Pack rho) const { return {set_, matrix_, scale_, rho}; }
  /// The lanes in which such an isochore holds.
  PackMask covers(Pack rho, Pack T) const {
    double const T_low = set_.T_low * scale_.temperature, T_max = set_.T_max * scale_.temperature;
    return (rho.v > 0) & (rho.v <= rho_max_) & (T.v >= T_low) & (T.v <= T_max);
  }

  double temperature(double e, double rho) const {
    return isochore(rho).temperature_from_energy(e, scale_.temperature);
  }
  double entropy(double e, double rho) const;
  double pressure(double e, double rho) const;
  double heat_capacity(double e, double rho) const;
  /// c^2 = (dP/drho)_T + T (dP/dT)^2/(rho^2 c_v). Throws PhysicsError where it is negative: the fluid is
  /// mechanically unstable there (inside the liquid-gas region).
  double sound_speed(double e, double rho) const;
  double energy_from_entropy(double s, double rho) const;
  double energy_from_temperature(double T, double rho) const;

  /// A_res/(k_B T) per atom.
  double alpha_r(double rho, double T) const;

  Domain domain() const;
  double molecular_mass() const { return scale_.mass; }
  double boltzmann() const { return scale_.boltzmann; }
  LjBwrSet const& set() const { return set_; }
  std::optional<LjUnits> const& units() const { return units_; }
  LjScale const& scale() const { return scale_; }
  /// The same fluid in other units.
  LjBwr in_units(std::optional<LjUnits> units) const { return LjBwr(set_, units); }

 private:
  [[noreturn]] void refuse_density(double rho) const;
  void require_temperature(double T, double rho) const;

  LjBwrSet set_;
  bwr::Matrix matrix_;
  std::optional<LjUnits> units_;
  LjScale scale_;
  double rho_max_; // in the model's units
};

static_assert(EquationOfState<LjBwr>);

} // namespace mesobridge::fitting
