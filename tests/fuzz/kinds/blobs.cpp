#include "fuzz/change_hdf5.hpp"
#include "fuzz/kinds/kinds.hpp"
#include "random_blobs.hpp"
#include "workflows/star/blob_file.hpp"

namespace mesobridge::fuzz {
namespace {

constexpr int molecules = 27, frames = 240;

std::vector<cg::BlobFrame> frames_of(std::uint64_t seed) {
  tests::RandomBlobs random(12, seed);
  std::vector<cg::BlobFrame> all;
  for (int f = 0; f < frames; ++f)
    all.push_back(random.frame(f, molecules));
  return all;
}

void write(std::filesystem::path const& file, std::string const& kind, std::vector<double> set) {
  workflows::BlobFileHead const head{.kind = kind,
                                     .name = "6-3",
                                     .fingerprint = "fuzz",
                                     .molecules = molecules,
                                     .atoms = 19,
                                     .mass = 19,
                                     .rho = kind == "melt" ? 0.3 : 0,
                                     .T = kind == "melt" ? 0.0 : 1.0,
                                     .set = std::move(set)};
  workflows::BlobFile blobs(file, head, {.command = "fuzz", .seed = 1, .scene = "", .inputs = {}});
  blobs.append(frames_of(5));
  blobs.close();
}

void prepare(std::filesystem::path const& folder) {
  write(folder / "melt.h5", "melt", {});
  write(folder / "vacuum.h5", "vacuum canonical", std::vector<double>(molecules, 1.0));
}

void change(Random& random, Trial& trial) {
  std::vector<std::vector<std::string>> const uses{
      {"cg", "entropy", "--melt", "melt.h5", "--vacuum", "vacuum.h5", "-o", "out", "--quiet"},
      {"cg", "correlations", "melt.h5", "-o", "out", "--quiet"},
      {"fit", "dpde", "melt.h5", "-o", "out", "--quiet"}};
  trial.commands = {random.of(uses)};
  bool const both = trial.commands[0][1] == "entropy";
  trial.change = change_hdf5(random, trial.folder / (both && random.chance(0.5) ? "vacuum.h5" : "melt.h5"));
}

} // namespace

Kind blobs_kind() {
  return {.name = "blobs", .prepare = prepare, .change = change};
}

} // namespace mesobridge::fuzz
