#pragma once
#include "fitting/fluid.hpp"
#include <vector>

namespace mesobridge::fitting {

/// A steady plane shock or detonation that runs at v_S into matter at rest and leaves it moving at v_P.
/// It obeys the Rankine-Hugoniot relations (fitting/README.md, Eq. (F14)):
///   rho_1 (v_S - v_P) = rho_0 v_S,   P_1 = P_0 + rho_0 v_S v_P,
///   e_1 = e_0 + q + (P_0 + P_1)(1/rho_0 - 1/rho_1)/2.
struct Shock {
  EosState ahead, behind;
  double v_S, v_P; ///< [m/s], or sqrt(epsilon/m) for a reduced model
};

/// How well a Chapman-Jouguet state fulfils the conditions that it was not solved from.
struct CjChecks {
  double tangency; ///< slope of the Crussard curve, by differences, over that of the Rayleigh line, minus 1
  double
      neighbours; ///< least relative excess of D at 0.1 % and 1 % more and less compression; > 0 at a minimum
};

/// All shocks that can run into one state: the Hugoniot curve of a fluid, or, with the equation of state of
/// the products and the heat q that the reaction releases per mass, the Crussard curve.
///
/// A function of given v_P, v_S, P or rho solves one equation for the compression (or, at given rho, the
/// temperature): it follows the physical branch from the initial density up to the first solution. The result
/// is accurate to round-off. PhysicsError when there is none inside the models, or when it is no shock: the
/// flow must be faster than sound ahead and slower behind, and the entropy must not fall.
class Hugoniot {
 public:
  /// Throws PhysicsError when the initial state has no sound speed.
  Hugoniot(Fluid fluid, EosState const& ahead);
  /// q in energy per mass, any sign.
  Hugoniot(EosState const& ahead, Fluid products, double q);

  /// By the velocity of the piston, > 0. A detonation must be overdriven: v_P at least that of the
  /// Chapman-Jouguet state.
  Shock from_piston(double v_P) const;
  /// By the velocity of the front, above the sound speed ahead (that of the Chapman-Jouguet state).
  Shock from_speed(double v_S) const;
  /// By the pressure behind, above that ahead (that of combustion at constant volume). Weak detonations are
  /// given too: they are states of the Crussard curve.
  Shock from_pressure(double P) const;
  /// By the density behind, above that ahead.
  Shock from_density(double rho) const;

  /// The slowest detonation: D is least on the Crussard curve, the Rayleigh line touches it, and the
  /// products leave the front at their speed of sound. Solved from the last condition.
  Shock chapman_jouguet() const;
  CjChecks check(Shock const& cj) const;

  /// Pressure on the Rayleigh line of a front at v_S, at the density rho: P_0 + (rho_0 v_S)^2 (v_0 - v).
  double rayleigh_pressure(double v_S, double rho) const;
  /// States of equally spaced pressures from just above the first to P_last.
  std::vector<Shock> curve(double P_last, int points) const;

  EosState const& ahead() const { return ahead_; }
  /// The state after the reaction at constant volume; that ahead when nothing reacts.
  EosState constant_volume_state() const;

 private:
  double density(double z) const { return ahead_.rho * (1 + z); }
  double volume_change(double z) const { return z / (1 + z) / ahead_.rho; }
  double greatest_compression() const;
  bool reacts() const { return reacts_; }
  Shock shock(double rho, double e) const;
  Shock at_compression(double z) const;
  void require_shock(Shock const& found, std::string const& asked) const;
  [[noreturn]] void refuse(std::string const& asked, std::string const& why) const;

  Fluid fluid_; // of the state behind
  EosState ahead_;
  double q_;
  bool reacts_;
};

} // namespace mesobridge::fitting
