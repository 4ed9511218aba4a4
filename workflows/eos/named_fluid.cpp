#include "workflows/eos/named_fluid.hpp"
#include "fitting/valid_range.hpp"
#include <CLI/CLI.hpp>
#include <limits>
#include <spdlog/logger.h>

namespace mesobridge::workflows {

NamedFluid load_fluid(EosOptions const& options) {
  auto model = options.load();
  bool const reduced = std::visit([](auto const& eos) { return eos.boltzmann() == 1; }, model.eos);
  auto fluid = fitting::Fluid(model.eos);
  return {.name = options.model, .model = std::move(model), .fluid = std::move(fluid), .reduced = reduced};
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

void warn_outside_data(NamedFluid const& fluid, double rho, double T, Context const& context) {
  if (auto const doubt = fitting::extrapolation(fluid.model, rho, T))
    context.log->warn("{}: {}", fluid.name, *doubt);
}

void warn_outside_data(NamedFluid const& fluid, std::array<double, 2> rho, std::array<double, 2> T,
                       Context const& context) {
  for (double const density : rho)
    for (double const temperature : T)
      if (fitting::extrapolation(fluid.model, density, temperature))
        return warn_outside_data(fluid, density, temperature, context);
}

fitting::EosState InitialState::of(fitting::Fluid const& fluid) const {
  require_positive_number("--rho0", rho0);
  require_positive_number("--T0", T0);
  return fluid.at_temperature(rho0, T0);
}

fitting::EosState InitialState::of(NamedFluid const& fluid, Context const& context) const {
  auto const state = of(fluid.fluid);
  warn_outside_data(fluid, rho0, T0, context);
  return state;
}

} // namespace mesobridge::workflows
