#pragma once
#include "fitting/eos/list.hpp"
#include <algorithm>
#include <random>

namespace mesobridge::fitting::test {

struct RandomState {
  double rho, T;
};

/// The density that a model without a highest one is made for.
template <class E>
double typical_density(E const& eos) {
  if constexpr (requires { eos.parameters().rho_0; })
    return eos.parameters().rho_0;
  else
    return 1000;
}

template <class E>
bool has_state(E const& eos, RandomState const& state) {
  try {
    eos.energy_from_temperature(state.T, state.rho);
    return true;
  } catch (PhysicsError const&) {
    return false;
  }
}

/// A state from all over a model's domain: log-uniform in temperature from a tenth of the natural unit, so
/// that the low-temperature continuation is visited too; uniform in density.
template <class E>
RandomState random_state(E const& eos, std::mt19937_64& generator) {
  auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(generator);
  };
  auto const domain = eos.domain();
  double const rho_max = std::isfinite(domain.rho_max) ? domain.rho_max : 3 * typical_density(eos),
               T_max = std::isfinite(domain.T_max) ? domain.T_max : 1e5;
  for (;;) {
    RandomState const state{uniform(1e-3, 1) * rho_max, T_max * std::pow(1e-3, uniform(0, 1))};
    if (has_state(eos, state))
      return state;
  }
}

/// The temperature below which a model's thermal scale k_B T no longer measures the terms that cancel in P
/// and its derivatives: the well depth of Lennard-Jones models, none for others.
template <class E>
double interaction_temperature(E const& eos) {
  if constexpr (requires { eos.scale(); })
    return eos.scale().temperature;
  else
    return 0;
}

/// The size of the terms that cancel in the pressure at T = 0: the bulk modulus of a reference curve.
template <class E>
double cold_pressure(E const& eos, double rho) {
  if constexpr (requires { eos.law(rho); })
    return std::abs(eos.law(rho).P) + rho * std::abs(eos.law(rho).P_slope);
  else
    return 0;
}

/// |a - b| in units of the larger of |a|, |b| and a natural scale of the quantity.
inline double discrepancy(double a, double b, double scale) {
  return std::abs(a - b) / std::max({std::abs(a), std::abs(b), scale});
}

} // namespace mesobridge::fitting::test
