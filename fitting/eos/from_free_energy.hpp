#pragma once
#include "fitting/eos/from_isochore.hpp"
#include "fitting/eos/lj_scale.hpp"
#include "fitting/eos/monotone_root.hpp"
#include "fitting/eos/taylor.hpp"

namespace mesobridge::fitting {

/// A fluid of atoms stated by its residual Helmholtz energy, in Lennard-Jones units per atom:
///   residual(rho, T)         A_res for any number type (double, complex, Taylor),
///   T_max, rho_max           and
///   T_min(rho)               the states where it may be used; de/dT > 0 there, so that T(e, rho) is unique,
///   name, edge               for messages.
template <class R>
concept ResidualFreeEnergy = requires(double x, Taylor<double, 1> y) {
  { R::residual(x, x) } -> std::same_as<double>;
  { R::residual(y, y) } -> std::same_as<Taylor<double, 1>>;
  { R::T_min(x) + R::T_max + R::rho_max } -> std::convertible_to<double>;
  { R::name } -> std::convertible_to<std::string_view>;
  { R::edge } -> std::convertible_to<std::string_view>;
};

/// A = A_res + T (ln rho - 3/2 ln T) of such a fluid at one density, in the model's units. Every function
/// evaluates the formula with as many derivatives as it needs.
template <ResidualFreeEnergy R, class X>
class BasicFreeEnergyIsochore {
 public:
  BasicFreeEnergyIsochore(LjScale const& scale, X rho) : rho_(rho / scale.density), scale_(scale) {}

  X density() const { return rho_ * scale_.density; }
  double T_min() const { return R::T_min(real_part(rho_)) * scale_.temperature; }
  X residual_free_energy(X T) const { return scale_.specific_energy * R::residual(rho_, reduced(T)); }
  X energy(X T) const {
    X const t = reduced(T);
    auto const A = in_temperature<1>(t);
    return scale_.specific_energy * (1.5 * t + A.c[0] - t * A.c[1]);
  }
  X entropy(X T) const {
    X const t = reduced(T);
    return scale_.specific_entropy() * (ideal_entropy(t) - in_temperature<1>(t).c[1]);
  }
  X heat_capacity(X T) const {
    X const t = reduced(T);
    return scale_.specific_entropy() * (1.5 - 2.0 * t * in_temperature<2>(t).c[2]);
  }
  X heat_capacity_slope(X T) const {
    X const t = reduced(T);
    auto const A = in_temperature<3>(t);
    return -scale_.specific_entropy() / scale_.temperature * (2.0 * A.c[2] + 6.0 * t * A.c[3]);
  }
  X pressure(X T) const {
    X const t = reduced(T);
    return scale_.pressure * rho_ * (t + rho_ * in_density<1>(t).c[1]);
  }
  X pressure_slope(X T) const {
    using Mixed = Taylor<Taylor<X, 1>, 1>;
    Mixed const rho(Taylor<X, 1>::variable(rho_)), t = Mixed::variable(Taylor<X, 1>(reduced(T)));
    return scale_.pressure / scale_.temperature * rho_ * (1.0 + rho_ * R::residual(rho, t).c[1].c[1]);
  }
  /// (dP/drho) at constant T
  X pressure_density_slope(X T) const {
    X const t = reduced(T);
    auto const A = in_density<2>(t);
    return scale_.specific_energy * (t + 2.0 * rho_ * (A.c[1] + rho_ * A.c[2]));
  }

  double temperature_from_energy(double e, double T_guess) const {
    double const target = e / scale_.specific_energy;
    return solve("energy", e, target, T_guess, [&](double t) {
      auto const A = in_temperature<3>(t);
      return Jet{1.5 * t + A.c[0] - t * A.c[1], 1.5 - 2 * t * A.c[2], -2 * A.c[2] - 6 * t * A.c[3]};
    });
  }
  double temperature_from_entropy(double s, double T_guess) const {
    double const target = s / scale_.specific_entropy();
    return solve("entropy", s, target, T_guess, [&](double t) {
      auto const A = in_temperature<3>(t);
      return Jet{ideal_entropy(t) - A.c[1], 1.5 / t - 2 * A.c[2], -1.5 / (t * t) - 6 * A.c[3]};
    });
  }

 private:
  X reduced(X T) const { return T / scale_.temperature; }
  X ideal_entropy(X t) const { return std::log(t * std::sqrt(t) / rho_); }
  template <int N>
  Taylor<X, N> in_temperature(X t) const {
    return R::residual(Taylor<X, N>(rho_), Taylor<X, N>::variable(t));
  }
  template <int N>
  Taylor<X, N> in_density(X t) const {
    return R::residual(Taylor<X, N>::variable(rho_), Taylor<X, N>(t));
  }
  template <class F>
  double solve(std::string_view quantity, double given, double target, double T_guess, F&& jet) const {
    double const T_min = R::T_min(rho_);
    auto const t = solve_increasing(jet, target, T_min, R::T_max, T_guess / scale_.temperature);
    if (!t)
      throw PhysicsError(fmt::format("{} at density {} (rho* = {:.6g}): {} {} (reduced {:.6g}) has no "
                                     "temperature in {} <= T* <= {}",
                                     R::name, density(), rho_, quantity, given, target, T_min, R::T_max));
    return *t * scale_.temperature;
  }

  X rho_; // reduced
  LjScale scale_;
};

/// Makes an equation of state of a residual free energy. Entropies count from the ideal gas at rho* = T* = 1,
/// as those of LjBwr. With units: SI; without: Lennard-Jones units, per atom.
template <ResidualFreeEnergy R>
class FromFreeEnergy : public FromIsochore<FromFreeEnergy<R>> {
 public:
  using Isochore = BasicFreeEnergyIsochore<R, double>;
  static constexpr std::string_view name = R::name;

  explicit FromFreeEnergy(std::optional<LjUnits> units = std::nullopt)
      : units_(units), scale_(LjScale::of(units)) {}

  /// Throws PhysicsError unless 0 < rho <= rho_max.
  template <class X>
  BasicFreeEnergyIsochore<R, X> isochore(X rho) const {
    double const density = real_part(rho), rho_max = R::rho_max * scale_.density;
    if (!(density > 0 && density <= rho_max))
      throw PhysicsError(fmt::format("{}: density {} (rho* = {:.6g}) is outside 0 < rho* <= {}", name,
                                     density, density / scale_.density, R::rho_max));
    return {scale_, rho};
  }

  /// A_res/(k_B T) per atom.
  double alpha_r(double rho, double T) const {
    require_temperature(T, rho);
    return isochore(rho).residual_free_energy(T) / (scale_.specific_entropy() * T);
  }

  void require_temperature(double T, double rho) const {
    double const t = T / scale_.temperature, t_min = R::T_min(rho / scale_.density);
    if (!(t >= t_min && t <= R::T_max))
      throw PhysicsError(
          fmt::format("{} at density {}: temperature {} (T* = {:.6g}) is outside {} <= T* <= {}", name, rho,
                      T, t, t_min, R::T_max));
  }

  double temperature_guess() const { return 2 * scale_.temperature; }
  double molecular_mass() const { return scale_.mass; }
  double boltzmann() const { return scale_.boltzmann; }
  std::optional<LjUnits> const& units() const { return units_; }
  LjScale const& scale() const { return scale_; }
  Domain domain() const {
    return {.rho_min = 0,
            .rho_max = R::rho_max * scale_.density,
            .T_min = R::T_min(R::rho_max) * scale_.temperature,
            .T_max = R::T_max * scale_.temperature,
            .edge = std::string(R::edge)};
  }

 private:
  std::optional<LjUnits> units_;
  LjScale scale_;
};

} // namespace mesobridge::fitting
