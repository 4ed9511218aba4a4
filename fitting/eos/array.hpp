#pragma once
#include "fitting/eos/linear_isochore.hpp"
#include "fitting/simd/pack.hpp"
#include <algorithm>
#include <span>

namespace mesobridge::fitting {

/// States by energy and density; equally long.
struct EnergyStates {
  std::span<double const> e, rho;
};

/// Where their temperatures, pressures and heat capacities go; as long as the states.
struct ThermalResponse {
  std::span<double> T, P, C;
};

/// T, P and c_v of one state after another. Throws PhysicsError at the first that is outside the model; what
/// the output holds is then undefined.
template <EquationOfState E>
void evaluate(E const& eos, EnergyStates const& in, ThermalResponse const& out) {
  double T_guess = 1;
  for (std::size_t i = 0; i < in.e.size(); ++i) {
    auto const isochore = eos.isochore(in.rho[i]);
    double const T = isochore.temperature_from_energy(in.e[i], T_guess);
    out.T[i] = T_guess = T;
    out.P[i] = isochore.pressure(T);
    out.C[i] = isochore.heat_capacity(T);
  }
}

namespace array {

/// One pack of states; one of them outside the model sends all through the careful way, which names it.
template <LinearModel Model>
void evaluate_pack(Model const& eos, double const* e, double const* rho, double* T, double* P) {
  Pack const density = Pack::load(rho);
  auto const law = eos.law(density);
  double const c_v = eos.c_v();
  Pack const heat = Pack::load(e) - law.E; // c_v T
  Pack const temperature = heat / c_v;
  temperature.store(T);
  (law.P + density * law.Gamma * heat).store(P);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (all_between_zero_and(temperature, infinity) && all_between_zero_and(density, eos.rho_max()))
    return;
  for (int lane = 0; lane < Pack::size; ++lane) {
    auto const isochore = eos.isochore(rho[lane]);
    T[lane] = isochore.temperature_from_energy(e[lane], 1);
    P[lane] = isochore.pressure(T[lane]);
  }
}

} // namespace array

/// The same for models whose isochores are linear, a register full of states at a time.
template <EquationOfState E>
requires LinearModel<E>
void evaluate(E const& eos, EnergyStates const& in, ThermalResponse const& out) {
  std::size_t const n = in.e.size(), whole = n - n % Pack::size;
  for (std::size_t i = 0; i < whole; i += Pack::size)
    array::evaluate_pack(eos, &in.e[i], &in.rho[i], &out.T[i], &out.P[i]);
  if (whole < n) { // the rest, filled up with copies of the last state
    double e[Pack::size], rho[Pack::size], T[Pack::size], P[Pack::size];
    for (std::size_t lane = 0; lane < Pack::size; ++lane) {
      std::size_t const i = std::min(whole + lane, n - 1);
      e[lane] = in.e[i], rho[lane] = in.rho[i];
    }
    array::evaluate_pack(eos, e, rho, T, P);
    std::copy_n(T, n - whole, &out.T[whole]);
    std::copy_n(P, n - whole, &out.P[whole]);
  }
  std::ranges::fill(out.C, eos.c_v());
}

} // namespace mesobridge::fitting
