#pragma once
#include "fitting/shock_relations.hpp"
#include "workflows/command.hpp"

namespace mesobridge::workflows {

/// Which shocks of a Hugoniot or Crussard curve are asked for: one, by one of four quantities, and the curve
/// up to a pressure.
struct ShockOptions {
  std::optional<double> v_P, v_S, P, rho, P_max;
  int points = 60;

  void declare(CLI::App& app);

  /// Throws InputError when more than one quantity is given, or neither one nor --P-max.
  std::optional<fitting::Shock> shock(fitting::Hugoniot const& hugoniot) const;
  /// Up to --P-max, or a fifth further than the shock asked for.
  std::vector<fitting::Shock> curve(fitting::Hugoniot const& hugoniot,
                                    std::optional<fitting::Shock> const& asked) const;
};

} // namespace mesobridge::workflows
