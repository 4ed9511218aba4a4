#include "md/metal_crystal.hpp"
#include "md/metal_piston.hpp"
#include "piston_slices.hpp"
#include <cmath>
#include <cstdio>
#include <gtest/gtest.h>
#include <numeric>
#include <unistd.h>

namespace mesobridge::md::test {
namespace {

std::filesystem::path log_file() {
  return std::filesystem::temp_directory_path() / fmt::format("mesobridge-metal-piston-{}.log", ::getpid());
}

/// Aluminium at 300 K, at about its density of zero pressure.
MetalPistonSettings small_settings() {
  auto settings = metal_piston_settings(Preset::quick, read_metal_potential("Al_zhou.eam.alloy", "Al"),
                                        Lattice::fcc, {2680, 300}, 2500, log_file());
  settings.cells_across = 4, settings.cells_along = 30;
  settings.equilibration_steps = 200;
  return settings;
}

std::vector<PistonSlices> run(MetalPistonSettings const& settings, std::int64_t steps) {
  return slices_of(settings.log_file, [&](PistonConsumers const& consumers) {
    return sample_metal_piston(MpiWorld(), settings, steps, consumers);
  });
}

/// The jump conditions bind what the slices say: mass and momentum go through the front, at P_0 about 0.
TEST(MetalPiston, DrivesAShockThatKeepsMassAndMomentum) {
  auto const settings = small_settings();
  auto const all = run(settings, 600);
  ASSERT_EQ(all.size(), 30u);
  EXPECT_EQ(settings.atoms(), 4 * 4 * 4 * 30);
  for (auto const& now : all)
    EXPECT_NEAR(std::accumulate(now.number.begin(), now.number.end(), 0.0), double(settings.atoms()), 64);
  auto const& last = all.back();
  double const v_P = settings.v_P / 100; // Angstrom/ps
  // Slices are a cell wide, 16 atoms across times 4. The piston has come 4 slices far, the front about 14; a
  // slice moves by some per cent of its own.
  EXPECT_NEAR(mean(last, last.velocity, 7, 10), v_P, 0.1 * v_P);
  EXPECT_NEAR(mean(last, last.velocity, 20, 29), 0, 0.03 * v_P);
  EXPECT_NEAR(mean(last, last.T, 18, 29), 300, 60);
  double const compression =
      std::accumulate(last.number.begin() + 7, last.number.begin() + 10, 0.0) / (3 * 64.0);
  EXPECT_GT(compression, 1.2);
  // rho_0 v_S v_P with v_S = v_P compression/(compression - 1), in bar.
  double const P = 2680 * settings.v_P * settings.v_P * compression / (compression - 1) * 1e-5;
  EXPECT_NEAR(mean(last, last.P, 7, 10) / P, 1, 0.12);
}

TEST(MetalPistonProbe, Prints) {
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    auto settings = small_settings();
    settings.seed = seed;
    auto const all = run(settings, 600);
    auto const& last = all.back();
    double const a = settings.length() / settings.cells_along, area = std::pow(a * settings.cells_across, 2);
    auto const momentum = [&](PistonSlices const& now) {
      double sum = 0;
      for (std::size_t s = 0; s < now.number.size(); ++s)
        sum += now.number[s] * now.velocity[s] * 100 * settings.potential.mass;
      return sum / area;
    };
    auto const P = [&](std::size_t from, std::size_t to) {
      return (momentum(all[to]) - momentum(all[from])) / ((all[to].time - all[from].time) * 1e-12) * 1e-5;
    };
    double T = 0, Pm = 0, vm = 0;
    int n = 0;
    for (std::size_t k = 24; k < 30; ++k, ++n) {
      int const first = int(all[k].piston * 1e-10 / a) + 3;
      T += mean(all[k], all[k].T, first, first + 3), Pm += mean(all[k], all[k].P, first, first + 3),
          vm += mean(all[k], all[k].velocity, first, first + 3);
    }
    std::printf("seed %d: piston %.2f cells; v %.4f (%.4f) T %.0f ahead v %.4f T %.1f P %.0f [mean %.0f] by momentum "
                "%.0f %.0f n %.0f dt %.3g\n",
                int(seed), last.piston * 1e-10 / a, mean(last, last.velocity, 7, 10) / 25, vm / n / 25, T / n,
                mean(last, last.velocity, 20, 29) / 25, mean(last, last.T, 18, 29), mean(last, last.P, 7, 10), Pm / n,
                P(9, 29), P(14, 29), std::accumulate(last.number.begin() + 7, last.number.begin() + 10, 0.0),
                settings.dt);
    if (seed == 1)
      for (std::size_t s = 0; s < 30; ++s)
        std::printf("%zu: n %.0f v %.3f T %.0f P %.0f\n", s, last.number[s], last.velocity[s] / 25, last.T[s], last.P[s]);
  }
}

TEST(MetalPiston, IsRefusedByName) {
  auto settings = small_settings();
  check(settings);
  auto const refused = [](auto change) {
    auto changed = small_settings();
    change(changed);
    EXPECT_THROW(check(changed), InputError);
  };
  refused([](auto& s) { s.lattice = Lattice::hcp; });
  refused([](auto& s) { s.ahead.rho = 1; });
  refused([](auto& s) { s.v_P = -1; });
  refused([](auto& s) { s.cells_along = 3; });
  refused([](auto& s) { s.ahead.T = std::nan(""); });
}

} // namespace
} // namespace mesobridge::md::test
