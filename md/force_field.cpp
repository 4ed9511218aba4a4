#include "md/force_field.hpp"
#include <algorithm>
#include <array>
#include <cctype>
#include <fmt/ranges.h>
#include <string_view>

namespace mesobridge::md {
namespace {

constexpr std::array known_commands{"units",          "atom_style",     "pair_style",    "pair_coeff",
                                    "pair_modify",    "bond_style",     "bond_coeff",    "angle_style",
                                    "angle_coeff",    "dihedral_style", "mass",          "dihedral_coeff",
                                    "improper_style", "improper_coeff", "special_bonds", "dielectric",
                                    "neighbor",       "neigh_modify",   "comm_modify",   "variable"};

/// What must be known before atoms are read: it decides which bonded neighbours LAMMPS keeps.
constexpr std::array early_commands{"variable",       "pair_style",     "bond_style",   "angle_style",
                                    "dihedral_style", "improper_style", "special_bonds"};

bool any_of(auto const& list, std::string_view word) {
  return std::ranges::find(list, word) != list.end();
}

bool holds(InputLine const& line, std::string_view word) {
  return std::ranges::find(line.words, word) != line.words.end();
}

[[noreturn]] void refuse_command(InputLine const& line) {
  auto const& word = line.words[0];
  if (word.starts_with("kspace"))
    refuse_line(line,
                fmt::format("'{}': a sum on a mesh has no part inside a molecule, of which its "
                            "intrinsic energy could be made; take a cut-off, as of coul/cut or coul/dsf",
                            word));
  if (word == "read_data")
    refuse_line(line, "'read_data': the data file is the command's first argument");
  refuse_line(line, fmt::format("'{}' is no command of a force field; the settings may hold {}", word,
                                fmt::join(known_commands, ", ")));
}

/// Styles that sum over a mesh or over all images.
void refuse_long_range(InputLine const& line) {
  for (std::string_view const word : line.words)
    for (std::string_view const part : {"/long", "/msm", "long/", "tip4p"})
      if (word.find(part) != word.npos)
        refuse_line(line,
                    fmt::format("pair style '{}': a long-range sum has no part inside a molecule, of which "
                                "its intrinsic energy could be made; take a cut-off, as of coul/cut or "
                                "coul/dsf",
                                word));
}

void refuse_untold_energies(InputLine const& line) {
  auto const& command = line.words[0];
  if (command == "pair_style")
    refuse_long_range(line);
  if (command == "pair_modify")
    for (std::size_t k = 1; k + 1 < line.words.size(); ++k)
      if (line.words[k] == "tail" && line.words[k + 1] != "no")
        refuse_line(line, "'pair_modify tail yes': the correction beyond the cut-off belongs to no molecule");
  if (command == "neigh_modify" && (holds(line, "exclude") || holds(line, "include")))
    refuse_line(line, "'neigh_modify exclude' and 'include' change the forces: which pairs count is told by "
                      "special_bonds and pair_coeff");
  if (command == "variable") {
    constexpr std::array allowed{"equal", "index", "string"};
    if (line.words.size() < 3 || !any_of(allowed, line.words[2]))
      refuse_line(line, fmt::format("'{}': variables may be of the styles {}", line.text(),
                                    fmt::join(allowed, ", ")));
  }
}

} // namespace

ForceField::ForceField(std::filesystem::path const& file) : file_(file) {
  for (auto& line : read_input_lines(file, true))
    if (!line.words.empty())
      take(std::move(line));
}

void ForceField::take(InputLine line) {
  auto const& command = line.words[0];
  if (!any_of(known_commands, command))
    refuse_command(line);
  refuse_untold_energies(line);
  if (command == "units" || command == "atom_style") {
    if (line.words.size() != 2)
      refuse_line(line, fmt::format("'{}' must be followed by one style", command));
    (command == "units" ? units_ : atom_style_) = line.words[1];
    return;
  }
  // A table beside the settings is found from anywhere.
  if (command.ends_with("_coeff") && file_.has_parent_path())
    for (std::size_t k = 1; k < line.words.size(); ++k)
      if (auto const beside = file_.parent_path() / line.words[k];
          std::isalpha(static_cast<unsigned char>(line.words[k][0])) &&
          !std::filesystem::exists(line.words[k]) && std::filesystem::is_regular_file(beside))
        line.words[k] = fmt::format("\"{}\"", beside.string());
  lines_.push_back(std::move(line));
}

std::vector<InputLine> ForceField::all_of(std::string const& command) const {
  std::vector<InputLine> found;
  for (auto const& line : lines_)
    if (line.words[0] == command)
      found.push_back(line);
  return found;
}

void ForceField::run(LammpsSession& lammps, InputLine const& line) const {
  try {
    lammps.command(line.text());
  } catch (LammpsError const& error) {
    refuse_line(line, error.what());
  }
}

void ForceField::set_styles(LammpsSession& lammps) const {
  for (auto const& line : lines_)
    if (any_of(early_commands, line.words[0]))
      run(lammps, line);
}

void ForceField::set_all(LammpsSession& lammps, std::vector<InputLine> const& coefficients_of_data) const {
  for (auto const& line : lines_)
    if (any_of(early_commands, line.words[0]) && line.words[0] != "variable")
      run(lammps, line);
  for (auto const& line : coefficients_of_data)
    run(lammps, line);
  for (auto const& line : lines_)
    if (!any_of(early_commands, line.words[0]))
      run(lammps, line);
}

} // namespace mesobridge::md
