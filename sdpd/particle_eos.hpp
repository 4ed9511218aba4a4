#pragma once
#include "fitting/eos/concept.hpp"
#include "sdpd/units.hpp"

namespace mesobridge::sdpd {

/// Temperature and heat capacity of a particle whose energy changes at fixed density, in small steps:
///     T <- T + d (1/C + c d),  1/C <- 1/C + 2 c d,  c = -(dC/dT) / 2 C^3,
/// the expansion to second order about the energy where `T_start` was exact. It is exact for a constant heat
/// capacity; otherwise its relative error is of third order in (T - T_start)/T_start, and the engine renews
/// it (one warm Newton inversion) when that grows past `caloric_reach`. So two multiplications take the place
/// of an inversion of the equation of state for each pair. Energy is conserved whatever the error is, because
/// the energies are the variables; only the friction feels it, through T.
struct Caloric {
  double T, inverse_C, curvature, T_start;

  void heat(double d) {
    T += d * (inverse_C + curvature * d);
    inverse_C += 2 * curvature * d;
  }
  /// False too when T is not a number, and when T <= 0.
  bool in_reach() const;
};

/// Largest relative change of T that an expansion serves; T is then right to about 1e-5 for the LJ fluid.
inline constexpr double caloric_reach = 0.03;

inline bool Caloric::in_reach() const {
  return std::abs(T - T_start) <= caloric_reach * T_start;
}

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
      return {T, 1 / c, -0.5 * slope / (c * c * c), T};
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
