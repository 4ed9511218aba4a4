#include "workflows/h5md.hpp"
#include "chain_mapping.hpp"
#include "fuzz/change_hdf5.hpp"
#include "fuzz/change_text.hpp"
#include "fuzz/kinds/kinds.hpp"
#include "fuzz/kinds/molecules.hpp"
#include "workflows/text_file.hpp"

namespace mesobridge::fuzz {

void Molecules::write_mapping(std::filesystem::path const& file) {
  workflows::write_text_file(file, tests::chain_mapping("tetramer", 4, 50, 1));
}

namespace {

void prepare(std::filesystem::path const& folder) {
  Molecules::write_mapping(folder / "map.toml");
  Molecules const all;
  workflows::H5mdWriter writer(folder / "t.h5", workflows::H5mdWriter::Units::reduced(),
                               {.command = "fuzz", .seed = 1, .scene = "", .inputs = {}});
  constexpr std::size_t n = Molecules::atoms * Molecules::molecules;
  for (std::size_t f = 0; f < Molecules::frames; ++f)
    writer.append({.step = static_cast<std::int64_t>(100 * f),
                   .time = 0.5 * static_cast<double>(f),
                   .box = {{Molecules::edge, Molecules::edge, Molecules::edge}},
                   .positions = std::span(all.q).subspan(f * n, n),
                   .velocities = std::span(all.v).subspan(f * n, n)});
  writer.close();
}

void change(Random& random, Trial& trial) {
  trial.commands = {{"cg", "blobs", "t.h5", "--mapping", "map.toml", "-o", "out", "--quiet"}};
  trial.change = random.chance(0.1) ? change_text(random, trial.folder / "map.toml")
                                    : change_hdf5(random, trial.folder / "t.h5");
  if (random.chance(0.2))
    trial.change += "; " + change_hdf5(random, trial.folder / "t.h5");
}

} // namespace

Kind h5md_kind() {
  return {.name = "h5md", .prepare = prepare, .change = change};
}

} // namespace mesobridge::fuzz
