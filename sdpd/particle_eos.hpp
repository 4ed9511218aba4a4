#pragma once
#include "fitting/eos/concept.hpp"
#include "sdpd/units.hpp"

namespace mesobridge::sdpd {

/// The caloric state of a particle at fixed density, as an expansion of T about a reference energy:
///     T(eps) = T0 + x (1 + kappa x),  x = (eps - eps0) / C0,  kappa = -C0'/(2 C0).
/// It is exact for a constant heat capacity; otherwise its relative error is of third order in x/T0, and the
/// engine renews it (one warm Newton inversion) when |x| grows past `caloric_reach` T0. That replaces an
/// inversion of the equation of state for each pair by two multiplications. Energy is conserved whatever the
/// error is, because the energies are the variables; only the friction feels it, through T.
struct Caloric {
  double eps0, T0, inv_C0, kappa;

  double temperature(double eps) const {
    double const x = (eps - eps0) * inv_C0;
    return T0 + x * (1 + kappa * x);
  }
  /// 1/C(eps) = dT/deps
  double inverse_heat_capacity(double eps) const { return inv_C0 * (1 + 2 * kappa * (eps - eps0) * inv_C0); }
  bool reaches(double eps) const;
};

/// Largest |x|/T0 at which a caloric expansion serves; T is then right to about 1e-5 for the LJ fluid.
inline constexpr double caloric_reach = 0.03;

inline bool Caloric::reaches(double eps) const {
  return kappa == 0 || std::abs((eps - eps0) * inv_C0) <= caloric_reach * T0;
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
    Caloric caloric(double eps, double T) const {
      double const T_si = T * p_.T_unit_;
      double const c = isochore_.heat_capacity(T_si);
      double const slope = isochore_.heat_capacity_slope(T_si);
      return {eps, T, p_.s_unit_ / c, -0.5 * slope / c * p_.T_unit_};
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
