#include "workflows/eos/named_fluid.hpp"
#include <CLI/CLI.hpp>
#include <limits>

namespace mesobridge::workflows {

NamedFluid load_fluid(EosOptions const& options) {
  auto const model = options.load();
  return {.name = options.model,
          .fluid = fitting::Fluid(model.eos),
          .reduced = std::visit([](auto const& eos) { return eos.boltzmann() == 1; }, model.eos)};
}

NamedFluid load_fluid(std::string const& name_or_file) {
  return load_fluid(EosOptions{.model = name_or_file, .gamma = {}, .dof = {}, .m0 = {}});
}

void require_same_units(NamedFluid const& a, NamedFluid const& b) {
  if (a.reduced != b.reduced)
    throw InputError(fmt::format("'{}' is in {} and '{}' in {}: both must have the same units", a.name,
                                 a.reduced ? "Lennard-Jones units" : "SI", b.name,
                                 b.reduced ? "Lennard-Jones units" : "SI"));
}

void require_positive_number(std::string const& option, double value) {
  require(value > 0 && std::isnormal(value), option, value,
          fmt::format("must be > 0, finite and at least {:.3g}, below which digits are lost",
                      std::numeric_limits<double>::min()));
}

void InitialState::declare(CLI::App& app) {
  app.add_option("--rho0", rho0, "Density of the state at rest, in the model's units (SI: kg/m^3)")
      ->required();
  app.add_option("--T0", T0, "Its temperature (SI: K)")->required();
}

fitting::EosState InitialState::of(fitting::Fluid const& fluid) const {
  require_positive_number("--rho0", rho0);
  require_positive_number("--T0", T0);
  return fluid.at_temperature(rho0, T0);
}

} // namespace mesobridge::workflows
