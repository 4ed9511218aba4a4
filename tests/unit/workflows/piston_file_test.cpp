#include "md/units.hpp"
#include "scratch_directory.hpp"
#include "workflows/lj/piston_balance.hpp"
#include "workflows/lj/sample_piston.hpp"
#include <gtest/gtest.h>

namespace mesobridge::workflows {
namespace {

using tests::ScratchDirectory;

md::LjPistonSettings settings() {
  auto settings = argon_piston(md::Preset::quick, 1150, 500, 500);
  settings.cells_across = 2, settings.cells_along = 20;
  return settings;
}

md::PistonSlices slices(md::LjPistonSettings const& of, double time) {
  auto const n = std::size_t(of.slices());
  return {.step = 1,
          .time = time,
          .piston = of.v_P * time,
          .number = std::vector<double>(n, 2.0),
          .velocity = std::vector<double>(n, 1.5),
          .T = std::vector<double>(n, 4.0),
          .P = std::vector<double>(n, 7.0)};
}

TEST(PistonFile, HoldsArgonInSi) {
  ScratchDirectory const scratch;
  auto const of = settings();
  PistonFile file(scratch / "p.h5", info_of(of), {});
  file.append(slices(of, 0.5)), file.append(slices(of, 1));
  file.close(true);
  auto const data = read_piston(scratch / "p.h5");
  EXPECT_TRUE(data.complete);
  EXPECT_EQ(data.atoms, 320);
  EXPECT_NEAR(data.scale.v_P, 500, 1e-9);
  EXPECT_NEAR(data.scale.spacing / std::cbrt(6.64e-26 / 1150), 1, 1e-12);
  ASSERT_EQ(data.frames.size(), 2u);
  auto const& last = data.frames[1];
  EXPECT_NEAR(last.time / 2.1555e-12, 1, 1e-3); // sigma (m/epsilon)^(1/2)
  EXPECT_NEAR(last.piston / (500 * last.time), 1, 1e-12);
  EXPECT_NEAR(last.velocity[3] / (1.5 * std::sqrt(1.657e-21 / 6.64e-26)), 1, 1e-12);
  EXPECT_NEAR(last.T[3] / (4 * 1.657e-21 / 1.380649e-23), 1, 1e-12);
  EXPECT_NEAR(last.P[3] / (7 * 1.657e-21 / std::pow(3.405e-10, 3)), 1, 1e-12);
  // Two atoms in a slice as thick as one spacing, of an area of two cells of 4 atoms each way.
  double const area = std::pow(2 * std::cbrt(4 * 6.64e-26 / 1150), 2), width = 2 * data.scale.position[0];
  EXPECT_NEAR(last.rho[3] / (2 * 6.64e-26 / (area * width)), 1, 1e-9);
}

TEST(PistonFile, HoldsMeltsAsTheyAre) {
  ScratchDirectory const scratch;
  md::StarPistonSettings of;
  auto const n = std::size_t(of.slices());
  PistonFile file(scratch / "p.h5", info_of(of), {});
  md::PistonSlices slices{.step = 1,
                          .time = 0.2,
                          .piston = 0.1,
                          .number = std::vector<double>(n, 2 * 25 * 19.0), // twice as many as at rest
                          .velocity = std::vector<double>(n, 0.5),
                          .T = std::vector<double>(n, 1.1),
                          .P = std::vector<double>(n, 0.7)};
  slices.energy = 12.5;
  slices.molecules = {std::vector<double>(n, 50), std::vector<double>(n, 0.4), std::vector<double>(n, 0.9)};
  file.append(slices);
  file.close(true);
  auto const data = read_piston(scratch / "p.h5");
  EXPECT_EQ(data.units, UnitSystem::lj);
  EXPECT_EQ(data.atoms, of.atoms());
  EXPECT_EQ(data.scale.v_P, 0.5);
  EXPECT_NEAR(data.scale.spacing, std::pow(0.3, -1.0 / 3), 1e-12); // of beads
  EXPECT_NEAR(data.scale.position[1] - data.scale.position[0], std::cbrt(19 / 0.3), 1e-9);
  ASSERT_EQ(data.frames.size(), 1u);
  EXPECT_EQ(data.frames[0].time, 0.2);
  EXPECT_NEAR(data.frames[0].rho[5], 0.6, 1e-12);
  EXPECT_EQ(data.frames[0].T[5], 1.1);
  ASSERT_EQ(data.molecules.size(), 1u);
  EXPECT_EQ(data.molecules[0].T[5], 0.9);
  EXPECT_EQ(data.molecules[0].velocity[5], 0.4);
  EXPECT_EQ(data.molecules[0].P[5], 0.7);
  EXPECT_EQ(data.energy, std::vector<double>{12.5});
}

// Two slices 2 long of 3 x 5: in one unit of time the fluid gains 30 of energy before a piston at 0.5, 4 a
// unit of area, and, of the density 1, 2 (0.5 + 0.2) of momentum, while the far wall pushes with 2.5.
TEST(PistonFile, TellsTheWorkOfThePistonTwice) {
  PistonData data;
  data.atoms = 60, data.scale = {.position = {1, 3}, .v_P = 0.5, .spacing = 1};
  std::vector<double> const rho{1, 1}, P{9, 2.5}, T{1, 1};
  data.frames = {{1, 0.5, {0, 0}, rho, P, T}, {2, 1, {0.5, 0.2}, rho, P, T}};
  EXPECT_FALSE(balance_of(data)); // no energy
  data.energy = {100, 130};
  auto const balance = balance_of(data);
  ASSERT_TRUE(balance);
  EXPECT_NEAR(balance->by_energy, 4, 1e-12);
  EXPECT_NEAR(balance->by_momentum, 1.4 + 2.5, 1e-12);
}

TEST(PistonFile, IsReadAsFarAsItGoes) {
  ScratchDirectory const scratch;
  PistonFile(scratch / "p.h5", info_of(settings()), {}).close(false);
  auto const data = read_piston(scratch / "p.h5");
  EXPECT_FALSE(data.complete);
  EXPECT_TRUE(data.frames.empty());
  Store(scratch / "other.h5", Store::Mode::create).close();
  EXPECT_THROW(read_piston(scratch / "other.h5"), InputError);
  EXPECT_THROW(read_piston(scratch / "none.h5"), InputError);
}

} // namespace
} // namespace mesobridge::workflows
