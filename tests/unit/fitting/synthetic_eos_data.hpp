#pragma once
#include "fitting/fit_eos.hpp"
#include <random>

namespace mesobridge::fitting::test {

/// Synthetic measurements of a model: every measured quantity gets normal noise of 1 % of itself.
template <LinearModel Model>
class Laboratory {
 public:
  Laboratory(Model const& truth, std::uint64_t seed, double relative_noise = 0.01)
      : truth_(truth), generator_(seed), relative_noise_(relative_noise) {}

  /// Measures these quantities where the observation's given ones lead to.
  void measure(Observation observation, std::vector<Quantity> const& quantities) {
    auto const state = reach(truth_, observation, 0);
    for (auto const quantity : quantities) {
      double const value = quantity_of(truth_, state, quantity, 0), se = relative_noise_ * std::abs(value);
      observation.measured.push_back({quantity, value + se * normal_(generator_), se});
    }
    observation.origin = fmt::format("synthetic {}", data.size());
    data.push_back(std::move(observation));
  }

  void measure_states(std::vector<double> const& densities, std::vector<double> const& temperatures,
                      std::vector<Quantity> const& quantities) {
    for (double const rho : densities)
      for (double const T : temperatures)
        measure({.given = {{Quantity::rho, rho}, {Quantity::T, T}}}, quantities);
  }

  void measure_shocks(double rho_0, double T_0, std::vector<double> const& v_P,
                      std::vector<Quantity> const& quantities) {
    for (double const v : v_P)
      measure({.path = DataPath::hugoniot,
               .start = StartState{.rho = rho_0, .T = T_0},
               .given = {{Quantity::v_P, v}}},
              quantities);
  }

  std::vector<Observation> data;

 private:
  Model truth_;
  std::mt19937_64 generator_;
  std::normal_distribution<double> normal_;
  double relative_noise_;
};

/// n values from `first` to `last`.
inline std::vector<double> spaced(double first, double last, int n) {
  std::vector<double> values;
  for (int i = 0; i < n; ++i)
    values.push_back(first + (last - first) * i / (n - 1));
  return values;
}

} // namespace mesobridge::fitting::test
