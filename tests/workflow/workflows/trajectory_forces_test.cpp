#include "program.hpp"
#include "scratch_directory.hpp"
#include "workflows/command.hpp"
#include "workflows/star/blob_file.hpp"
#include "workflows/text_file.hpp"
#include <cmath>
#include <gtest/gtest.h>

namespace mesobridge::workflows {
namespace {

using tests::program;
using tests::ScratchDirectory;

/// A frame of two dimers whose atoms 2 and 3 are sqrt(1.01) apart, with or without the forces on atoms.
std::string dimers(int step, bool forces) {
  std::vector<std::string> const places{"3 2 1 1.0 2.0 5.0 0 0 0", "1 1 1 9.5 1.0 5.0 1 0 0",
                                        "4 2 1 2.2 2.0 5.0 0 2 0", "2 1 1 0.9 1.0 5.0 -1 0 0"};
  std::vector<std::string> const acting{" 1 20 300", " 4 50 600", " 0.5 0 -7", " -6 2 1"};
  auto text =
      fmt::format("ITEM: TIMESTEP\n{}\nITEM: NUMBER OF ATOMS\n4\nITEM: BOX BOUNDS pp pp pp\n0 10\n0 10\n"
                  "0 10\nITEM: ATOMS id mol type x y z vx vy vz{}\n",
                  step, forces ? " fx fy fz" : "");
  for (std::size_t k = 0; k < places.size(); ++k)
    text += places[k] + (forces ? acting[k] : "") + "\n";
  return text;
}

TEST(TrajectoryForces, OfADumpAreTaken) {
  ScratchDirectory const scratch;
  auto const blobs_of = [&](std::filesystem::path const& trajectory, std::filesystem::path const& folder) {
    return program({"cg", "blobs", trajectory.string(), "--mapping",
                    MESOBRIDGE_SOURCE_DIR "/tests/cases/dump/dimer.toml", "-o", folder.string(), "--json"});
  };
  write_text_file(scratch / "with.lammpstrj", dimers(0, true) + dimers(10, true));
  auto const with = blobs_of(scratch / "with.lammpstrj", scratch / "with");
  ASSERT_EQ(with.status, 0) << with.errors;
  auto const F = read_blob_forces(scratch / "with/blobs.h5");
  ASSERT_EQ(F.size(), 4u);
  EXPECT_EQ(norm(F[0] - Vec3{-2, 52, 601}), 0); // atoms 1 and 2
  EXPECT_EQ(norm(F[1] - Vec3{1.5, 20, 293}), 0);
  EXPECT_EQ(Json::parse(with.output)["forces"], "trajectory");
  EXPECT_NE(with.errors.find("not those of the mapping's laws"), std::string::npos) << with.errors;

  write_text_file(scratch / "without.lammpstrj", dimers(0, false));
  auto const without = blobs_of(scratch / "without.lammpstrj", scratch / "without");
  ASSERT_EQ(without.status, 0) << without.errors;
  auto const by_pairs = read_blob_forces(scratch / "without/blobs.h5");
  double const r2 = 1.01, s6 = std::pow(r2, -3), strength = 24 * (2 * s6 * s6 - s6) / r2;
  EXPECT_NEAR(norm(by_pairs[0] - strength * Vec3{-0.1, -1, 0}), 0, 1e-9 * strength);
  EXPECT_EQ(norm(by_pairs[0] + by_pairs[1]), 0);
  EXPECT_EQ(Json::parse(without.output)["forces"], "laws of the mapping");

  write_text_file(scratch / "mixed.lammpstrj", dimers(0, true) + dimers(10, false));
  auto const mixed = blobs_of(scratch / "mixed.lammpstrj", scratch / "mixed");
  EXPECT_EQ(mixed.status, 2);
  EXPECT_NE(mixed.errors.find("in some frames only"), std::string::npos) << mixed.errors;
  EXPECT_FALSE(std::filesystem::exists(scratch / "mixed/blobs.h5"));
}

} // namespace
} // namespace mesobridge::workflows
