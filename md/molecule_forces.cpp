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

constexpr double most_images = 1e7; ///< about 1 GB

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
  double widest = widest_term(molecules);
  for (auto const& other : others)
    widest = std::max(widest, widest_term(other));
  if (widest > 0)
    lammps.command("comm_modify cutoff {}", room_for_terms * widest);
  lammps.command("neigh_modify every 1 delay 0 check yes");
  // What was set so far holds unless the settings say otherwise.
  forces.set_all(lammps, coefficients);
  tally_atom_energies(lammps);
}

void MoleculeSystem::require_few_images(LammpsSession& lammps, Box const& box) const {
  double const reach = lammps.reach();
  Vec3 const widths = box.widths();
  double boxes = 1;
  for (double const width : {widths.x, widths.y, widths.z})
    boxes *= 1 + 2 * reach / width;
  double const images = double(lammps.atoms()) * (boxes - 1);
  if (!(images <= most_images))
    throw LammpsError(
        fmt::format("cut-offs that reach {} (with the skin) beyond a box {} x {} x {} wide need "
                    "{:.2g} images of its {} atoms; at most {:.0e} are made: a shorter cut-off "
                    "or a larger box",
                    reach, widths.x, widths.y, widths.z, images, lammps.atoms(), most_images));
}

MoleculeSystem read_molecule_system(std::filesystem::path const& data_file,
                                    std::filesystem::path const& settings, MoleculeStyles const& styles,
                                    std::optional<int> kind) {
  ForceField forces(settings);
  auto data =
      read_data_file(data_file, agreed(styles.atom_style, forces.atom_style(), "--atom-style", settings));
  auto units = agreed(styles.units, forces.units(), "--units", settings);
  if (units.empty())
    units = "lj";
  require(std::ranges::find(unit_styles, units) != unit_styles.end(), "units", units,
          "must be lj, real, metal, si, cgs, micro or nano");
  take_masses(data, forces);
  auto kinds = kind ? molecules_by_kind(data) : std::vector{equal_molecules(data)};
  int const chosen = kind.value_or(1);
  require(chosen >= 1 && chosen <= int(kinds.size()), "--kind", chosen,
          fmt::format("must be 1 ... {}, a kind of molecules of '{}'", kinds.size(), data_file.string()));
  auto const at = kinds.begin() + (chosen - 1);
  MoleculeSystem system{.data = data_file,
                        .molecules = std::move(*at),
                        .forces = std::move(forces),
                        .units = units,
                        .coefficients = std::move(data.coefficients)};
  kinds.erase(at);
  system.others = std::move(kinds);
  return system;
}

FrameEnergies::FrameEnergies(MpiWorld const& world, MoleculeSystem const& system, Of what,
                             std::filesystem::path folder)
    : world_(world), system_(system), what_(what), folder_(std::move(folder)) {}

void FrameEnergies::start(std::span<Vec3 const> q, Box const& box) {
  bool const inside = what_ == Of::inside_molecules;
  auto const stem = folder_ / fmt::format("{}-{}", inside ? "inside" : "whole", world_.rank());
  auto const log = stem.string() + ".log", data = stem.string() + ".data";
  FilesOfAMoment const files{{log, data}};
  lammps_.emplace(world_, Ranks::own, log);
  system_.prepare(*lammps_);
  lammps_->command("atom_modify sort 0 0.0"); // sums in the same order, however often it was asked
  lammps_->command("box tilt large");
  std::vector<CountedKind> parts{
      {&system_.molecules.kind, q.size() / std::size_t(system_.molecules.kind.atoms())}};
  if (!inside) {
    parts[0].count = std::size_t(system_.molecules.count);
    for (auto const& other : system_.others)
      parts.push_back({&other.kind, std::size_t(other.count)});
  }
  write_data_file(data, parts, q, box);
  lammps_->command_with_file("read_data", data);
  system_.set_forces(*lammps_);
  if (inside)
    lammps_->command("neigh_modify exclude molecule/inter all");
  lammps_->command("neighbor 0 bin"); // each frame makes its lists anew, of pairs within the cut-off
  system_.require_few_images(*lammps_, box);
  box_ = box;
  lammps_->command("run 0 post no");
  lammps_->command("log none");
  reach_ = list_distance(log);
}

void FrameEnergies::take_box(Box const& box) {
  if (box.tilted() && !box_.tilted())
    lammps_->command("change_box all triclinic");
  auto command = fmt::format("change_box all x final 0 {} y final 0 {} z final 0 {}", box.edge.x, box.edge.y,
                             box.edge.z);
  if (box.tilted() || box_.tilted())
    command += fmt::format(" xy final {} xz final {} yz final {}", box.xy, box.xz, box.yz);
  lammps_->command(command + " units box");
  box_ = box;
}

AtomEnergies FrameEnergies::of(std::span<Vec3 const> q, Box const& box) {
  try {
    if (!lammps_)
      start(q, box);
    if (!box.is_that(box_))
      take_box(box);
    lammps_->set_positions([&](std::int64_t id) { return box.wrap(q[std::size_t(id - 1)]); });
    lammps_->command("run 0 post no");
  } catch (LammpsError const& error) {
    throw InputError(fmt::format("'{}': the energies of the molecules cannot be told: {}",
                                 system_.forces.file().string(), error.what()));
  }
  auto const atoms = lammps_->owned_atoms(atom_energy_compute);
  AtomEnergies told{std::vector<double>(q.size()), std::vector<Vec3>(q.size()), reach_};
  for (std::size_t i = 0; i < atoms.ids.size(); ++i) {
    auto const at = std::size_t(atoms.ids[i] - 1);
    told.potential[at] = atoms.potential[i], told.f[at] = atoms.f[i];
  }
  return told;
}

InsideEnergies::InsideEnergies(MpiWorld const& world, MoleculeSystem const& system,
                               std::filesystem::path folder)
    : energies_(world, system, FrameEnergies::Of::inside_molecules, std::move(folder)) {}

void InsideEnergies::add_to(MoleculeFrame& frame) {
  frame.inside.assign(std::size_t(frame.molecules), 0.0);
  if (frame.molecules == 0)
    return;
  auto const told = energies_.of(frame.q, frame.box);
  auto const n = std::size_t(frame.atoms_per_molecule);
  for (std::size_t i = 0; i < told.potential.size(); ++i)
    frame.inside[i / n] += told.potential[i];
  frame.reach = told.reach;
}

} // namespace mesobridge::md
