#pragma once
#include "fitting/eos/packed.hpp"
#include "sdpd/state/caloric.hpp"
#include "sdpd/state/units.hpp"
#include <limits>
#include <optional>

namespace mesobridge::sdpd {

/// True for models whose heat capacity is the same everywhere: their caloric expansions are exact.
template <class Eos>
inline constexpr bool has_constant_heat_capacity = fitting::LinearModel<Eos>;

/// Particles need a heat capacity above this [k_B]: the factor 1 - d of the friction of two equal ones, d =
/// k_B/2C at equal temperatures and less at others, is positive then (sdpd/README.md, Eq. (S15)).
inline constexpr double least_heat_capacity = 0.5;

/// The equation of state of one particle in reduced units: S(eps, rho) = m s(eps/m, rho), where m is 1 but
/// for particles of another size than that of the units.
template <fitting::EquationOfState Eos>
class ParticleEos {
 public:
  ParticleEos(Eos eos, ReducedUnits const& units, double mass = 1)
      : eos_(std::move(eos)), rho_unit_(units.density), T_unit_(units.temperature),
        e_unit_(units.specific_energy() / mass), s_unit_(units.specific_entropy() / mass),
        P_unit_(units.pressure()), C_min_(least_heat_capacity / units.K) {}

  /// The thermodynamics of one particle, or of a pack of them, at the density rho; T, S, eps, P in reduced
  /// units.
  template <class Isochore, class X>
  class AtDensity {
   public:
    X energy(X T) const { return isochore_.energy(T * p_.T_unit_) / p_.e_unit_; }
    X entropy(X T) const { return isochore_.entropy(T * p_.T_unit_) / p_.s_unit_; }
    X pressure(X T) const { return isochore_.pressure(T * p_.T_unit_) / p_.P_unit_; }
    X heat_capacity(X T) const { return isochore_.heat_capacity(T * p_.T_unit_) / p_.s_unit_; }
    /// -(dC/dT)/(2 C^3), see Caloric
    X curvature(X T, X C) const {
      X const slope = isochore_.heat_capacity_slope(T * p_.T_unit_) * p_.T_unit_ / p_.s_unit_;
      return -0.5 * slope / (C * C * C);
    }
    X temperature_from_energy(X eps, X T_guess) const {
      return fitting::temperature_from_energy(isochore_, eps * p_.e_unit_, T_guess * p_.T_unit_) / p_.T_unit_;
    }
    X temperature_from_entropy(X S, X T_guess) const {
      return fitting::temperature_from_entropy(isochore_, S * p_.s_unit_, T_guess * p_.T_unit_) / p_.T_unit_;
    }
    Caloric caloric(double T) const {
      double const C = heat_capacity(T);
      if (!(C > p_.C_min_))
        refuse(T, C);
      return {.T_0 = T, .inverse_C_0 = 1 / C, .curvature = curvature(T, C), .limit = reach(T)};
    }
    /// The same for `count` lanes, written where the mask says.
    void store_calorics(fitting::Pack T, fitting::PackMask where, int count, Caloric* to) const {
      fitting::Pack const C = heat_capacity(T), inverse_C = 1.0 / C, bend = curvature(T, C);
      for (int lane = 0; lane < count; ++lane)
        if (where[lane])
          to[lane] = {T.v[lane], inverse_C.v[lane], bend.v[lane], reach(T.v[lane])};
    }
    /// Lanes at whose temperatures the model holds and makes particles.
    fitting::PackMask covered(fitting::Pack T) const {
      return fitting::covers(p_.eos_, isochore_.density(), T * p_.T_unit_) & (heat_capacity(T).v > p_.C_min_);
    }

   private:
    friend class ParticleEos;
    static double reach(double T) {
      return has_constant_heat_capacity<Eos> ? std::numeric_limits<double>::infinity() : caloric_reach * T;
    }
    [[noreturn]] void refuse(double T, double C) const {
      throw PhysicsError(fmt::format(
          "its heat capacity at density {:.6g} and temperature {:.6g} (reduced) is "
          "{:.4g} k_B, not above the {} k_B below which friction turns negative; "
          "take larger particles",
          isochore_.density() / p_.rho_unit_, T, least_heat_capacity * C / p_.C_min_, least_heat_capacity));
    }
    AtDensity(ParticleEos const& p, Isochore isochore) : p_(p), isochore_(std::move(isochore)) {}
    ParticleEos const& p_;
    Isochore isochore_;
  };

  std::optional<double> constant_heat_capacity() const {
    if constexpr (has_constant_heat_capacity<Eos>)
      return eos_.c_v() / s_unit_;
    else
      return std::nullopt;
  }

  [[gnu::noinline]] auto at(double rho) const {
    auto isochore = eos_.isochore(rho * rho_unit_);
    return AtDensity<decltype(isochore), double>(*this, std::move(isochore));
  }
  [[gnu::noinline]] auto at(fitting::Pack rho) const requires fitting::PackedModel<Eos> {
    auto isochore = fitting::packed_isochore(eos_, rho * rho_unit_);
    return AtDensity<decltype(isochore), fitting::Pack>(*this, std::move(isochore));
  }

 private:
  Eos eos_;
  double rho_unit_, T_unit_, e_unit_, s_unit_, P_unit_, C_min_;
};

} // namespace mesobridge::sdpd
