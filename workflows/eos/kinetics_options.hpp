#pragma once
#include "fitting/kinetics.hpp"
#include "workflows/command.hpp"

namespace mesobridge::workflows {

/// Kinetics of a reaction (fitting/README.md, Eq. (F23)) as the command line states them.
struct KineticsOptions {
  double Z = 0, E_a = 0;
  std::string order = "second", sum = "density", kernel = "cubic";
  std::optional<double> rho_bar, self;
  double h_factor = 2.5;

  void declare(CLI::App& app);
  /// The mean density of the particles is that at rest where none is given. Throws InputError.
  fitting::Kinetics kinetics(double rho_at_rest) const;
};

} // namespace mesobridge::workflows
