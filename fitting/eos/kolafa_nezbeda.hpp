#pragma once
#include <cmath>
#include <numbers>

namespace mesobridge::fitting {

/// The equation of state of Kolafa and Nezbeda, Fluid Phase Equilib. 100, 1 (1994), for the whole
/// Lennard-Jones fluid up to T* = 20: independent of the BWR form and, unlike the 1993 coefficients of that
/// (fitted up to T* = 6), good in all of the default region. Residual Helmholtz energy per atom, Eqs.
/// (26)-(30).
inline double kolafa_nezbeda_residual(double rho, double T) {
  struct Term {
    double power;
    int order;
    double value;
  };
  constexpr Term terms[] = {
      {0, 2, 2.01546797},      {0, 3, -28.17881636},   {0, 4, 28.28313847},      {0, 5, -10.42402873},
      {-0.5, 2, -19.58371655}, {-0.5, 3, 75.62340289}, {-0.5, 4, -120.70586598}, {-0.5, 5, 93.92740328},
      {-0.5, 6, -27.37737354}, {-1, 2, 29.34470520},   {-1, 3, -112.35356937},   {-1, 4, 170.64908980},
      {-1, 5, -123.06669187},  {-1, 6, 34.42288969},   {-2, 2, -13.37031968},    {-2, 3, 65.38059570},
      {-2, 4, -115.09233113},  {-2, 5, 88.91973082},   {-2, 6, -25.62099890}};
  double const root = std::sqrt(T), i = 1 / root;
  double const d =
      -0.063920968 * std::log(T) + 0.011117524 / T - 0.076383859 / root + 1.080142248 + 0.000693129 * root;
  double const eta = std::numbers::pi / 6 * rho * d * d * d;
  double const spheres =
      5.0 / 3 * std::log(1 - eta) + eta * (34 - 33 * eta + 4 * eta * eta) / (6 * (1 - eta) * (1 - eta));
  double const virial =
      (((((-0.58544978 * i + 0.43102052) * i + 0.87361369) * i - 4.13749995) * i + 2.90616279) * i -
       7.02181962) /
          T +
      0.02459877;
  double sum = T * spheres + rho * T * virial * std::exp(-1.92907278 * rho * rho);
  for (Term const& term : terms)
    sum += term.value * std::pow(T, term.power) * std::pow(rho, term.order);
  return sum;
}

/// Five-point derivative, good to about 1e-9 here.
double five_point(auto&& f, double x) {
  double const h = 1e-3 * x;
  return (8 * (f(x + h) - f(x - h)) - (f(x + 2 * h) - f(x - 2 * h))) / (12 * h);
}

inline double kolafa_nezbeda_pressure(double rho, double T) {
  return rho * T + rho * rho * five_point([&](double r) { return kolafa_nezbeda_residual(r, T); }, rho);
}

/// Residual energy per atom; the whole energy is 3T/2 more.
inline double kolafa_nezbeda_energy(double rho, double T) {
  return kolafa_nezbeda_residual(rho, T) -
         T * five_point([&](double t) { return kolafa_nezbeda_residual(rho, t); }, T);
}

inline double kolafa_nezbeda_heat_capacity(double rho, double T) {
  return 1.5 + five_point([&](double t) { return kolafa_nezbeda_energy(rho, t); }, T);
}

} // namespace mesobridge::fitting
