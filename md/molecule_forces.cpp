#include "md/molecule_forces.hpp"
#include <algorithm>
#include <charconv>
#include <fstream>

namespace mesobridge::md {
namespace {

/// LAMMPS's unit styles but `electron`, which mixes two units of time.
constexpr std::array<std::string_view, 7> unit_styles{"lj", "real", "metal", "si", "cgs", "micro", "nano"};

/// One word of two places that may say it.
std::string agreed(std::string const& of_option, std::string const& of_settings, std::string const& what,
                   std::filesystem::path const& settings) {
  if (!of_option.empty() && !of_settings.empty() && of_option != of_settings)
    throw InputError(fmt::format("{} = {}: '{}' says {}", what, of_option, settings.string(), of_settings));
  return of_option.empty() ? of_settings : of_option;
}

/// The masses that the settings tell take the place of the data file's.
void take_masses(DataFile& data, ForceField const& forces) {
  for (auto const& line : forces.all_of("mass")) {
    if (line.words.size() != 3)
      refuse_line(line, "'mass' must be followed by an atom type and a mass");
    double const mass = number_in(line, 2, "mass");
    if (!(mass > 0))
      refuse_line(line, fmt::format("mass = {}: must be > 0", mass));
    if (line.words[1] == "*") {
      data.masses.assign(data.masses.size(), mass);
      continue;
    }
    auto const type = whole_in(line, 1, "atom type");
    if (type < 1 || type > data.atom_types)
      refuse_line(line, fmt::format("atom type = {}: must be 1 ... {}", type, data.atom_types));
    data.masses[std::size_t(type - 1)] = mass;
  }
}

/// Files that are gone with it, however it ends.
struct FilesOfAMoment {
  std::vector<std::filesystem::path> files;
  ~FilesOfAMoment() {
    std::error_code none;
    for (auto const& file : files)
      std::filesystem::remove(file, none);
  }
};

/// What LAMMPS writes into its log about its lists of neighbours: the longest cut-off, with the skin.
double list_distance(std::filesystem::path const& log) {
  constexpr std::string_view key = "master list distance cutoff = ";
  std::ifstream in(log);
  for (std::string line; std::getline(in, line);)
    if (auto const at = line.find(key); at != line.npos) {
      double value = 0;
      std::from_chars(line.data() + at + key.size(), line.data() + line.size(), value);
      return value;
    }
  return 0; // no pairs
}

/// Across the borders of ranks bonded atoms are found within this many times the widest distance in the data
/// file between two atoms of a bonded term.
constexpr double room_for_terms = 2;

double widest_term(Molecules const& molecules) {
  double widest = 0;
  auto const n = std::size_t(molecules.kind.atoms());
  for (std::size_t m = 0; m < molecules.q.size(); m += n)
    for (std::size_t kind = 0; kind < bonded_atoms.size(); ++kind)
      for (auto const& term : molecules.kind.bonded[kind])
        for (std::size_t a = 0; a < bonded_atoms[kind]; ++a)
          for (std::size_t b = 0; b < a; ++b)
            widest = std::max(widest, norm(molecules.q[m + std::size_t(term.atoms[a])] -
                                           molecules.q[m + std::size_t(term.atoms[b])]));
  return widest;
}

} // namespace

void MoleculeSystem::prepare(LammpsSession& lammps) const {
  try {
    lammps.command("units {}", units);
    lammps.command("atom_style {}", molecules.kind.atom_style);
    lammps.command("atom_modify map array");
  } catch (LammpsError const& error) {
    throw InputError(error.what());
  }
  forces.set_styles(lammps);
}

void MoleculeSystem::set_forces(LammpsSession& lammps) const {
  if (double const widest = widest_term(molecules); widest > 0)
    lammps.command("comm_modify cutoff {}", room_for_terms * widest);
  lammps.command("neigh_modify every 1 delay 0 check yes");
  // What was set so far holds unless the settings say otherwise.
  forces.set_all(lammps, coefficients);
  tally_atom_energies(lammps);
}

MoleculeSystem read_molecule_system(std::filesystem::path const& data_file,
                                    std::filesystem::path const& settings, MoleculeStyles const& styles) {
  ForceField forces(settings);
  auto data =
      read_data_file(data_file, agreed(styles.atom_style, forces.atom_style(), "--atom-style", settings));
  auto units = agreed(styles.units, forces.units(), "--units", settings);
  if (units.empty())
    units = "lj";
  require(std::ranges::find(unit_styles, units) != unit_styles.end(), "units", units,
          "must be lj, real, metal, si, cgs, micro or nano");
  take_masses(data, forces);
  return {.molecules = equal_molecules(data),
          .forces = std::move(forces),
          .units = units,
          .coefficients = std::move(data.coefficients)};
}

InsideEnergies::InsideEnergies(MpiWorld const& world, MoleculeSystem const& system,
                               std::filesystem::path folder)
    : world_(world), system_(system), folder_(std::move(folder)) {}

void InsideEnergies::start(MoleculeFrame const& frame) {
  auto const stem = folder_ / fmt::format("inside-{}", world_.rank());
  auto const log = stem.string() + ".log", data = stem.string() + ".data";
  FilesOfAMoment const files{{log, data}};
  lammps_.emplace(world_, Ranks::own, log);
  system_.prepare(*lammps_);
  lammps_->command("atom_modify sort 0 0.0"); // sums in the same order, however often it was asked
  write_data_file(data, system_.molecules.kind, frame.q, frame.box);
  lammps_->command_with_file("read_data", data);
  system_.set_forces(*lammps_);
  lammps_->command("neigh_modify exclude molecule/inter all");
  lammps_->command("neighbor 0 bin"); // each frame makes its lists anew, of pairs within the cut-off
  lammps_->command("run 0 post no");
  lammps_->command("log none");
  reach_ = list_distance(log);
}

void InsideEnergies::add_to(MoleculeFrame& frame) {
  frame.inside.assign(std::size_t(frame.molecules), 0.0);
  if (frame.molecules == 0)
    return;
  try {
    if (!lammps_)
      start(frame);
    lammps_->set_positions([&](std::int64_t id) { return frame.box.wrap(frame.q[std::size_t(id - 1)]); });
    lammps_->command("run 0 post no");
  } catch (LammpsError const& error) {
    throw InputError(fmt::format("'{}': the energies inside the molecules cannot be told: {}",
                                 system_.forces.file().string(), error.what()));
  }
  auto const atoms = lammps_->owned_atoms(atom_energy_compute);
  auto const n = std::int64_t{frame.atoms_per_molecule};
  std::vector<double> energies(frame.q.size(), 0.0);
  for (std::size_t i = 0; i < atoms.ids.size(); ++i)
    energies[std::size_t(atoms.ids[i] - 1)] = atoms.potential[i];
  for (std::size_t i = 0; i < energies.size(); ++i)
    frame.inside[i / std::size_t(n)] += energies[i];
  frame.reach = reach_;
}

} // namespace mesobridge::md
