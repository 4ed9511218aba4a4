#pragma once
#include "sdpd/kinetics/kind.hpp"
#include "sdpd/simd/lane_math.hpp"

namespace mesobridge::sdpd {

/// K = Z exp(-E_a/k_B T), the rate of Arrhenius, with T_a = E_a/k_B.
struct Arrhenius {
  static constexpr Parameter factor{"Z", Dimension::rate, "pre-exponential factor of the rate", positive},
      barrier{"E_a", Dimension::energy, "activation energy of a molecule", not_negative},
      factor_back{"Z_back", Dimension::rate, "the same of the way back", positive},
      barrier_back{"E_a_back", Dimension::energy, "the same of the way back", not_negative};

  double Z = 0, T_a = 0; ///< before in_units() the energy E_a stands in the place of T_a

  /// From the units of the settings.
  Arrhenius in_units(ReducedUnits const& units) const {
    return {Z * units.time(), T_a / (units.boltzmann * units.temperature)};
  }
  bool acts() const { return Z > 0; }

  double operator()(double T) const { return Z * std::exp(-T_a / T); }
  [[gnu::always_inline]] Lanes operator()(Lanes const& T) const {
    Lanes const exponent = -T_a / T, least = broadcast(-690.0); // what exponential() can
    return Z * exponential(exponent < least ? least : exponent);
  }
};

/// A law of two rates, there and back, whose first members they are, as scenes name it: without and with the
/// way back.
template <class Law>
std::vector<KineticsKind<Law>> arrhenius_kinds(std::string_view name, std::string_view summary,
                                               std::string_view name_reversible,
                                               std::string_view summary_reversible) {
  using A = Arrhenius;
  return {{name,
           summary,
           {A::factor, A::barrier},
           [](auto x) {
             return Law{{x[0], x[1]}, {}};
           }},
          {name_reversible,
           summary_reversible,
           {A::factor, A::barrier, A::factor_back, A::barrier_back},
           [](auto x) {
             return Law{{x[0], x[1]}, {x[2], x[3]}};
           }}};
}

/// The largest change of lambda over which a rate with T_a may be taken as constant, where the reaction gives
/// the heat `heat` to the heat capacity c, both of a unit mass: 0.3 of what changes the rate by the factor e
/// (sdpd/README.md, Eq. (S64)). Infinite without heat.
inline double change_by_heat(double T_a, double T, double c, double heat) {
  constexpr double share = 0.3;
  double const feedback = std::abs(heat) * T_a;
  return feedback > 0 ? share * c * T * T / feedback : std::numeric_limits<double>::infinity();
}

} // namespace mesobridge::sdpd
