#pragma once
#include "md/units.hpp"
#include <optional>

namespace mesobridge::fitting {

/// The factors from Lennard-Jones units to the units of a model: all 1 for a reduced model.
struct LjScale {
  double temperature = 1, density = 1, pressure = 1, specific_energy = 1, mass = 1, boltzmann = 1;

  /// Without units the model stays reduced. Throws InputError unless sigma, epsilon and mass are > 0.
  static LjScale of(std::optional<LjUnits> const& units) {
    if (!units)
      return {};
    auto positive = [](double x) { return x > 0 && std::isfinite(x); };
    require(positive(units->sigma), "LJ sigma", units->sigma, "must be > 0 m");
    require(positive(units->epsilon), "LJ epsilon", units->epsilon, "must be > 0 J");
    require(positive(units->mass), "LJ mass", units->mass, "must be > 0 kg");
    return {units->temperature(),     units->density(), units->pressure(),
            units->specific_energy(), units->mass,      k_B};
  }

  double specific_entropy() const { return boltzmann / mass; }
};

} // namespace mesobridge::fitting
