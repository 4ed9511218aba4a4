#pragma once
#include "random_blobs.hpp"
#include "unit/fitting/synthetic_grid.hpp"
#include "workflows/lj/grid_file.hpp"
#include "workflows/lj/state_grid_file.hpp"
#include "workflows/star/held_file.hpp"
#include "workflows/text_file.hpp"

// Inputs with which the commands that analyse and fit are busy for several seconds.

namespace mesobridge::tests {

/// States of the Lennard-Jones fluid with errors, as `cg state-grid` writes them.
inline void write_many_states(std::filesystem::path const& file) {
  std::mt19937_64 generator(3);
  auto const grid = fitting::test::measured_grid(fitting::LjBwr(fitting::lj_bwr_1993),
                                                 {.densities = 160, .temperatures = 160}, generator);
  workflows::write_state_grid(file, grid, {.command = "test", .scene = "", .inputs = {}});
}

/// Series of a grid of runs, as `md lj-grid` writes them.
inline void write_long_series(std::filesystem::path const& file, std::size_t states, int samples) {
  std::vector<md::LjState> const all(states, md::LjState{.rho = 0.5, .T = 1.5});
  workflows::LjGridFile grid(file, all, {}, {.command = "test", .scene = "", .inputs = {}});
  std::mt19937_64 bits(3);
  std::normal_distribution<double> normal;
  std::vector<md::ThermoSample> series(static_cast<std::size_t>(samples));
  for (std::size_t k = 0; k < series.size(); ++k) {
    series[k].step = static_cast<std::int64_t>(20 * k), series[k].T = 1.5 + 0.01 * normal(bits);
    series[k].U = -2.5 + 0.02 * normal(bits), series[k].P = 0.75 + 0.05 * normal(bits);
  }
  for (std::size_t state = 0; state < states; ++state)
    grid.append(state, series);
  grid.close(true);
}

/// Blobs without a memory, of a melt or of isolated molecules at the temperature 1.
inline void write_many_blobs(std::filesystem::path const& file, std::string const& kind, int molecules,
                             int frames) {
  bool const melt = kind == "melt";
  workflows::BlobFileHead const head{
      .kind = kind,
      .name = "6-3",
      .fingerprint = "test",
      .molecules = molecules,
      .atoms = 19,
      .mass = 19,
      .rho = melt ? 0.3 : 0,
      .T = melt ? 0.0 : 1.0,
      .set = std::vector<double>(melt ? 0 : static_cast<unsigned>(molecules), 1.0)};
  workflows::BlobFile blobs(file, head, {.command = "test", .seed = 1, .scene = "", .inputs = {}});
  RandomBlobs random(std::cbrt(19 * molecules / 0.3), 5);
  std::vector<cg::BlobFrame> some; // each call waits for the disk
  for (int f = 0; f < frames; ++f) {
    some.push_back(random.frame(f, molecules));
    if (some.size() == 500 || f + 1 == frames)
      blobs.append(some), some.clear();
  }
  blobs.close();
}

/// Of a file of held 6-3 stars.
inline workflows::BlobFileHead held_head(int molecules) {
  return {.kind = "held",
          .name = "6-3",
          .fingerprint = "test",
          .molecules = molecules,
          .atoms = 19,
          .mass = 19,
          .rho = 0.3,
          .T = 1};
}

/// Forces on held molecules, without any between pairs.
inline void write_many_held(std::filesystem::path const& file, int molecules, int configurations,
                            int frames) {
  workflows::HeldFile held(file, held_head(molecules), frames,
                           {.command = "test", .seed = 1, .scene = "", .inputs = {}});
  RandomBlobs random(std::cbrt(19 * molecules / 0.3), 5);
  std::mt19937_64 bits(3);
  std::normal_distribution<double> normal;
  auto frame = random.frame(0, molecules);
  for (int k = 0; k < configurations * frames; ++k) {
    frame.step = k, frame.time = 0.02 * k;
    for (auto& blob : frame.blobs) // with a memory of two frames
      blob.U_kin = 27, blob.F = 0.6 * blob.F + 0.8 * Vec3{normal(bits), normal(bits), normal(bits)};
    held.append(frame);
  }
  held.close();
}

/// A text dump of dimers (tests/cases/dump/dimer.toml) on a lattice.
inline void write_long_dump(std::filesystem::path const& file, int frames) {
  constexpr int side = 12;
  std::string atoms;
  for (int m = 0; m < side * side * side; ++m)
    for (int a = 0; a < 2; ++a)
      atoms +=
          fmt::format("{} {} {} {} {} {} {}\n", 2 * m + a + 1, 2.5 * (m % side) + a, 2.5 * (m / side % side),
                      2.5 * (m / side / side), 0.1 * (m % 7), 0.1 * a, -0.1 * (m % 5));
  std::string text;
  for (int f = 0; f < frames; ++f)
    text += fmt::format("ITEM: TIMESTEP\n{}\nITEM: NUMBER OF ATOMS\n{}\nITEM: BOX BOUNDS pp pp pp\n"
                        "0 30\n0 30\n0 30\nITEM: ATOMS id x y z vx vy vz\n{}",
                        10 * f, 2 * side * side * side, atoms);
  workflows::write_text_file(file, text);
}

} // namespace mesobridge::tests
