#pragma once
#include "fitting/eos/temperature_series.hpp"
#include <array>
#include <cmath>
#include <utility>

namespace mesobridge::fitting::bwr {

/// Functions of density in the modified Benedict-Webb-Rubin free energy (theory sheet, section 4):
/// rho^i/i for i = 1...8, then G_1 ... G_6 with G_i' = F rho^(2i-1), F = exp(-gamma rho^2).
inline constexpr int polynomials = 8;
inline constexpr int exponentials = 6;
inline constexpr int densities = polynomials + exponentials;
inline constexpr int parameters = 32;

using Parameters = std::array<double, parameters>;

/// A_res = sum_j x_j f_density(rho) T^power; the power is an index into TemperatureSeries.
struct Term {
  int density, power;
};

enum Power { linear, root, constant, inverse, inverse_2, inverse_3, inverse_4 };

/// x1 ... x32 in the order of Johnson, Zollweg and Gubbins, Mol. Phys. 78 (1993) 591, tables 5-7.
inline constexpr std::array<Term, parameters> table{{
    {0, linear},     {0, root},       {0, constant},   {0, inverse},   {0, inverse_2}, // a1
    {1, linear},     {1, constant},   {1, inverse},    {1, inverse_2},                 // a2
    {2, linear},     {2, constant},   {2, inverse},                                    // a3
    {3, constant},                                                                     // a4
    {4, inverse},    {4, inverse_2},                                                   // a5
    {5, inverse},                                                                      // a6
    {6, inverse},    {6, inverse_2},                                                   // a7
    {7, inverse_2},                                                                    // a8
    {8, inverse_2},  {8, inverse_3},                                                   // b1
    {9, inverse_2},  {9, inverse_4},                                                   // b2
    {10, inverse_2}, {10, inverse_3},                                                  // b3
    {11, inverse_2}, {11, inverse_4},                                                  // b4
    {12, inverse_2}, {12, inverse_3},                                                  // b5
    {13, inverse_2}, {13, inverse_3}, {13, inverse_4},                                 // b6
}};

/// The density functions f with p = rho^2 f' and q = dp/drho.
template <class X>
struct DensityFunctions {
  std::array<X, densities> f, p, q;
};

/// G_6 by its series in z = gamma rho^2 < 1, where the upward recursion would lose digits to cancellation:
///   G_6 = (rho^12 F / 2) sum_k z^k 5!/(6+k)!
template <class X>
X last_exponential_by_series(X rho_12, X F, X z) {
  constexpr int last = 16; // z^17 5!/23! < 1e-20
  X sum = 1.0;
  for (int k = last; k > 0; --k)
    sum = 1.0 + sum * z * (1.0 / (6.0 + k));
  return rho_12 * F * sum * (1.0 / 12.0);
}

template <class X>
DensityFunctions<X> density_functions(X rho, double gamma) {
  DensityFunctions<X> basis;
  X power = rho; // rho^i
  for (int i = 1; i <= polynomials; ++i) {
    basis.f[i - 1] = power * (1.0 / i);
    basis.q[i - 1] = (i + 1.0) * power;
    power *= rho;
    basis.p[i - 1] = power;
  }
  X const rho_2 = rho * rho, z = gamma * rho_2, F = std::exp(-z);
  X* const G = basis.f.data() + polynomials - 1; // G[1] ... G[6]
  X even = F;                                    // F rho^(2i-2)
  std::array<X, exponentials + 1> even_powers;
  for (int i = 1; i <= exponentials; ++i) {
    even_powers[i] = even;
    even *= rho_2;
    basis.p[polynomials + i - 1] = even * rho;
    basis.q[polynomials + i - 1] = even * (2.0 * i + 1.0 - 2.0 * z);
  }
  double const half = 0.5 / gamma;
  if (real_part(z) < 1.0) {
    G[exponentials] = last_exponential_by_series(X(rho_2 * rho_2 * rho_2 * rho_2 * rho_2 * rho_2), F, z);
    for (int i = exponentials; i > 1; --i)
      G[i - 1] = (2.0 * gamma * G[i] + even_powers[i]) * (0.5 / (i - 1));
  } else {
    G[1] = (1.0 - F) * half;
    for (int i = 2; i <= exponentials; ++i)
      G[i] = (2.0 * (i - 1) * G[i - 1] - even_powers[i]) * half;
  }
  return basis;
}

/// sum_j x_j f_j gathered by powers of temperature; unrolled at compile time.
template <class X>
TemperatureSeries<X> gather(Parameters const& x, std::array<X, densities> const& f) {
  TemperatureSeries<X> series;
  [&]<std::size_t... j>(std::index_sequence<j...>) {
    ((series.c[table[j].power] += x[j] * f[table[j].density]), ...);
  }
  (std::make_index_sequence<parameters>{});
  return series;
}

} // namespace mesobridge::fitting::bwr
