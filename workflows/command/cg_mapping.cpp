#include "workflows/command/options.hpp"
#include "workflows/shared_options.hpp"
#include "workflows/text_file.hpp"
#include "workflows/trajectory/force_field_mapping.hpp"
#include "workflows/trajectory/mapping_of_files.hpp"
#include <CLI/CLI.hpp>

namespace mesobridge::workflows {

namespace {

struct CgMappingOptions {
  std::filesystem::path data, forces;
  md::MoleculeStyles styles;
  std::optional<int> kind;
};

/// The text, and why LAMMPS's files are named in it; empty: they are not.
std::pair<std::string, std::string> text_of(md::MoleculeSystem const& system, std::optional<int> kind,
                                            std::filesystem::path const& folder) {
  try {
    return {mapping_text(system), ""};
  } catch (NotHeldByMapping const& reason) {
    return {mapping_of_files_text(system, kind, folder), reason.what()};
  }
}

Result write_mapping(CgMappingOptions const& options, Context const& context) {
  auto const system = md::read_molecule_system(options.data, options.forces, options.styles, options.kind);
  auto const& kind = system.molecules.kind;
  auto const file = context.options.output.value_or(kind.name + ".toml");
  auto const [text, reason] = text_of(system, options.kind, file.parent_path());
  write_text_file(file, text);
  Result result;
  result.json = {{"file", file.string()},
                 {"molecule", kind.name},
                 {"molecules", system.molecules.count},
                 {"atoms_per_molecule", kind.atoms()},
                 {"bonds_per_molecule", kind.bonded[0].size()},
                 {"units", system.units},
                 {"energies", reason.empty() ? "mapping" : "LAMMPS"}};
  if (!reason.empty())
    result.json["why_lammps"] = reason;
  result.text =
      fmt::format("{}\n{}`mesobridge cg blobs TRAJECTORY --mapping {}` makes blobs of a trajectory", text,
                  reason.empty() ? "" : fmt::format("The energies of each frame are LAMMPS's: {}\n", reason),
                  file.string());
  return result;
}

void declare(CLI::App& app, CgMappingOptions& options) {
  add_molecule_files(app, options.data, options.forces, options.styles);
  app.add_option("--kind", options.kind,
                 "Which molecules, where the data file has several kinds: 1 for that of the first one");
}

} // namespace

extern Declaration const cg_mapping_command = with_options<CgMappingOptions, declare, write_mapping>;

} // namespace mesobridge::workflows
