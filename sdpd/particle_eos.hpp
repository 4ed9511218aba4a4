#pragma once
#include "fitting/eos/ideal_gas.hpp"
#include "fitting/eos/linear_isochore.hpp"
#include "sdpd/caloric.hpp"
#include "sdpd/units.hpp"
#include <limits>

namespace mesobridge::sdpd {

/// True for models whose heat capacity is the same everywhere: their caloric expansions are exact.
template <class Eos>
inline constexpr bool has_constant_heat_capacity = fitting::LinearModel<Eos>;

/// The equation of state of one particle of size K in reduced units: S(eps, rho) = f m_K s(eps/(f m_K), rho).
/// The share f is (K-1)/K for the ideal gas, whose centre of mass carries the rest of the K atoms' energy and
/// pressure (theory sheet, Eq. 4.7 corrected), and 1 otherwise.
template <fitting::EquationOfState Eos>
class ParticleEos {
 public:
  ParticleEos(Eos eos, ReducedUnits const& units, double share)
      : eos_(std::move(eos)), rho_unit_(units.density), T_unit_(units.temperature),
        e_unit_(units.specific_energy() / share), s_unit_(units.specific_entropy() / share),
        P_unit_(units.pressure() / share) {}

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
    AtDensity(ParticleEos const& p, double rho) : p_(p), isochore_(p.eos_.isochore(rho * p.rho_unit_)) {}
    ParticleEos const& p_;
    decltype(std::declval<Eos const&>().isochore(1.0)) isochore_;
  };

  AtDensity at(double rho) const { return AtDensity(*this, rho); }

 private:
  Eos eos_;
  double rho_unit_, T_unit_, e_unit_, s_unit_, P_unit_;
};

} // namespace mesobridge::sdpd
