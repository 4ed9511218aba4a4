#include "fitting/eos/evaluate.hpp"
#include "unit/fitting/random_states.hpp"
#include <gtest/gtest.h>

namespace mesobridge::fitting::test {
namespace {

using Complex = std::complex<double>;
constexpr int states = 10000, many_states = 1000000;
constexpr double tolerance = 1e-10;

/// Derivatives by complex steps: exact to round-off, no differences are formed.
template <class E>
struct ComplexStep {
  E const& eos;
  double rho, T;
  static constexpr double step = 1e-30;

  template <class F>
  double d_dT(F&& f) const {
    auto const isochore = eos.isochore(Complex(rho));
    return f(isochore, Complex(T, step * T)).imag() / (step * T);
  }
  template <class F>
  double d_drho(F&& f) const {
    auto const isochore = eos.isochore(Complex(rho, step * rho));
    return f(isochore, Complex(T)).imag() / (step * rho);
  }
};

/// The largest violation of each identity over random states of one model.
struct Worst {
  double s = 0, P = 0, c_v = 0, c_v_slope = 0, P_slope = 0, maxwell = 0, P_density_slope = 0, isentrope = 0;
  int cases = 0;
  double largest() const {
    return std::max({s, P, c_v, c_v_slope, P_slope, maxwell, P_density_slope, isentrope});
  }
};

template <class E>
Worst check_identities(E const& eos, int states) {
  constexpr std::uint64_t seed = 1;
  std::mt19937_64 generator(seed);
  auto const energy = [](auto const& i, Complex T) { return i.energy(T); };
  auto const entropy = [](auto const& i, Complex T) { return i.entropy(T); };
  auto const pressure = [](auto const& i, Complex T) { return i.pressure(T); };
  auto const heat_capacity = [](auto const& i, Complex T) { return i.heat_capacity(T); };
  auto const free_energy = [](auto const& i, Complex T) { return i.energy(T) - T * i.entropy(T); };
  double const k_m = eos.boltzmann() / eos.molecular_mass();
  Worst worst;
  for (; worst.cases < states; ++worst.cases) {
    auto const [rho, T] = random_state(eos, generator);
    auto const isochore = eos.isochore(rho);
    ComplexStep<E> const at{eos, rho, T};
    auto note = [](double& largest, double value) { largest = std::max(largest, value); };
    double const s = isochore.entropy(T), P = isochore.pressure(T), c_v = isochore.heat_capacity(T);
    // The terms of P may cancel, and those of its slopes: the size of the terms is the scale.
    double const P_scale = rho * k_m * std::max(T, interaction_temperature(eos)) + cold_pressure(eos, rho);
    note(worst.s, discrepancy(s, -at.d_dT(free_energy), k_m));
    note(worst.P, discrepancy(P, rho * rho * at.d_drho(free_energy), P_scale));
    note(worst.c_v, discrepancy(c_v, at.d_dT(energy), k_m));
    note(worst.c_v_slope, discrepancy(isochore.heat_capacity_slope(T), at.d_dT(heat_capacity), k_m / T));
    note(worst.P_slope, discrepancy(isochore.pressure_slope(T), at.d_dT(pressure), P_scale / T));
    note(worst.maxwell, discrepancy(at.d_dT(pressure), -rho * rho * at.d_drho(entropy), P_scale / T));
    note(worst.P_density_slope,
         discrepancy(isochore.pressure_density_slope(T), at.d_drho(pressure), P_scale / rho));
    // Along the isentrope through the state: T' = -(ds/drho)/(ds/dT), c^2 = dP/drho.
    double const T_slope = -at.d_drho(entropy) / at.d_dT(entropy), h = at.step * rho;
    double const c_2 = eos.isochore(Complex(rho, h)).pressure(Complex(T, h * T_slope)).imag() / h;
    // Near the spinodal the two terms of c^2 cancel: their own size is the scale.
    double const isothermal = std::abs(isochore.pressure_density_slope(T));
    note(worst.isentrope, discrepancy(sound_speed_squared(isochore, T), c_2, isothermal + P_scale / rho));
  }
  return worst;
}

void hold_in_every_model(int states, double tolerance) {
  std::size_t models = 0;
  for (auto const& material : materials()) {
    SCOPED_TRACE(material.name);
    auto const worst =
        std::visit([states](auto const& eos) { return check_identities(eos, states); }, material.eos);
    std::printf(
        "%-21s %d states; largest violation: s %.1e, P %.1e, c_v %.1e, dc_v/dT %.1e, dP/dT %.1e, Maxwell "
        "%.1e, dP/drho %.1e, isentrope %.1e\n",
        material.name.c_str(), worst.cases, worst.s, worst.P, worst.c_v, worst.c_v_slope, worst.P_slope,
        worst.maxwell, worst.P_density_slope, worst.isentrope);
    EXPECT_EQ(worst.cases, states);
    EXPECT_LT(worst.largest(), tolerance);
    ++models;
  }
  EXPECT_GE(models, 9u);
}

TEST(EosIdentities, HoldInEveryModel) {
  hold_in_every_model(states, tolerance);
}

TEST(Long_EosIdentities, HoldInEveryModel) {
  hold_in_every_model(many_states, 1e-9);
}

/// A model with a heat capacity that is wrong by one part in a million.
struct SlightlyWrong : LjBwr {
  using LjBwr::LjBwr;
  template <class X>
  struct WrongIsochore : BasicLjBwrIsochore<X> {
    X heat_capacity(X T) const { return 1.000001 * BasicLjBwrIsochore<X>::heat_capacity(T); }
  };
  template <class X>
  WrongIsochore<X> isochore(X rho) const {
    return {LjBwr::isochore(rho)};
  }
};

TEST(EosIdentities, AWrongHeatCapacityIsSeen) {
  EXPECT_GT(check_identities(SlightlyWrong(lj_bwr_1993), states).c_v, 1e-7);
}

} // namespace
} // namespace mesobridge::fitting::test
