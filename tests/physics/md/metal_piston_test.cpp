#include "md/metal_crystal.hpp"
#include "md/metal_piston.hpp"
#include "piston_slices.hpp"
#include "temporary_log.hpp"
#include <cmath>
#include <gtest/gtest.h>
#include <numeric>

namespace mesobridge::md::test {
namespace {

std::filesystem::path log_file() {
  return tests::temporary_log("metal-piston");
}

/// Aluminium at 300 K, at about its density of zero pressure.
MetalPistonSettings small_settings() {
  auto settings = metal_piston_settings(Preset::quick, read_metal_potential("Al_zhou.eam.alloy", "Al"),
                                        Lattice::fcc, {2680, 300}, 2500, log_file());
  settings.cells_across = 4, settings.cells_along = 30;
  settings.equilibration_steps = 200;
  return settings;
}

/// The jump conditions bind what the slices say: mass and momentum go through the front, at P_0 about 0.
TEST(MetalPiston, DrivesAShockThatKeepsMassAndMomentum) {
  auto const settings = small_settings();
  auto const all = slices_of(sample_metal_piston, settings, 600);
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
