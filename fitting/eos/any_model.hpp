#pragma once
#include "fitting/eos/list.hpp"

namespace mesobridge::fitting {

/// An isochore of any model of the list.
class AnyIsochore {
 public:
  /// Throws PhysicsError outside the model's densities.
  AnyIsochore(AnyEos const& any, double rho);

  double density() const;
  double energy(double T) const;
  double entropy(double T) const;
  double pressure(double T) const;
  double heat_capacity(double T) const;
  double heat_capacity_slope(double T) const;
  double pressure_slope(double T) const;
  double pressure_density_slope(double T) const;
  double temperature_from_energy(double e, double T_guess) const;
  double temperature_from_entropy(double s, double T_guess) const;

 private:
  template <class E>
  using Of = decltype(std::declval<E const&>().isochore(1.0));

  std::variant<BasicLinearIsochore<double>, Of<IdealGas>, Of<LjBwr>, Of<LjKolafaNezbeda>, Of<LjThol>>
      isochore_;
};

/// Any model of the list as one type, for work on pairs of models (mixtures) that is compiled once and not
/// done for every particle. Where no isochores are asked for, Fluid is the simpler one.
class AnyModel {
 public:
  static constexpr std::string_view name = "model";

  explicit AnyModel(AnyEos eos) : eos_(std::move(eos)) {}

  AnyIsochore isochore(double rho) const { return {eos_, rho}; }
  double entropy(double e, double rho) const;
  double energy_from_entropy(double s, double rho) const;
  double temperature(double e, double rho) const;
  double pressure(double e, double rho) const;
  double heat_capacity(double e, double rho) const;
  double sound_speed(double e, double rho) const;
  double energy_from_temperature(double T, double rho) const;
  double molecular_mass() const;
  double boltzmann() const;
  Domain domain() const;
  AnyEos const& eos() const { return eos_; }

 private:
  AnyEos eos_;
};

static_assert(EquationOfState<AnyModel>);

} // namespace mesobridge::fitting
