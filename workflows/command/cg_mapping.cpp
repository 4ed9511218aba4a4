#include "workflows/command/options.hpp"
#include "workflows/shared_options.hpp"
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
  add_molecule_files(app, options.data, options.forces, options.styles);
}

} // namespace

extern Declaration const cg_mapping_command = with_options<CgMappingOptions, declare, write_mapping>;

} // namespace mesobridge::workflows
