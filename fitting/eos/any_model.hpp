#pragma once
#include "fitting/eos/list.hpp"

namespace mesobridge::fitting {

/// An isochore of any model of the list.
class AnyIsochore {
 public:
  AnyIsochore(AnyEos const& any, double rho)
      : isochore_(std::visit([rho](auto const& eos) { return Variant(eos.isochore(rho)); }, any)) {}

  double density() const {
    return of([](auto const& at) { return at.density(); });
  }
  double energy(double T) const {
    return of([T](auto const& at) { return at.energy(T); });
  }
  double entropy(double T) const {
    return of([T](auto const& at) { return at.entropy(T); });
  }
  double pressure(double T) const {
    return of([T](auto const& at) { return at.pressure(T); });
  }
  double heat_capacity(double T) const {
    return of([T](auto const& at) { return at.heat_capacity(T); });
  }
  double heat_capacity_slope(double T) const {
    return of([T](auto const& at) { return at.heat_capacity_slope(T); });
  }
  double pressure_slope(double T) const {
    return of([T](auto const& at) { return at.pressure_slope(T); });
  }
  double pressure_density_slope(double T) const {
    return of([T](auto const& at) { return at.pressure_density_slope(T); });
  }
  double temperature_from_energy(double e, double T_guess) const {
    return of([=](auto const& at) { return at.temperature_from_energy(e, T_guess); });
  }
  double temperature_from_entropy(double s, double T_guess) const {
    return of([=](auto const& at) { return at.temperature_from_entropy(s, T_guess); });
  }

 private:
  template <class E>
  using Of = decltype(std::declval<E const&>().isochore(1.0));
  using Variant =
      std::variant<BasicLinearIsochore<double>, Of<IdealGas>, Of<LjBwr>, Of<LjKolafaNezbeda>, Of<LjThol>>;

  template <class F>
  double of(F&& f) const {
    return std::visit(f, isochore_);
  }
  Variant isochore_;
};

/// Any model of the list as one type, for work on pairs of models (mixtures) that is compiled once and not
/// done for every particle.
class AnyModel {
 public:
  static constexpr std::string_view name = "model";

  explicit AnyModel(AnyEos eos) : eos_(std::move(eos)) {}

  AnyIsochore isochore(double rho) const { return {eos_, rho}; }
  double entropy(double e, double rho) const {
    return of([=](auto const& eos) { return eos.entropy(e, rho); });
  }
  double energy_from_entropy(double s, double rho) const {
    return of([=](auto const& eos) { return eos.energy_from_entropy(s, rho); });
  }
  double temperature(double e, double rho) const {
    return of([=](auto const& eos) { return eos.temperature(e, rho); });
  }
  double pressure(double e, double rho) const {
    return of([=](auto const& eos) { return eos.pressure(e, rho); });
  }
  double heat_capacity(double e, double rho) const {
    return of([=](auto const& eos) { return eos.heat_capacity(e, rho); });
  }
  double sound_speed(double e, double rho) const {
    return of([=](auto const& eos) { return eos.sound_speed(e, rho); });
  }
  double energy_from_temperature(double T, double rho) const {
    return of([=](auto const& eos) { return eos.energy_from_temperature(T, rho); });
  }
  double molecular_mass() const {
    return of([](auto const& eos) { return eos.molecular_mass(); });
  }
  double boltzmann() const {
    return of([](auto const& eos) { return eos.boltzmann(); });
  }
  Domain domain() const {
    return std::visit([](auto const& eos) { return eos.domain(); }, eos_);
  }
  AnyEos const& eos() const { return eos_; }

 private:
  template <class F>
  double of(F&& f) const {
    return std::visit(f, eos_);
  }
  AnyEos eos_;
};

static_assert(EquationOfState<AnyModel>);

} // namespace mesobridge::fitting
