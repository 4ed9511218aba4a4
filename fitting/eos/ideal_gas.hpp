#pragma once
#include "fitting/eos/linear_isochore.hpp"
#include "fitting/eos/temperature_series.hpp"
#include "md/error.hpp"
#include "md/units.hpp"
#include <cmath>
#include <limits>

namespace mesobridge::fitting {

/// An ideal gas at one density. R = k_B/m0.
template <class X>
class BasicIdealGasIsochore {
 public:
  BasicIdealGasIsochore(X rho, double c_v, double R) : rho_(rho), c_v_(c_v), R_(R) {}

  X density() const { return rho_; }
  X energy(X T) const { return c_v_ * T; }
  X entropy(X T) const { return c_v_ * std::log(c_v_ * T) - R_ * std::log(rho_); }
  X pressure(X T) const { return rho_ * R_ * T; }
  X heat_capacity(X) const { return c_v_; }
  X heat_capacity_slope(X) const { return 0.0; }
  X pressure_slope(X) const { return rho_ * R_; }
  X pressure_density_slope(X T) const { return R_ * T; }

  double temperature_from_energy(double e, double /*T_guess*/) const {
    if (!(e > 0))
      throw PhysicsError(fmt::format("ideal gas at density {}: energy {} has no temperature > 0", rho_, e));
    return e / c_v_;
  }
  double temperature_from_entropy(double s, double /*T_guess*/) const {
    double const e = std::exp((s + R_ * std::log(rho_)) / c_v_);
    if (!(e > 0 && std::isfinite(e)))
      throw PhysicsError(
          fmt::format("ideal gas at density {}: entropy {} has no finite temperature > 0", rho_, s));
    return e / c_v_;
  }

 private:
  X rho_;
  double c_v_, R_;
};

/// Ideal gas of molecules with `dof` quadratic degrees of freedom (3: monatomic). Per unit mass,
///   s(e, rho) = c_v ln e - (k_B/m0) ln rho,   c_v = (dof/2) k_B/m0,
/// so P = (gamma - 1) rho e with gamma = 1 + 2/dof. fitting/README.md, Eq. (F2).
/// The logarithms are of the numbers in the model's units: s = 0 at e = 1, rho = 1.
class IdealGas {
 public:
  static constexpr std::string_view name = "ideal gas";
  using Isochore = BasicIdealGasIsochore<double>;

  /// m0: mass of one molecule > 0; dof > 0; k_B in the same units. Throws InputError.
  explicit IdealGas(double m0, double dof = 3, double boltzmann = k_B)
      : m0_(m0), dof_(dof), boltzmann_(boltzmann) {
    require(m0 > 0 && std::isfinite(m0), "ideal gas m0", m0, "must be > 0 and finite");
    require(dof > 0 && std::isfinite(dof), "ideal gas dof", dof, "must be > 0 and finite");
    require(boltzmann > 0 && std::isfinite(boltzmann), "ideal gas k_B", boltzmann, "must be > 0 and finite");
  }

  /// The gas with the heat capacity ratio gamma > 1.
  static IdealGas from_gamma(double m0, double gamma, double boltzmann = k_B) {
    require(gamma > 1 && std::isfinite(gamma), "ideal gas gamma", gamma, "must be > 1 and finite");
    return IdealGas(m0, 2 / (gamma - 1), boltzmann);
  }

  double molecular_mass() const { return m0_; }
  double boltzmann() const { return boltzmann_; }
  double dof() const { return dof_; }
  double gamma() const { return 1 + 2 / dof_; }

  /// Throws PhysicsError unless rho > 0 and finite.
  template <class X>
  BasicIdealGasIsochore<X> isochore(X rho) const {
    if (!(real_part(rho) > 0 && std::isfinite(real_part(rho))))
      throw PhysicsError(fmt::format("ideal gas: density {} must be > 0", real_part(rho)));
    return {rho, c_v(), R()};
  }

  /// The same as a LinearModel.
  template <class X>
  LinearLaw<X> law(X rho) const {
    using std::log;
    double const Gamma = 2 / dof_;
    return {.E = 0.0,
            .P = 0.0,
            .P_slope = 0.0,
            .Gamma = Gamma,
            .rho_Gamma_slope = Gamma,
            .phi = Gamma * log(rho) - std::log(c_v())};
  }
  double c_v() const { return 0.5 * dof_ * R(); }
  double rho_max() const { return std::numeric_limits<double>::infinity(); }

  double temperature(double e, double rho) const { return isochore(rho).temperature_from_energy(e, 1); }
  double entropy(double e, double rho) const { return isochore(rho).entropy(temperature(e, rho)); }
  double pressure(double e, double rho) const { return isochore(rho).pressure(temperature(e, rho)); }
  double heat_capacity(double e, double rho) const {
    return isochore(rho).heat_capacity(temperature(e, rho));
  }
  double sound_speed(double e, double rho) const {
    return std::sqrt((1 + 2 / dof_) * R() * temperature(e, rho));
  }
  double energy_from_entropy(double s, double rho) const {
    return c_v() * isochore(rho).temperature_from_entropy(s, 1);
  }
  double energy_from_temperature(double T, double rho) const {
    if (!(T > 0))
      throw PhysicsError(fmt::format("ideal gas at density {}: temperature {} must be > 0", rho, T));
    return isochore(rho).energy(T);
  }

  Domain domain() const {
    double const infinity = std::numeric_limits<double>::infinity();
    return {0, infinity, 0, infinity, "every density > 0 and every energy > 0"};
  }

 private:
  double R() const { return boltzmann_ / m0_; }

  double m0_, dof_, boltzmann_;
};

static_assert(EquationOfState<IdealGas>);

} // namespace mesobridge::fitting
