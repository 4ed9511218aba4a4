#pragma once
#include "fitting/eos/from_isochore.hpp"
#include "fitting/eos/temperature_series.hpp"
#include "md/units.hpp"
#include <limits>
#include <string_view>

namespace mesobridge::fitting {

/// What a model with constant heat capacity c_v says about one density (fitting/README.md, Eq. (F3)):
///   e = E + c_v T,   P = rho^2 E' + c_v rho Gamma T,   s = c_v (ln T - phi),   rho phi' = Gamma.
/// Each such model (Mie-Gruneisen, HZ, JWL, stiffened gas) is the pair of functions E(rho), phi(rho). Models
/// that are stated by a reference curve E_k, P_k at the temperature T_k(rho), with d ln T_k/d ln rho = Gamma,
/// have E = E_k - c_v T_k and phi = ln T_k.
template <class X>
struct LinearLaw {
  X E;               ///< energy, extrapolated along the isochore to T = 0
  X P;               ///< rho^2 dE/drho: the pressure there
  X P_slope;         ///< dP/drho
  X Gamma;           ///< Gruneisen parameter
  X rho_Gamma_slope; ///< d(rho Gamma)/drho
  X phi;
};

/// An isochore on which e and P are linear in T, so that both inversions are closed forms; the guesses are
/// not needed. Valid for T > 0.
template <class X>
class BasicLinearIsochore {
 public:
  BasicLinearIsochore(std::string_view name, X rho, double c_v, LinearLaw<X> const& law)
      : rho_(rho), law_(law), c_v_(c_v), name_(name) {}

  X density() const { return rho_; }
  X energy(X T) const { return law_.E + c_v_ * T; }
  X entropy(X T) const {
    using std::log;
    return c_v_ * (log(T) - law_.phi);
  }
  X pressure(X T) const { return law_.P + c_v_ * rho_ * law_.Gamma * T; }
  X heat_capacity(X) const { return c_v_; }
  X heat_capacity_slope(X) const { return 0.0; }
  X pressure_slope(X) const { return c_v_ * rho_ * law_.Gamma; }
  /// (dP/drho) at constant T
  X pressure_density_slope(X T) const { return law_.P_slope + c_v_ * law_.rho_Gamma_slope * T; }

  /// Inversions for any number type, whose results may lie outside the model.
  X unchecked_temperature_from_energy(X e) const { return (e - law_.E) / c_v_; }
  X unchecked_temperature_from_entropy(X s) const {
    using std::exp;
    return exp(s / c_v_ + law_.phi);
  }
  double temperature_from_energy(double e, double /*T_guess*/) const {
    double const T = unchecked_temperature_from_energy(e);
    if (!(T > 0 && std::isfinite(T)))
      refuse("energy", e, law_.E);
    return T;
  }
  double temperature_from_entropy(double s, double /*T_guess*/) const {
    double const T = unchecked_temperature_from_entropy(s);
    if (!(T > 0 && std::isfinite(T)))
      refuse("entropy", s, -std::numeric_limits<double>::infinity());
    return T;
  }

 private:
  [[noreturn]] void refuse(std::string_view quantity, double value, double at_zero) const {
    throw PhysicsError(fmt::format("{} at density {}: {} {} has no temperature between 0 and infinity; "
                                   "that of T = 0 is {}",
                                   name_, rho_, quantity, value, at_zero));
  }

  X rho_;
  LinearLaw<X> law_;
  double c_v_;
  std::string_view name_;
};

/// A model that states its isochores by laws.
template <class E>
concept LinearModel = requires(E const& eos, double rho) {
  { eos.law(rho) } -> std::same_as<LinearLaw<double>>;
  { eos.c_v() } -> std::same_as<double>;
  { eos.rho_max() } -> std::same_as<double>;
};

/// x >= 0 ? not_negative : negative
template <class X>
X by_sign(X x, double not_negative, double negative) {
  return real_part(x) >= 0 ? not_negative : negative;
}

/// Makes an equation of state of a model that defines
///   law(rho)          LinearLaw of any number type (double, complex, Pack),
///   c_v(), rho_max()  rho_max is excluded; infinity when there is no bound,
///   name              for messages.
template <class Model>
class LinearEos : public FromIsochore<Model> {
 public:
  using Isochore = BasicLinearIsochore<double>;

  /// Throws PhysicsError unless 0 < rho < rho_max and the law is finite there.
  template <class X>
  BasicLinearIsochore<X> isochore(X rho) const {
    double const density = real_part(rho);
    if (!(density > 0 && density < model().rho_max()))
      throw PhysicsError(
          fmt::format("{}: density {} is outside 0 < rho < {}", Model::name, density, model().rho_max()));
    LinearLaw<X> const law = model().law(rho);
    if (!std::isfinite(real_part(law.E + law.P + law.P_slope + law.Gamma)))
      throw PhysicsError(
          fmt::format("{}: density {} is too extreme, its energy overflows", Model::name, density));
    return {Model::name, rho, model().c_v(), law};
  }

  double temperature_guess() const { return 1; } // not needed
  void require_temperature(double T, double rho) const {
    if (!(T > 0 && std::isfinite(T)))
      throw PhysicsError(
          fmt::format("{} at density {}: temperature {} must be > 0 and finite", Model::name, rho, T));
  }

 private:
  Model const& model() const { return static_cast<Model const&>(*this); }
};

} // namespace mesobridge::fitting
