#pragma once
#include <array>
#include <cmath>
#include <cstddef>

namespace mesobridge::fitting::quintic {

/// Quintic B-splines on uniform knots: in each cell six of them, at the coordinate 0 <= t <= 1 of the cell,
/// each a polynomial in t. A sum of them with any coefficients has four continuous derivatives.
inline constexpr int order = 6;
inline constexpr int lanes = 8; ///< order, padded to the vector width with zeros

/// Six numbers as one vector of the compiler (GCC, Clang).
using Row = double __attribute__((vector_size(lanes * sizeof(double))));

/// power_of_t[k][j]: coefficient of t^k in the j-th spline, times 120.
inline constexpr std::array<std::array<double, lanes>, order> power_of_t{{
    {1, 26, 66, 26, 1, 0},
    {-5, -50, 0, 50, 5, 0},
    {10, 20, -60, 20, 10, 0},
    {-10, 20, 0, -20, 10, 0},
    {5, -20, 30, -20, 5, 0},
    {-1, 5, -10, 10, -5, 1},
}};

/// The coefficient of t^k in the d-th derivative of the j-th spline.
template <int d>
inline constexpr auto derivative_table = [] {
  std::array<std::array<double, lanes>, order - d> table{};
  for (int k = 0; k < order - d; ++k)
    for (int j = 0; j < order; ++j) {
      double c = power_of_t[k + d][j] / 120;
      for (int m = k + 1; m <= k + d; ++m)
        c *= m;
      table[k][j] = c;
    }
  return table;
}();

inline Row row(double const* from) {
  Row r;
  __builtin_memcpy(&r, from, sizeof r);
  return r;
}

/// The d-th derivatives, with respect to t, of the six splines.
template <int d = 0>
Row weights(double t) {
  constexpr auto const& table = derivative_table<d>;
  Row sum = row(table[order - d - 1].data());
  for (int k = order - d - 2; k >= 0; --k)
    sum = sum * t + row(table[k].data());
  return sum;
}

inline double dot(Row a, Row b) {
  Row const p = a * b; // the last two lanes are zero
  return ((p[0] + p[1]) + (p[2] + p[3])) + (p[4] + p[5]);
}

/// The same one by one, for any number type.
template <int d = 0, class X>
std::array<X, order> weights_of(X t) {
  constexpr auto const& table = derivative_table<d>;
  std::array<X, order> w;
  for (int j = 0; j < order; ++j) {
    w[j] = table[order - d - 1][j];
    for (int k = order - d - 2; k >= 0; --k)
      w[j] = w[j] * t + table[k][j];
  }
  return w;
}

/// `cells` equal cells between low and high. Its splines have cells + 5 coefficients; the cell i sees those
/// from i to i + 5.
struct Axis {
  double low, high;
  int cells;

  double width() const { return (high - low) / cells; }
  int coefficients() const { return cells + order - 1; }
  struct Place {
    int cell;
    double t;
  };
  /// For low <= x <= high.
  Place place(double x) const {
    double const c = (x - low) * (cells / (high - low));
    int const cell = c < cells - 1 ? static_cast<int>(c) : cells - 1;
    return {cell, c - cell};
  }
  /// Where to interpolate: the knots, and the middles of the two cells at each end, which takes the place of
  /// end conditions.
  double site(int i) const {
    constexpr std::array<double, 4> first{0, 0.5, 1, 1.5};
    int const last = coefficients() - 1;
    if (i < 4)
      return low + width() * first[i];
    return i > last - 4 ? high - width() * first[last - i] : low + width() * (i - 2);
  }
};

} // namespace mesobridge::fitting::quintic
