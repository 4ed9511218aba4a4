#pragma once
#include <concepts>
#include <string>

namespace mesobridge::fitting {

/// Where a model may be trusted, in the model's own units (SI, or Lennard-Jones units for reduced models).
struct Domain {
  double rho_min, rho_max;
  double T_min, T_max;
  std::string edge; ///< what happens at the edge, in words
};

/// A model at one fixed density: every thermodynamic function of temperature alone. The engine evaluates an
/// isochore many times (a particle's density is fixed while its energy fluctuates), so a model does its work
/// on the density once, in its constructor. All quantities per unit mass.
///
/// The two inversions are safeguarded Newton iterations in T which start from `T_guess` (any positive number;
/// a good one makes them cheap) and converge to round-off. They throw PhysicsError, never return a NaN, when
/// no temperature T > 0 of the model has that energy or entropy.
template <class I>
concept Isochore = requires(I const& isochore, double x, double T_guess) {
  { isochore.energy(x) } -> std::same_as<double>;              // e(T)
  { isochore.entropy(x) } -> std::same_as<double>;             // s(T)
  { isochore.pressure(x) } -> std::same_as<double>;            // P(T)
  { isochore.heat_capacity(x) } -> std::same_as<double>;       // c_v(T) = de/dT > 0
  { isochore.heat_capacity_slope(x) } -> std::same_as<double>; // dc_v/dT
  { isochore.pressure_slope(x) } -> std::same_as<double>;      // dP/dT at constant rho
  { isochore.temperature_from_energy(x, T_guess) } -> std::same_as<double>;
  { isochore.temperature_from_entropy(x, T_guess) } -> std::same_as<double>;
};

/// An equation of state is a value type that holds one fundamental relation; the rest derives from it
/// (entropy s(e, rho), pressure, temperature ... per unit mass; fitting/README.md, Eq. (F1)).
template <class E>
concept EquationOfState = requires(E const& eos, double a, double rho) {
  { eos.isochore(rho) } -> Isochore;
  { eos.entropy(a, rho) } -> std::same_as<double>;                 // s(e, rho)
  { eos.energy_from_entropy(a, rho) } -> std::same_as<double>;     // e(s, rho)
  { eos.temperature(a, rho) } -> std::same_as<double>;             // T(e, rho)
  { eos.pressure(a, rho) } -> std::same_as<double>;                // P(e, rho)
  { eos.heat_capacity(a, rho) } -> std::same_as<double>;           // c_v(e, rho)
  { eos.sound_speed(a, rho) } -> std::same_as<double>;             // c(e, rho)
  { eos.energy_from_temperature(a, rho) } -> std::same_as<double>; // e(T, rho)
  { eos.domain() } -> std::same_as<Domain>;
  { eos.molecular_mass() } -> std::same_as<double>; // mass m0 of one atom or molecule
  { eos.boltzmann() } -> std::same_as<double>;      // k_B in the model's units
};

} // namespace mesobridge::fitting
