#include "workflows/command/options.hpp"
#include "workflows/star/force_field_mapping.hpp"
#include "workflows/text_file.hpp"
#include <CLI/CLI.hpp>

namespace mesobridge::workflows {

namespace {

struct CgMappingOptions {
  std::filesystem::path data, forces;
  md::MoleculeStyles styles;
};

Result write_mapping(CgMappingOptions const& options, Context const& context) {
  auto const system = md::read_molecule_system(options.data, options.forces, options.styles);
  auto const text = mapping_text(system);
  auto const& kind = system.molecules.kind;
  auto const file = context.options.output.value_or(kind.name + ".toml");
  write_text_file(file, text);
  Result result;
  result.json = {{"file", file.string()},
                 {"molecule", kind.name},
                 {"molecules", system.molecules.count},
                 {"atoms_per_molecule", kind.atoms()},
                 {"bonds_per_molecule", kind.bonded[0].size()},
                 {"units", system.units}};
  result.text = fmt::format("{}\n`mesobridge cg blobs TRAJECTORY --mapping {}` makes blobs of a trajectory",
                            text, file.string());
  return result;
}

void declare(CLI::App& app, CgMappingOptions& options) {
  app.add_option("data", options.data, "LAMMPS data file of equal molecules")->required()->type_name("FILE");
  app.add_option("--settings", options.forces,
                 "Their force field as LAMMPS's commands: pair_style, bond_coeff ...")
      ->required()
      ->type_name("FILE");
  app.add_option("--units", options.styles.units, "LAMMPS's unit style (default: the settings' or lj)")
      ->type_name("NAME");
  app.add_option("--atom-style", options.styles.atom_style,
                 "bond, angle, molecular or full (default: what the files say)")
      ->type_name("NAME");
}

} // namespace

Command::Action cg_mapping_command(CLI::App& app) {
  return with_options<CgMappingOptions>(app, declare, write_mapping);
}

} // namespace mesobridge::workflows
