#include "error_text.hpp"
#include "scratch_directory.hpp"
#include "workflows/metal/hugoniot_reference.hpp"
#include "workflows/metal/metal_table.hpp"
#include "workflows/text_file.hpp"
#include <gtest/gtest.h>

namespace mesobridge::workflows {
namespace {

cg::HugoniotPoint point(double v_P, double v_S) {
  double const rho0 = 2700, rho = rho0 * v_S / (v_S - v_P);
  return {.initial = {rho0, 300},
          .rho = rho,
          .v_P = {v_P, 3, 50},
          .v_S = {v_S, 10, 50},
          .T = {300 + v_P, 5, 50},
          .P = {rho0 * v_S * v_P, 2e7, 50},
          .e = {1e6, 1e3, 50}};
}

TEST(HugoniotReference, LiesBetweenThePointsAboutIt) {
  tests::ScratchDirectory const scratch;
  auto const file = scratch / "hugoniot.csv";
  std::vector<cg::HugoniotPoint> const points{point(2000, 8000), point(1000, 6700)}; // in any order
  write_text_file(file, hugoniot_csv(points));
  auto const found = read_hugoniot_reference(file, {2700, 300}, 1250);
  EXPECT_NEAR(found.v_S.mean, 6700 + 0.25 * 1300, 1e-6);
  EXPECT_NEAR(found.v_S.se, std::hypot(0.75 * 10, 0.25 * 10), 1e-9);
  EXPECT_NEAR(found.T.mean, 1550, 1e-6);
  double const rho_1 = 2700 * 6700.0 / 5700, rho_2 = 2700 * 8000.0 / 6000; // their v_P is known to 3 m/s
  EXPECT_NEAR(found.rho.mean, 0.75 * rho_1 + 0.25 * rho_2, 1e-6);
  EXPECT_NEAR(found.rho.se, (rho_2 - rho_1) / 1000 * std::hypot(0.75 * 3, 0.25 * 3), 1e-9);
  EXPECT_NEAR(found.P.mean, 2700 * (0.75 * 6700e3 + 0.25 * 16000e3), 1);
  auto const error = [&](std::filesystem::path const& of, double rho0, double v_P, double T0 = 300) {
    return tests::error_text<InputError>([&] { read_hugoniot_reference(of, {rho0, T0}, v_P); });
  };
  EXPECT_NE(error(file, 2700, 1250, 500).find("same --T0"), std::string::npos);
  EXPECT_NE(error(file, 2700, 2500).find("both sides of --vp = 2500"), std::string::npos);
  EXPECT_NE(error(file, 2800, 1250).find("same --rho0"), std::string::npos);
  write_text_file(scratch / "other.csv", "a,b\n1,2\n");
  EXPECT_NE(error(scratch / "other.csv", 2700, 1250).find("no column"), std::string::npos);
}

TEST(HugoniotReference, TellsDeviationsInCommonStandardErrors) {
  HugoniotReference const reference{{7000, 30, 1}, {3000, 0, 1}, {20e9, 3e8, 1}, {1000, 30, 1}};
  ShockOfRun const shock{
      .measured = {.v_S = {7100, 40, 20}, .rho = {1, 1, 1}, .P = {19e9, 4e8, 20}, .T = {1000, 40, 20}},
      .mass_per_volume = {3030, 10, 20}};
  auto const json = reference_json(reference, shock);
  EXPECT_NEAR(json["deviation"]["v_S"].get<double>(), 2, 1e-12);
  EXPECT_NEAR(json["deviation"]["rho"].get<double>(), 3, 1e-12);
  EXPECT_NEAR(json["deviation"]["P"].get<double>(), -2, 1e-12);
  EXPECT_NEAR(json["deviation"]["T"].get<double>(), 0, 1e-12);
}

/// Copper squeezed along <100> by 1.34 is nearly body-centred, with 0.0278 eV an atom more than face-centred
/// copper of that density: colder, denser and slower behind a piston. The shifts are those of a script of its
/// own from static crystals of LAMMPS at four densities.
TEST(HugoniotReference, OfACrystalThatIsSqueezedAlongZIsColderDenserAndSlower) {
  tests::ScratchDirectory const scratch;
  HugoniotReference const even{{5876, 5, 1}, {11814, 5, 1}, {77.63e9, 1e7, 1}, {1272, 5, 1}};
  md::MetalPistonSettings const settings{.potential = md::read_metal_potential("Cu_u3.eam", ""),
                                         .ahead = {8799.38, 300},
                                         .v_P = 1500,
                                         .log_file = scratch / "lammps.log"};
  auto const along = squeezed_along_z(even, settings);
  EXPECT_NEAR(along.v_S.mean - even.v_S.mean, -30.23, 0.3);
  EXPECT_NEAR(along.rho.mean - even.rho.mean, 19.82, 0.2);
  EXPECT_NEAR(along.P.mean - even.P.mean, -0.3990e9, 4e6);
  EXPECT_NEAR(along.T.mean - even.T.mean, -131.9, 1);
  EXPECT_EQ(along.T.se, even.T.se);
}

} // namespace
} // namespace mesobridge::workflows
