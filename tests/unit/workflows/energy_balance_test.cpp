#include "piston_text.hpp"
#include "scratch_directory.hpp"
#include "workflows/sdpd/run_scene.hpp"
#include "workflows/sdpd/run_text.hpp"
#include "workflows/store/store.hpp"
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace mesobridge::workflows {
namespace {

Scene piston(std::string const& scheme) {
  return parse_scene(
      tests::piston_text({.scheme = scheme,
                          .run = "equilibrate = 20\nsteps = 64\nsample_every = 2\n[series]\nevery = "
                                 "2\nquantities = [\"wall_work\"]"}),
      "piston.toml");
}

RunResult run(Scene const& scene, std::filesystem::path const& folder) {
  return run_scene(scene, {.directory = folder});
}

/// By the work of the walls, which the run's file has beside the energies.
TEST(EnergyBalanceOfARun, IsWhatItMissesOverTheWorkOfThePiston) {
  tests::ScratchDirectory const scratch;
  auto const result = run(piston("dt = 0.04"), scratch.path());
  Store const store(scratch / "run.h5", Store::Mode::read);
  auto const names = store.read_text_attributes("thermodynamics", "columns");
  auto const rows = store.read_doubles("thermodynamics"), work = store.read_doubles("series/wall_work_J");
  auto const at = [&](std::string const& name, std::size_t row) {
    auto const place = std::ranges::find(names, name) - names.begin();
    return rows.at(row * names.size() + static_cast<std::size_t>(place));
  };
  std::size_t const n = rows.size() / names.size();
  ASSERT_EQ(n, 33u);
  ASSERT_EQ(work.size(), 2 * n); // of the piston and of the wall at rest
  double error = 0, given = 0, exchanged = 0;
  for (std::size_t k = 0; k < n; ++k) {
    double const W = work[2 * k] + work[2 * k + 1] - work[0] - work[1];
    double const E = at("kinetic_energy_J", k) + at("internal_energy_J", k) - at("kinetic_energy_J", 0) -
                     at("internal_energy_J", 0);
    error = std::max(error, std::abs(E - W)), given = std::max(given, std::abs(W));
    exchanged = std::max(exchanged, std::abs(at("internal_energy_J", k) - at("internal_energy_J", 0)));
  }
  EXPECT_GT(given, exchanged); // else the piston's work would not count
  double const share = result.summary["energy_balance_error"].get<double>();
  EXPECT_NEAR(share / (error / given), 1, 1e-6);
  EXPECT_NE(run_text(result).find("balance "), std::string::npos) << run_text(result);
}

TEST(EnergyBalanceOfARun, IsRoundingWhereTheEnergyIsKept) {
  tests::ScratchDirectory const scratch;
  auto const result = run(piston("dt = 0.04\nenergy = \"kept\""), scratch.path());
  EXPECT_LT(result.summary["energy_balance_error"].get<double>(), 1e-9);
}

} // namespace
} // namespace mesobridge::workflows
