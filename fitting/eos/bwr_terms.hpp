#pragma once
#include "fitting/eos/temperature_series.hpp"
#include <array>
#include <cmath>
#include <type_traits>

namespace mesobridge::fitting::bwr {

/// Functions of density in the modified Benedict-Webb-Rubin free energy (fitting/README.md, Eq. (F8)):
/// rho^i/i for i = 1...8, then G_1 ... G_6 with G_i' = F rho^(2i-1), F = exp(-gamma rho^2).
inline constexpr int polynomials = 8;
inline constexpr int exponentials = 6;
inline constexpr int densities = polynomials + exponentials;
inline constexpr int parameters = 32;
inline constexpr int series_terms = TemperatureSeries<double>::terms;

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

/// G_1 ... G_6 for z = gamma rho^2 >= 1:  G_i = (i-1)!/(2 gamma^i) [1 - F sum_{k<i} z^k/k!].
/// The sums do not wait for the exponential, which makes this faster than the published recursion.
template <class X>
void exponential_functions(X z, X F, double gamma, X* G) {
  double const inverse = 1 / gamma;
  double factor = 0.5 * inverse;
  X sum = 1.0, term = 1.0;
  for (int i = 1; i <= exponentials; ++i) {
    G[i - 1] = factor * (1.0 - F * sum);
    factor *= i * inverse;
    term *= z * (1.0 / i);
    sum += term;
  }
}

/// The same for z < 1, where the difference above would lose digits: G_6 by its series and the recursion
/// downward,
///   G_6 = (rho^12 F / 2) sum_k z^k 5!/(6+k)!,   G_{i-1} = (2 gamma G_i + F rho^(2i-2))/(2(i-1)).
template <class X>
void exponential_functions_at_low_density(X rho_2, X z, X F, double gamma, X* G) {
  constexpr int last = 16; // z^17 5!/23! < 1e-20
  X sum = 1.0;
  for (int k = last; k > 0; --k)
    sum = 1.0 + sum * z * (1.0 / (exponentials + k));
  std::array<X, exponentials + 1> F_powers{F}; // F rho^(2i)
  for (int i = 1; i <= exponentials; ++i)
    F_powers[i] = F_powers[i - 1] * rho_2;
  G[exponentials - 1] = F_powers[exponentials] * sum * (0.5 / exponentials);
  for (int i = exponentials; i > 1; --i)
    G[i - 2] = (2.0 * gamma * G[i - 1] + F_powers[i - 1]) * (0.5 / (i - 1));
}

/// Powers rho^1 ... rho^13 by products of halves (a short chain of dependent multiplications).
template <class X>
std::array<X, 2 * exponentials + 2> density_powers(X rho) {
  std::array<X, 2 * exponentials + 2> power{X(1.0), rho};
  for (std::size_t n = 2; n < power.size(); ++n)
    power[n] = power[n / 2] * power[n - n / 2];
  return power;
}

/// Whichever of the two keeps the digits; a pack that lies on both sides takes each lane from its own.
template <class X>
void careful_exponential_functions(X rho_2, X z, X F, double gamma, X* G) {
  if (real_part(z) < 1.0)
    exponential_functions_at_low_density(rho_2, z, F, gamma, G);
  else
    exponential_functions(z, F, gamma, G);
}
inline void careful_exponential_functions(Pack rho_2, Pack z, Pack F, double gamma, Pack* G) {
  PackMask const low = z.v < 1.0;
  if (!all_of(low))
    exponential_functions(z, F, gamma, G);
  if (all_of(~low))
    return;
  std::array<Pack, exponentials> at_low_density;
  exponential_functions_at_low_density(rho_2, z, F, gamma, at_low_density.data());
  for (int i = 0; i < exponentials; ++i)
    G[i] = select(low, at_low_density[i], G[i]);
}

template <class X>
DensityFunctions<X> density_functions(X rho, double gamma) {
  using std::exp;
  DensityFunctions<X> basis;
  auto const power = density_powers(rho);
  X const z = gamma * power[2], F = exp(-z);
  for (int i = 1; i <= polynomials; ++i) {
    basis.f[i - 1] = power[i] * (1.0 / i);
    basis.p[i - 1] = power[i + 1];
    basis.q[i - 1] = (i + 1.0) * power[i];
  }
  for (int i = 1; i <= exponentials; ++i) {
    basis.p[polynomials + i - 1] = F * power[2 * i + 1];
    basis.q[polynomials + i - 1] = F * power[2 * i] * (2.0 * i + 1.0 - 2.0 * z);
  }
  X* const G = basis.f.data() + polynomials;
  careful_exponential_functions(power[2], z, F, gamma, G);
  return basis;
}

/// The parameters as a matrix [density function][power of T], so that collapsing them at one density is three
/// small products of a vector with a matrix. The rows are vectors of the compiler (GCC, Clang): left to
/// itself, it keeps the sums in memory and takes four times as long.
struct Matrix {
  using Row = double __attribute__((vector_size(series_terms * sizeof(double))));

  explicit Matrix(Parameters const& x) {
    for (int j = 0; j < parameters; ++j)
      rows[table[j].density][table[j].power] = x[j];
  }
  std::array<Row, densities> rows{};
};

/// sum_d f_d(rho) M_d: the free energy (or p, or q) at one density as a series in temperature.
template <class X>
TemperatureSeries<X> gather(Matrix const& M, std::array<X, densities> const& f) {
  TemperatureSeries<X> series;
  if constexpr (std::is_same_v<X, double>) {
    Matrix::Row even{}, odd{};
    for (int d = 0; d < densities; d += 2) {
      even += f[d] * M.rows[d];
      odd += f[d + 1] * M.rows[d + 1];
    }
    Matrix::Row const sum = even + odd;
    for (int m = 0; m < series_terms; ++m)
      series.c[m] = sum[m];
  } else {
    series.c.fill(0.0);
    for (auto const& [d, m] : table)
      series.c[m] += f[d] * M.rows[d][m];
  }
  return series;
}

} // namespace mesobridge::fitting::bwr
