#pragma once
#include "fitting/eos/evaluate.hpp"
#include "md/error.hpp"

namespace mesobridge::fitting {

/// The functions of (e, rho) of a model that defines
///   isochore(rho)                 see the Isochore concept; throws PhysicsError outside the densities,
///   require_temperature(T, rho)   throws PhysicsError outside the temperatures,
///   temperature_guess()           where inversions of e(T) and s(T) begin when nothing better is known,
///   name                          for messages.
/// A state outside the model throws PhysicsError that names it.
template <class Model>
class FromIsochore {
 public:
  double temperature(double e, double rho) const { return at(rho).temperature_from_energy(e, guess()); }
  double entropy(double e, double rho) const {
    auto const isochore = at(rho);
    return isochore.entropy(isochore.temperature_from_energy(e, guess()));
  }
  double pressure(double e, double rho) const {
    auto const isochore = at(rho);
    return isochore.pressure(isochore.temperature_from_energy(e, guess()));
  }
  double heat_capacity(double e, double rho) const {
    auto const isochore = at(rho);
    return isochore.heat_capacity(isochore.temperature_from_energy(e, guess()));
  }
  /// (dP/de)_rho / rho
  double gruneisen(double e, double rho) const {
    auto const isochore = at(rho);
    double const T = isochore.temperature_from_energy(e, guess());
    return isochore.pressure_slope(T) / (rho * isochore.heat_capacity(T));
  }
  /// Throws PhysicsError where the square is negative: beyond the spinodal there is no sound.
  double sound_speed(double e, double rho) const {
    auto const isochore = at(rho);
    double const T = isochore.temperature_from_energy(e, guess());
    double const c_2 = sound_speed_squared(isochore, T);
    if (!(c_2 >= 0))
      throw PhysicsError(
          fmt::format("{} at density {}, temperature {}: mechanically unstable, sound speed^2 = {}",
                      Model::name, rho, T, c_2));
    return std::sqrt(c_2);
  }
  double energy_from_entropy(double s, double rho) const {
    auto const isochore = at(rho);
    return isochore.energy(isochore.temperature_from_entropy(s, guess()));
  }
  double energy_from_temperature(double T, double rho) const {
    auto const isochore = at(rho);
    model().require_temperature(T, rho);
    return isochore.energy(T);
  }

 private:
  Model const& model() const { return static_cast<Model const&>(*this); }
  auto at(double rho) const { return model().isochore(rho); }
  double guess() const { return model().temperature_guess(); }
};

} // namespace mesobridge::fitting
