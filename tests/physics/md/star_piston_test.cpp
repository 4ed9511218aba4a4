#include "md/star_piston.hpp"
#include "piston_slices.hpp"
#include "temporary_log.hpp"
#include <cmath>
#include <gtest/gtest.h>
#include <numeric>

namespace mesobridge::md::test {
namespace {

StarPistonSettings small_settings() {
  StarPistonSettings settings;
  settings.star = star_of_name("3-1");
  settings.across = 5, settings.along = 30;
  settings.equilibration_steps = 1500, settings.squeeze_steps = 400;
  settings.log_file = tests::temporary_log("star-piston");
  return settings;
}

double sum(std::vector<double> const& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

double momentum(PistonSlices const& now) {
  return std::inner_product(now.number.begin(), now.number.end(), now.velocity.begin(), 0.0);
}

/// The piston pushes with the force F, the far wall with P_0 A: d(momentum)/dt = F - P_0 A and
/// d(energy)/dt = v_P F. F is thus known twice; behind the front it is P A.
TEST(StarPiston, WorkIsTheGainOfEnergy) {
  auto const settings = small_settings();
  auto const all = slices_of(sample_star_piston, settings, 3000);
  ASSERT_EQ(all.size(), 60u);
  int const n = settings.slices();
  double P_0 = 0, P_1 = 0, T_centres = 0, T_atoms = 0;
  std::size_t const from = 15;
  for (std::size_t k = from; k < all.size(); ++k) {
    auto const part = 1 / double(all.size() - from);
    P_0 += part * std::accumulate(all[k].P.begin() + n - 10, all[k].P.end(), 0.0) / 10;
    T_centres += part * mean(all[k], all[k].molecules.T, n - 10, n);
    T_atoms += part * mean(all[k], all[k].T, n - 10, n);
  }
  for (std::size_t k = 40; k < all.size(); ++k)
    P_1 += mean(all[k], all[k].P, 4, 7) / 20;
  auto const &first = all[from], &last = all.back();
  double const time = last.time - first.time, area = std::pow(settings.across * settings.spacing(), 2);
  double const by_energy = (last.energy - first.energy) / (settings.v_P * area * time),
               by_momentum = (momentum(last) - momentum(first)) / (area * time) + P_0;
  EXPECT_NEAR(by_energy / by_momentum, 1, 0.02);
  EXPECT_NEAR(P_1 / by_energy, 1, 0.1);
  EXPECT_NEAR(T_centres, settings.T, 0.1);
  EXPECT_NEAR(T_atoms, settings.T, 0.05);
  for (auto const& now : all) {
    EXPECT_NEAR(sum(now.number), double(settings.atoms()), 1);
    EXPECT_EQ(sum(now.molecules.number), double(settings.molecules())); // whole, none across a wall
  }
}

TEST(StarPiston, EndsWhenTheFrontIsAtTheFarEnd) {
  auto settings = small_settings();
  settings.across = 5, settings.along = 14, settings.v_P = 2, settings.equilibration_steps = 200;
  auto const all = slices_of(sample_star_piston, settings, 100000);
  ASSERT_FALSE(all.empty());
  EXPECT_LT(all.back().piston, settings.length() / 2);
  EXPECT_GT(mean(all.back(), all.back().velocity, 6, 14), 1);
  EXPECT_LT(mean(all[all.size() - 2], all[all.size() - 2].velocity, 6, 14), 1);
}

TEST(StarPiston, IsRefusedByName) {
  MpiWorld const world;
  auto const refused = [&](auto change) {
    auto settings = small_settings();
    change(settings);
    EXPECT_THROW(sample_star_piston(world, settings, 100, {}), InputError);
  };
  refused([](auto& of) { of.rho = 0.9; });
  refused([](auto& of) { of.v_P = 0; });
  refused([](auto& of) { of.across = 2; });
  refused([](auto& of) { of.along = 5; });
  refused([](auto& of) { of.T = std::nan(""); });
}

} // namespace
} // namespace mesobridge::md::test
