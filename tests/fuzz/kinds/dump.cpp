#include "fuzz/change_text.hpp"
#include "fuzz/kinds/kinds.hpp"
#include "fuzz/kinds/molecules.hpp"
#include "workflows/text_file.hpp"
#include <fmt/format.h>

namespace mesobridge::fuzz {
namespace {

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
}

void change(Random& random, Trial& trial) {
  trial.commands = {
      {"cg", "blobs", "t.lammpstrj", "--mapping", "map.toml", "--dt", "0.005", "-o", "out", "--quiet"}};
  trial.change = random.chance(0.15)  ? change_text(random, trial.folder / "map.toml")
                 : random.chance(0.1) ? change_bytes(random, trial.folder / "t.lammpstrj")
                                      : change_text(random, trial.folder / "t.lammpstrj");
}

} // namespace

Kind dump_kind() {
  return {.name = "dump", .prepare = prepare, .change = change};
}

} // namespace mesobridge::fuzz
