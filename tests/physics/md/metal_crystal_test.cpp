#include "md/metal_crystal.hpp"
#include "md/units.hpp"
#include "temporary_log.hpp"
#include <cmath>
#include <gtest/gtest.h>

namespace mesobridge::md::test {
namespace {

class MetalCrystalTest : public ::testing::Test {
 protected:
  void TearDown() override { std::filesystem::remove(log_); }
  MetalCrystal crystal(MetalPotential const& potential) {
    return {world_, potential, potential.lattice, log_};
  }

  MpiWorld world_;
  std::filesystem::path log_ = tests::temporary_log("crystal");
};

TEST_F(MetalCrystalTest, LatticeConstantAndCohesiveEnergyAreThePublishedOnes) {
  struct Case {
    char const* file;
    double constant_A, cohesive_eV;
  };
  // Mishin et al., Phys. Rev. B 63, 224106 (2001); Foiles, Baskes and Daw, Phys. Rev. B 33, 7983 (1986);
  // Mendelev et al., Philos. Mag. 83, 3977 (2003) (Fe) and 88, 1723 (2008) (Al).
  int cases = 0;
  for (Case const& c :
       {Case{"Cu_mishin1.eam.alloy", 3.615, -3.54}, Case{"Cu_u3.eam", 3.615, -3.54},
        Case{"Ag_u3.eam", 4.09, -2.85}, Case{"Au_u3.eam", 4.08, -3.93}, Case{"Ni_u3.eam", 3.52, -4.45},
        Case{"Pd_u3.eam", 3.89, -3.91}, Case{"Pt_u3.eam", 3.92, -5.77}, Case{"Fe_mm.eam.fs", 2.8553, -4.122},
        Case{"Al_mm.eam.fs", 4.045, -3.41}}) {
    auto const potential = read_metal_potential(c.file, "");
    auto const ground = crystal(potential).at_zero_pressure();
    double const constant = CrystalBlock(potential.lattice, 1).lattice_constant(ground.rho / potential.mass);
    EXPECT_NEAR(constant * 1e10, c.constant_A, 0.001) << c.file;
    EXPECT_NEAR(ground.e * potential.mass / metal_units::energy, c.cohesive_eV, 0.002) << c.file;
    EXPECT_LT(std::abs(ground.P), 1e3);
    ++cases;
  }
  EXPECT_EQ(cases, 9);
}

TEST_F(MetalCrystalTest, BulkModulusOfCopperIsThePublishedOne) {
  auto const potential = read_metal_potential("Cu_mishin1.eam.alloy", "");
  auto copper = crystal(potential);
  double const rho = copper.at_zero_pressure().rho, c = copper.bulk_sound_speed(rho);
  EXPECT_NEAR(rho * c * c / 1e9, 138.3, 0.5); // Mishin et al. (2001), Table II
}

/// By Bain's way: face-centred cells squeezed to c/a = sqrt(1/2) are body-centred ones, turned by 45 degrees.
TEST_F(MetalCrystalTest, SqueezedAlongZByTheRootOfTwoFccIsBcc) {
  auto const potential = read_metal_potential("Cu_u3.eam", "");
  auto fcc = crystal(potential);
  MetalCrystal bcc(world_, potential, Lattice::bcc, tests::temporary_log("crystal-bcc"));
  double const rho0 = fcc.at_zero_pressure().rho, rho = std::sqrt(2.0) * rho0;
  auto const squeezed = fcc.squeezed_along_z(rho0, rho), expected = bcc.at(rho);
  EXPECT_NEAR(squeezed.e / expected.e, 1, 1e-9);
  EXPECT_NEAR(squeezed.P / expected.P, 1, 1e-6);
  EXPECT_GT(squeezed.e, fcc.at(rho).e);
  EXPECT_NEAR(fcc.squeezed_along_z(rho0, rho0).e / fcc.at(rho0).e, 1, 1e-12);
  EXPECT_THROW(fcc.squeezed_along_z(rho0, -1), InputError);
}

/// P_zz = rho^2 de/drho at a fixed area.
TEST_F(MetalCrystalTest, ThePressureAlongZIsTheSlopeOfTheEnergyOfSqueezedCrystals) {
  auto const potential = read_metal_potential("Fe_mm.eam.fs", "");
  auto iron = crystal(potential);
  double const rho0 = iron.at_zero_pressure().rho, step = 1e-4;
  for (double const compression : {1.03, 1.1, 1.2}) {
    double const rho = compression * rho0;
    double const slope =
        (iron.squeezed_along_z(rho0, rho * (1 + step)).e - iron.squeezed_along_z(rho0, rho * (1 - step)).e) /
        (2 * step * rho);
    double const P = iron.squeezed_along_z(rho0, rho).P;
    EXPECT_NEAR(rho * rho * slope / P, 1, 1e-4) << compression;
    EXPECT_GT(std::abs(P / iron.at(rho).P - 1), 0.01) << compression; // some of it is shear stress
  }
}

TEST_F(MetalCrystalTest, ThePressureIsTheSlopeOfTheEnergy) {
  int cases = 0;
  for (char const* file : {"Cu_mishin1.eam.alloy", "Fe_mm.eam.fs", "Mg_mm.eam.fs"}) {
    auto const potential = read_metal_potential(file, "");
    auto metal = crystal(potential);
    double const rho0 = metal.at_zero_pressure().rho, step = 1e-4;
    for (double compression : {0.95, 1.03, 1.1, 1.2}) {
      double const rho = compression * rho0;
      double const slope = (metal.at(rho * (1 + step)).e - metal.at(rho * (1 - step)).e) / (2 * step * rho);
      double const P = metal.at(rho).P;
      EXPECT_NEAR(rho * rho * slope / P, 1, 1e-4)
          << file << " at " << compression; // P = -dE/dV = rho^2 de/drho
      ++cases;
    }
  }
  EXPECT_EQ(cases, 12);
}

TEST_F(MetalCrystalTest, AnUnstableCrystalIsRefused) {
  auto const potential = read_metal_potential("Cu_mishin1.eam.alloy", "");
  auto copper = crystal(potential);
  EXPECT_THROW(copper.bulk_sound_speed(5500), PhysicsError); // beyond the spinodal of stretching
  EXPECT_THROW(copper.at(std::nan("")), InputError);
  EXPECT_THROW(copper.at(-1), InputError);
}

} // namespace
} // namespace mesobridge::md::test
