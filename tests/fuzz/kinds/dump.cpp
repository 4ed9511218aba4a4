#include "fuzz/change_text.hpp"
#include "fuzz/kinds/kinds.hpp"
#include "fuzz/kinds/molecules.hpp"
#include "workflows/text_file.hpp"
#include <fmt/format.h>

namespace mesobridge::fuzz {
namespace {

/// What LAMMPS needs to tell the energies itself.
void write_lammps_files(std::filesystem::path const& folder, Molecules const& all) {
  std::string atoms, bonds;
  constexpr int n = Molecules::atoms * Molecules::molecules;
  for (int k = 0; k < n; ++k) {
    auto const& q = all.q[std::size_t(k)];
    atoms += fmt::format("{} {} 1 {} {} {}\n", k + 1, k / Molecules::atoms + 1, q.x, q.y, q.z);
    if (k % Molecules::atoms > 0)
      bonds += fmt::format("{} 1 {} {}\n", k, k, k + 1);
  }
  workflows::write_text_file(
      folder / "melt.data",
      fmt::format("melt\n\n{} atoms\n{} bonds\n1 atom types\n1 bond types\n0 9 xlo xhi\n"
                  "0 9 ylo yhi\n0 9 zlo zhi\n\nMasses\n\n1 1\n\nAtoms # bond\n\n{}\nBonds\n\n{}",
                  n, n - Molecules::molecules, atoms, bonds));
  workflows::write_text_file(folder / "melt.settings",
                             "units lj\npair_style lj/cut 1.12\npair_modify shift yes\npair_coeff 1 1 1 1\n"
                             "bond_style harmonic\nbond_coeff 1 25 1\nspecial_bonds lj 1 1 1\n");
  workflows::write_text_file(folder / "lammps.toml",
                             "format = \"mesobridge mapping 1\"\nname = \"tetramer\"\n[lammps]\n"
                             "data = \"melt.data\"\nsettings = \"melt.settings\"\nkind = 1\n");
}

void prepare(std::filesystem::path const& folder) {
  Molecules::write_mapping(folder / "map.toml");
  Molecules const all;
  constexpr std::size_t n = Molecules::atoms * Molecules::molecules;
  std::string text;
  for (std::size_t f = 0; f < Molecules::frames; ++f) {
    text +=
        fmt::format("ITEM: TIMESTEP\n{}\nITEM: NUMBER OF ATOMS\n{}\nITEM: BOX BOUNDS pp pp pp\n", 100 * f, n);
    for (int axis = 0; axis < 3; ++axis)
      text += fmt::format("0 {}\n", Molecules::edge);
    text += "ITEM: ATOMS id mol type x y z vx vy vz\n";
    for (std::size_t k = 0; k < n; ++k) {
      auto const &q = all.q[f * n + k], &v = all.v[f * n + k];
      text += fmt::format("{} {} 1 {} {} {} {} {} {}\n", k + 1, k / Molecules::atoms + 1, q.x, q.y, q.z, v.x,
                          v.y, v.z);
    }
  }
  workflows::write_text_file(folder / "t.lammpstrj", text);
  write_lammps_files(folder, all);
}

/// The same box by other edges: (9, 0, 0), (9, 9, 0), (0, 0, 9).
void tilt(std::filesystem::path const& dump, bool vectors) {
  auto text = workflows::read_text_file(dump);
  std::string const upright = "BOUNDS pp pp pp\n0 9\n0 9\n0 9\n",
                    tilted = vectors ? "BOUNDS abc origin pp pp pp\n9 0 0 0\n9 9 0 0\n0 0 9 0\n"
                                     : "BOUNDS xy xz yz pp pp pp\n0 18 9\n0 9 0\n0 9 0\n";
  for (std::size_t at = 0; (at = text.find(upright, at)) != text.npos; at += tilted.size())
    text.replace(at, upright.size(), tilted);
  workflows::write_text_file(dump, text);
}

void change(Random& random, Trial& trial) {
  trial.commands = {
      {"cg", "blobs", "t.lammpstrj", "--mapping", "map.toml", "--dt", "0.005", "-o", "out", "--quiet"}};
  if (random.chance(0.3))
    tilt(trial.folder / "t.lammpstrj", random.chance(0.5));
  if (random.chance(0.15)) {
    trial.commands[0][4] = "lammps.toml";
    std::string const files[] = {"lammps.toml", "melt.data", "melt.settings", "t.lammpstrj"};
    trial.change = change_text(random, trial.folder / files[random.below(4)]);
    return;
  }
  trial.change = random.chance(0.15)  ? change_text(random, trial.folder / "map.toml")
                 : random.chance(0.1) ? change_bytes(random, trial.folder / "t.lammpstrj")
                                      : change_text(random, trial.folder / "t.lammpstrj");
}

} // namespace

Kind dump_kind() {
  return {.name = "dump", .prepare = prepare, .change = change};
}

} // namespace mesobridge::fuzz
