#pragma once
#include "fitting/eos/temperature_series.hpp"
#include <array>
#include <cmath>

namespace mesobridge::fitting {

/// A function's value and derivatives with respect to one variable, as the coefficients of its Taylor series
/// up to order N: c[k] = f^(k)/k!. A formula that is a template on its number type gives its own derivatives,
/// exact to round-off, when it is evaluated with Taylor::variable(x) in place of x. X is double, a complex
/// number, or another Taylor for mixed derivatives.
template <class X, int N>
struct Taylor {
  std::array<X, N + 1> c{};

  Taylor() = default;
  Taylor(double constant) : c{X(constant)} {}
  explicit Taylor(X const& constant) requires(!std::same_as<X, double>) : c{constant} {}

  static Taylor variable(X const& at) {
    Taylor x;
    x.c[0] = at;
    if constexpr (N > 0)
      x.c[1] = X(1.0);
    return x;
  }
};

template <class X, int N>
double real_part(Taylor<X, N> const& a) {
  return real_part(a.c[0]);
}

template <class X, int N>
Taylor<X, N>& operator+=(Taylor<X, N>& a, Taylor<X, N> const& b) {
  for (int k = 0; k <= N; ++k)
    a.c[k] += b.c[k];
  return a;
}
template <class X, int N>
Taylor<X, N> operator+(Taylor<X, N> a, Taylor<X, N> const& b) {
  return a += b;
}
template <class X, int N>
Taylor<X, N> operator-(Taylor<X, N> a) {
  for (auto& coefficient : a.c)
    coefficient = -coefficient;
  return a;
}
template <class X, int N>
Taylor<X, N> operator-(Taylor<X, N> a, Taylor<X, N> const& b) {
  for (int k = 0; k <= N; ++k)
    a.c[k] = a.c[k] - b.c[k];
  return a;
}
template <class X, int N>
Taylor<X, N> operator*(Taylor<X, N> const& a, Taylor<X, N> const& b) {
  Taylor<X, N> product;
  for (int k = 0; k <= N; ++k)
    for (int j = 0; j <= k; ++j)
      product.c[k] += a.c[j] * b.c[k - j];
  return product;
}
/// From a = q b, coefficient by coefficient.
template <class X, int N>
Taylor<X, N> operator/(Taylor<X, N> const& a, Taylor<X, N> const& b) {
  Taylor<X, N> quotient;
  for (int k = 0; k <= N; ++k) {
    X rest = a.c[k];
    for (int j = 0; j < k; ++j)
      rest = rest - quotient.c[j] * b.c[k - j];
    quotient.c[k] = rest / b.c[0];
  }
  return quotient;
}

template <class X, int N>
Taylor<X, N> operator+(Taylor<X, N> a, double b) {
  a.c[0] = a.c[0] + b;
  return a;
}
template <class X, int N>
Taylor<X, N> operator+(double a, Taylor<X, N> const& b) {
  return b + a;
}
template <class X, int N>
Taylor<X, N> operator-(Taylor<X, N> const& a, double b) {
  return a + (-b);
}
template <class X, int N>
Taylor<X, N> operator-(double a, Taylor<X, N> const& b) {
  return -b + a;
}
template <class X, int N>
Taylor<X, N> operator*(Taylor<X, N> a, double b) {
  for (auto& coefficient : a.c)
    coefficient = coefficient * b;
  return a;
}
template <class X, int N>
Taylor<X, N> operator*(double a, Taylor<X, N> const& b) {
  return b * a;
}
template <class X, int N>
Taylor<X, N> operator/(Taylor<X, N> const& a, double b) {
  return a * (1 / b);
}
template <class X, int N>
Taylor<X, N> operator/(double a, Taylor<X, N> const& b) {
  return Taylor<X, N>(a) / b;
}

/// The series whose coefficients follow from those before: c_0 = first, c_k = next(c, k).
template <int N, class X, class Next>
Taylor<X, N> by_recursion(X const& first, Next const& next) {
  Taylor<X, N> f;
  f.c[0] = first;
  for (int k = 1; k <= N; ++k)
    f.c[k] = next(f.c, k);
  return f;
}

/// From f' = a' f.
template <class X, int N>
Taylor<X, N> exp(Taylor<X, N> const& a) {
  using std::exp;
  return by_recursion<N>(X(exp(a.c[0])), [&](auto const& f, int k) {
    X sum{};
    for (int j = 1; j <= k; ++j)
      sum += a.c[j] * f[k - j] * double(j);
    return sum * (1.0 / k);
  });
}

/// From a f' = a'.
template <class X, int N>
Taylor<X, N> log(Taylor<X, N> const& a) {
  using std::log;
  return by_recursion<N>(X(log(a.c[0])), [&](auto const& f, int k) {
    X rest = a.c[k] * double(k);
    for (int j = 1; j < k; ++j)
      rest = rest - f[j] * a.c[k - j] * double(j);
    return rest / a.c[0] * (1.0 / k);
  });
}

/// From 2 f f' = a'.
template <class X, int N>
Taylor<X, N> sqrt(Taylor<X, N> const& a) {
  using std::sqrt;
  return by_recursion<N>(X(sqrt(a.c[0])), [&](auto const& f, int k) {
    X rest = a.c[k];
    for (int j = 1; j < k; ++j)
      rest = rest - f[j] * f[k - j];
    return rest / f[0] * 0.5;
  });
}

} // namespace mesobridge::fitting
