#include "workflows/eos_options.hpp"
#include "workflows/text_file.hpp"
#include <CLI/CLI.hpp>

namespace mesobridge::workflows {

void EosOptions::declare(CLI::App& app) {
  app.add_option("--model", model, "A name of `eos list`, or a fitted model's file")
      ->required()
      ->type_name("NAME|FILE");
  auto* const ratio = app.add_option("--gamma", gamma, "Of ideal-gas: the ratio of its heat capacities, > 1");
  app.add_option("--dof", dof, "Of ideal-gas: quadratic degrees of freedom of a molecule (3: monatomic)")
      ->excludes(ratio);
  app.add_option("--m0", m0, "Of ideal-gas: mass of a molecule in kg");
}

fitting::EosModel EosOptions::load() const {
  auto loaded = fitting::load_eos(model, [](std::string const& file) { return read_text_file(file); });
  if (!gamma && !dof && !m0)
    return loaded;
  auto const* const gas = std::get_if<fitting::IdealGas>(&loaded.eos);
  if (!gas)
    throw InputError(fmt::format("--gamma, --dof and --m0 belong to an ideal gas; '{}' is none", model));
  double const mass = m0.value_or(gas->molecular_mass());
  loaded.eos = gamma ? fitting::IdealGas::from_gamma(mass, *gamma, gas->boltzmann())
                     : fitting::IdealGas(mass, dof.value_or(gas->dof()), gas->boltzmann());
  return loaded;
}

} // namespace mesobridge::workflows
