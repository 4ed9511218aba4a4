#pragma once
#include "fitting/fit_eos.hpp"
#include <random>

namespace mesobridge::fitting::test {

/// Synthetic measurements of a model: every measured quantity, and every given one with a standard error,
/// gets normal noise. The stated errors of measured ones are 1 % of them; the noise is that, unless it is
/// told otherwise.
template <FittableModel Model>
class Laboratory {
 public:
  Laboratory(Model const& truth, std::uint64_t seed) : truth_(truth), generator_(seed) {}

  double stated_error = 0.01;   ///< relative
  double noise_over_stated = 1; ///< how much larger the noise is than is stated
  double P_e_correlation = 0;   ///< of the errors of P and e

  /// Measures these quantities where the observation's given ones lead to.
  void measure(Observation observation, std::vector<Quantity> const& quantities) {
    auto const state = reach(truth_, observation, 0);
    double previous = 0; // deviation of the quantity before, which the next one's is correlated with
    for (auto const quantity : quantities) {
      double const value = quantity_of(truth_, state, quantity, 0), se = stated_error * std::abs(value);
      double const r = observation.measured.empty() ? 0 : P_e_correlation;
      previous = r * previous + std::sqrt(1 - r * r) * normal_(generator_);
      observation.measured.push_back({quantity, value + noise_over_stated * se * previous, se});
    }
    for (auto& datum : observation.given)
      datum.value += datum.se * normal_(generator_);
    observation.P_e_correlation = P_e_correlation;
    observation.origin = fmt::format("synthetic {}", data.size());
    data.push_back(std::move(observation));
  }

  void measure_states(std::vector<double> const& densities, std::vector<double> const& temperatures,
                      std::vector<Quantity> const& quantities) {
    for (double const rho : densities)
      for (double const T : temperatures)
        measure({.given = {{Quantity::rho, rho}, {Quantity::T, T}}}, quantities);
  }

  /// v_P_error: relative standard error of v_P.
  void measure_shocks(double rho_0, double T_0, std::vector<double> const& v_P,
                      std::vector<Quantity> const& quantities, double v_P_error = 0) {
    for (double const v : v_P)
      measure({.path = DataPath::hugoniot,
               .start = StartState{.rho = rho_0, .T = T_0},
               .given = {{Quantity::v_P, v, v_P_error * v}}},
              quantities);
  }

  std::vector<Observation> data;

 private:
  Model truth_;
  std::mt19937_64 generator_;
  std::normal_distribution<double> normal_;
};

/// n values from `first` to `last`.
inline std::vector<double> spaced(double first, double last, int n) {
  std::vector<double> values;
  for (int i = 0; i < n; ++i)
    values.push_back(first + (last - first) * i / (n - 1));
  return values;
}

} // namespace mesobridge::fitting::test
