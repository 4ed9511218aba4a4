#pragma once
#include "fitting/eos/linear_isochore.hpp"

namespace mesobridge::fitting {

/// An isochore whose energies count from elsewhere.
template <class Inner, class X>
class ShiftedIsochore : public Inner {
 public:
  ShiftedIsochore(Inner const& inner, double shift) : Inner(inner), shift_(shift) {}

  X energy(X T) const { return Inner::energy(T) + shift_; }
  double temperature_from_energy(double e, double T_guess) const {
    return Inner::temperature_from_energy(e - shift_, T_guess);
  }

 private:
  double shift_;
};

/// The model `bulk` with all energies raised by `shift` (per unit mass, in the model's units): the same
/// pressures, temperatures and entropies. It puts two models on one energy scale, the unreacted explosive and
/// its products, say.
template <EquationOfState E>
class Shifted : public FromIsochore<Shifted<E>> {
 public:
  static constexpr std::string_view name = "shifted model";

  /// Throws InputError when the shift is not finite.
  Shifted(E bulk, double shift) : bulk_(std::move(bulk)), shift_(shift) {
    require(std::isfinite(shift), "shift of the energy", shift, "must be finite");
  }

  template <class X>
  auto isochore(X rho) const {
    return ShiftedIsochore<decltype(bulk_.isochore(rho)), X>(bulk_.isochore(rho), shift_);
  }

  void require_temperature(double T, double rho) const { bulk_.energy_from_temperature(T, rho); }
  double temperature_guess() const { return 1; }
  Domain domain() const { return bulk_.domain(); }
  double molecular_mass() const { return bulk_.molecular_mass(); }
  double boltzmann() const { return bulk_.boltzmann(); }
  E const& bulk() const { return bulk_; }
  double shift() const { return shift_; }

 private:
  E bulk_;
  double shift_;
};

} // namespace mesobridge::fitting
