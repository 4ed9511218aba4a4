#include "workflows/trajectory/mapping_of_files.hpp"
#include "fitting/toml_text.hpp"
#include "workflows/trajectory/unit_style.hpp"

namespace mesobridge::workflows {

std::string mapping_of_files_text(md::MoleculeSystem const& system, std::optional<int> kind,
                                  std::filesystem::path const& folder) {
  auto const from_folder = [&](std::filesystem::path const& file) {
    return std::filesystem::proximate(file, folder.empty() ? std::filesystem::current_path() : folder)
        .string();
  };
  return fmt::format("format = \"mesobridge mapping 1\"\nname = {}\nunits = \"{}\"\n\n[lammps]\n"
                     "data = {}\nsettings = {}\n{}",
                     fitting::quoted(system.molecules.kind.name), unit_style(system.units).name,
                     fitting::quoted(from_folder(system.data)),
                     fitting::quoted(from_folder(system.forces.file())),
                     kind ? fmt::format("kind = {}\n", *kind) : "");
}

} // namespace mesobridge::workflows
