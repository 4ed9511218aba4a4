#pragma once
#include "fitting/eos/linear_isochore.hpp"
#include "sdpd/caloric.hpp"
#include "sdpd/units.hpp"
#include <limits>

namespace mesobridge::sdpd {

/// True for models whose heat capacity is the same everywhere: their caloric expansions are exact.
template <class Eos>
inline constexpr bool has_constant_heat_capacity = fitting::LinearModel<Eos>;

/// Particles need a heat capacity above this [k_B]: the factor 1 - d of the friction of two equal ones, d =
/// k_B/2C at equal temperatures and less at others, is positive then (theory sheet, Eq. 2.16).
inline constexpr double least_heat_capacity = 0.5;

/// The equation of state of one particle of size K in reduced units: S(eps, rho) = m_K s(eps/m_K, rho).
template <fitting::EquationOfState Eos>
class ParticleEos {
 public:
  ParticleEos(Eos eos, ReducedUnits const& units)
      : eos_(std::move(eos)), rho_unit_(units.density), T_unit_(units.temperature),
        e_unit_(units.specific_energy()), s_unit_(units.specific_entropy()), P_unit_(units.pressure()),
        C_min_(least_heat_capacity / units.K) {}

  /// One particle's thermodynamics at its density rho; T, S, eps, P in reduced units.
  class AtDensity {
   public:
    double energy(double T) const { return isochore_.energy(T * p_.T_unit_) / p_.e_unit_; }
    double entropy(double T) const { return isochore_.entropy(T * p_.T_unit_) / p_.s_unit_; }
    double pressure(double T) const { return isochore_.pressure(T * p_.T_unit_) / p_.P_unit_; }
    double temperature_from_energy(double eps, double T_guess) const {
      return isochore_.temperature_from_energy(eps * p_.e_unit_, T_guess * p_.T_unit_) / p_.T_unit_;
    }
    double temperature_from_entropy(double S, double T_guess) const {
      return isochore_.temperature_from_entropy(S * p_.s_unit_, T_guess * p_.T_unit_) / p_.T_unit_;
    }
    Caloric caloric(double T) const {
      double const c = isochore_.heat_capacity(T * p_.T_unit_) / p_.s_unit_;
      if (!(c > p_.C_min_))
        refuse(T, c);
      double const slope = isochore_.heat_capacity_slope(T * p_.T_unit_) * p_.T_unit_ / p_.s_unit_;
      return {.T_0 = T,
              .inverse_C_0 = 1 / c,
              .curvature = -0.5 * slope / (c * c * c),
              .limit = has_constant_heat_capacity<Eos> ? std::numeric_limits<double>::infinity()
                                                       : caloric_reach * T};
    }
    double heat_capacity(double T) const { return isochore_.heat_capacity(T * p_.T_unit_) / p_.s_unit_; }

   private:
    friend class ParticleEos;
    [[noreturn]] void refuse(double T, double c) const {
      throw PhysicsError(fmt::format(
          "its heat capacity at density {:.6g} and temperature {:.6g} (reduced) is "
          "{:.4g} k_B, not above the {} k_B below which friction turns negative; "
          "take larger particles",
          isochore_.density() / p_.rho_unit_, T, least_heat_capacity * c / p_.C_min_, least_heat_capacity));
    }
    AtDensity(ParticleEos const& p, double rho) : p_(p), isochore_(p.eos_.isochore(rho * p.rho_unit_)) {}
    ParticleEos const& p_;
    decltype(std::declval<Eos const&>().isochore(1.0)) isochore_;
  };

  [[gnu::noinline]] AtDensity at(double rho) const { return AtDensity(*this, rho); }

 private:
  Eos eos_;
  double rho_unit_, T_unit_, e_unit_, s_unit_, P_unit_, C_min_;
};

} // namespace mesobridge::sdpd
