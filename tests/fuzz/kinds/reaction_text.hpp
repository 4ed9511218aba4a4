#pragma once
#include "fuzz/trial.hpp"
#include "sdpd/kinetics/list.hpp"
#include "workflows/quantity.hpp"
#include <cmath>
#include <fmt/format.h>

namespace mesobridge::fuzz {

inline double between(Random& random, double low, double high) {
  return low + (high - low) * random.unit();
}
/// Of no particular order of magnitude.
inline double any_between(Random& random, double low, double high) {
  return low * std::pow(high / low, random.unit());
}

/// The table [reaction] of an SDPD scene: any law of the list with parameters of any order of magnitude, any
/// product, heat of either sign; now and then with a word or a number that cannot be.
class ReactionText {
 public:
  explicit ReactionText(Random& random)
      : random_(random),
        product_(random.of<std::string>(
            {"nitromethane-products", "nitromethane-products", "nitromethane-products", "pbx-9502-products",
             "ideal-gas", "ideal-gas", "air", "water", "water", random.chance(0.3) ? "argon" : "tin"})) {}

  /// Which wants the mass of a molecule where it is an ideal gas, a key of [fluid].
  std::string const& product() const { return product_; }

  std::string text() {
    std::string text = fmt::format("[reaction]\nproduct = \"{}\"\n", product_) + heat();
    auto const& law = random_.of(sdpd::kinetics());
    text += fmt::format("kinetics = \"{}\"\n", law.name);
    for (auto const& parameter : law.parameters)
      text += parameter_line(parameter);
    if (random_.chance(law.name.starts_with("second-order") ? 0.5 : 0.03))
      text += "weights = \"normalised\"\n";
    text += fmt::format("integrator = \"{}\"\n", random_.of(sdpd::rate_integrator_names()));
    if (random_.chance(0.3))
      text += "volumes = \"paper\"\n";
    return text + (random_.chance(0.5) ? fmt::format("progress = {}\n", progress(random_)) : "");
  }

  static std::string progress(Random& random) {
    return random.chance(0.02)
               ? "1.5"
               : random.of<std::string>({"0", "1", "1e-9", "0.999999", fmt::format("{:.3g}", random.unit())});
  }

 private:
  std::string heat() {
    double const sign = random_.chance(0.8) ? 1 : -1, size = random_.chance(0.1) ? 0 : 1;
    return random_.chance(0.7)
               ? fmt::format("heat = \"{:.4g} J/kg\"\n", sign * size * any_between(random_, 1e3, 2e7))
               : fmt::format("heat_per_molecule = \"{:.4g} J\"\n",
                             sign * size * any_between(random_, 1e-22, 2e-18));
  }

  double usual(std::optional<Dimension> const& dimension) {
    if (!dimension)
      return random_.chance(0.3) ? std::floor(between(random_, 0, 4)) : any_between(random_, 0.01, 6);
    switch (*dimension) {
    case Dimension::rate:
      return any_between(random_, 1e8, 1e17);
    case Dimension::energy:
      return any_between(random_, 1e-22, 1e-18);
    case Dimension::pressure:
      return any_between(random_, 1e7, 1e11);
    case Dimension::velocity:
      return any_between(random_, 50, 2e4);
    case Dimension::length:
      return any_between(random_, 1e-10, 1e-7);
    default:
      return any_between(random_, 1e-3, 1e3);
    }
  }

  std::string parameter_line(sdpd::Parameter const& parameter) {
    double const value = (random_.chance(0.01)   ? -1
                          : random_.chance(0.02) ? 0
                                                 : 1) *
                         usual(parameter.dimension);
    return parameter.dimension ? fmt::format("{} = \"{:.4g} {}\"\n", parameter.name, value,
                                             workflows::si_unit(*parameter.dimension))
                               : fmt::format("{} = {:.4g}\n", parameter.name, value);
  }

  Random& random_;
  std::string product_;
};

} // namespace mesobridge::fuzz
