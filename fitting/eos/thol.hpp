#pragma once
#include "fitting/eos/from_free_energy.hpp"
#include <array>

namespace mesobridge::fitting {

/// The Lennard-Jones fluid of Thol, Rutkai, Koester, Lustig, Span, Vrabec, J. Phys. Chem. Ref. Data 45
/// (2016) 023101, tables 2 and 3 (fitting/README.md, Eq. (F11)): delta = rho/0.31 and tau = 1.32/T,
///   A_res/T = sum_{6} n tau^t delta^d + sum_{6} n tau^t delta^d exp(-delta^l)
///           + sum_{11} n tau^t delta^d exp[-eta (delta - epsilon)^2 - beta (tau - gamma)^2].
struct Thol {
  static constexpr std::string_view name = "Thol 2016";
  static constexpr double T_max = 9, rho_max = 1.2;
  static constexpr double T_critical = 1.32, rho_critical = 0.31;
  static constexpr std::string_view edge =
      "fitted from the triple point, T* = 0.661, to T* = 9; other states are refused; inside the liquid-gas "
      "region the fluid is mechanically unstable (no sound speed), and below T* = 1.2 at 0.12 < rho* < 0.48 "
      "its wild loops (c_v of -12000 k_B) leave no unique temperature, so those states are refused too";

  /// The triple point; deep in the liquid-gas region the term with beta = 383 makes c_v negative up to
  /// T* = 1.16.
  static constexpr double T_min(double rho) { return rho > 0.12 && rho < 0.48 ? 1.2 : 0.661; }

  struct Power {
    double n, t;
    int d, l; ///< l = 0: no exponential
  };
  struct Gaussian {
    double n, t;
    int d;
    double eta, beta, gamma, epsilon;
  };
  static constexpr std::array<Power, 12> powers{{{0.005208073, 1.000, 4, 0},
                                                 {2.186252, 0.320, 1, 0},
                                                 {-2.161016, 0.505, 1, 0},
                                                 {1.4527, 0.672, 2, 0},
                                                 {-2.041792, 0.843, 2, 0},
                                                 {0.18695286, 0.898, 3, 0},
                                                 {-0.090988445, 1.294, 5, 1},
                                                 {-0.4974561, 2.590, 2, 2},
                                                 {0.10901431, 1.786, 2, 1},
                                                 {-0.80055922, 2.770, 3, 2},
                                                 {-0.568839, 1.786, 1, 2},
                                                 {-0.6208625, 1.205, 1, 1}}};
  static constexpr std::array<Gaussian, 11> gaussians{{
      {-1.4667177, 2.830, 1, 2.067, 0.625, 0.71, 0.2053},
      {1.891469, 2.548, 1, 1.522, 0.638, 0.86, 0.409},
      {-0.1383701, 4.650, 2, 8.82, 3.91, 1.94, 0.6},
      {-0.3869645, 1.385, 3, 1.722, 0.156, 1.48, 1.203},
      {0.1265702, 1.460, 3, 0.679, 0.157, 1.49, 1.829},
      {0.605781, 1.351, 2, 1.883, 0.153, 1.945, 1.397},
      {1.179189, 0.660, 1, 3.925, 1.16, 3.02, 1.39},
      {-0.47732679, 1.496, 2, 2.461, 1.73, 1.11, 0.539},
      {-9.9218575, 1.830, 3, 28.2, 383, 1.17, 0.934},
      {-0.5747932, 1.616, 1, 0.753, 0.112, 1.33, 2.369},
      {0.003772923, 4.970, 1, 0.82, 0.119, 0.24, 2.43},
  }};

  /// Not inlined: it is long, and every function of an isochore calls it.
  template <class X>
  [[gnu::noinline]] static X residual(X const& rho, X const& T) {
    using std::exp, std::log;
    X const delta = rho / rho_critical, tau = T_critical / T, log_tau = log(tau);
    std::array<X, 6> power{X(1.0), delta};
    for (int d = 2; d < 6; ++d)
      power[d] = power[d - 1] * delta;
    std::array<X, 3> const damping{X(1.0), exp(-delta), exp(-power[2])};
    X alpha = 0.0;
    for (auto const& k : powers)
      alpha += k.n * (exp(k.t * log_tau) * power[k.d] * damping[k.l]);
    for (auto const& k : gaussians) {
      X const x = delta - k.epsilon, y = tau - k.gamma;
      alpha += k.n * (exp(k.t * log_tau - k.eta * (x * x) - k.beta * (y * y)) * power[k.d]);
    }
    return T * alpha;
  }
};

using LjThol = FromFreeEnergy<Thol>;
static_assert(EquationOfState<LjThol>);

} // namespace mesobridge::fitting
