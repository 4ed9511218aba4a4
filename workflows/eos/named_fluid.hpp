#pragma once
#include "fitting/fluid.hpp"
#include "workflows/command.hpp"
#include "workflows/eos_options.hpp"

namespace mesobridge::workflows {

/// A model as the command line names it.
struct NamedFluid {
  std::string name;
  fitting::EosModel model;
  fitting::Fluid fluid;
  bool reduced; ///< in Lennard-Jones units
};

/// A built-in material or a model file. Throws InputError that lists the materials.
NamedFluid load_fluid(EosOptions const& options);
NamedFluid load_fluid(std::string const& name_or_file);

/// Throws InputError unless both are in SI or both reduced.
void require_same_units(NamedFluid const& a, NamedFluid const& b);

/// Throws InputError that names the option unless the value is > 0, finite, and not so small that double
/// precision loses its digits.
void require_positive_number(std::string const& option, double value);

/// Says so where the model is extrapolated.
void warn_outside_data(NamedFluid const& fluid, double rho, double T, Context const& context);

/// The same for all states of a rectangle, once.
void warn_outside_data(NamedFluid const& fluid, std::array<double, 2> rho, std::array<double, 2> T,
                       Context const& context);

/// A state at rest given by --rho0 and --T0.
struct InitialState {
  double rho0 = 0, T0 = 0;

  void declare(CLI::App& app);
  /// Throws InputError unless both are > 0, PhysicsError outside the model.
  fitting::EosState of(fitting::Fluid const& fluid) const;
  /// Warns outside the model's data, too.
  fitting::EosState of(NamedFluid const& fluid, Context const& context) const;
};

} // namespace mesobridge::workflows
