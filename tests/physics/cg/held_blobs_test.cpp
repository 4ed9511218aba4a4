#include "md/held_blobs.hpp"
#include "md/star_checkpoint.hpp"
#include "physics/cg/blob_run.hpp"
#include <cmath>

namespace mesobridge::cg::test {
namespace {

/// 64 6-3 stars, held in three configurations, in a second.
md::HeldBlobsSettings small_run(std::filesystem::path const& directory) {
  md::HeldBlobsSettings settings;
  settings.molecules = 64, settings.rho = 0.2, settings.seed = 5, settings.directory = directory;
  settings.squeeze_steps = 400, settings.equilibration_steps = 1000, settings.checkpoint_every = 200;
  settings.sampling_steps = 500, settings.free_steps = 300, settings.configurations = 3;
  return settings;
}

class HeldBlobsTest : public BlobRun {
 protected:
  std::vector<BlobFrame> run(md::HeldBlobsSettings const& settings, bool resume,
                             std::optional<std::int64_t> stop_at = {}) {
    md::sample_held_blobs(world_, settings, resume, recorder(settings.star, stop_at));
    return stop_at ? safe_ : frames_;
  }
};

/// The force of the WCA potential on a bead at a separation r from another.
Vec3 push(Vec3 const& r) {
  double const r2 = norm2(r);
  return r2 < std::cbrt(2.0) ? r * ((48 * std::pow(r2, -6) - 24 * std::pow(r2, -3)) / r2) : Vec3{};
}

TEST_F(HeldBlobsTest, CentresStandAndEnergyStays) {
  auto const frames = run(small_run(folder_.path()), false);
  ASSERT_EQ(frames.size(), 300u);
  int moved = 0;
  double heat = 0;
  for (std::size_t k = 0; k < frames.size(); ++k) {
    auto const &frame = frames[k], &first = frames[k - k % 100];
    EXPECT_NEAR(total_energy(frame.blobs, 19), frame.energy, 1e-9 * std::abs(frame.energy));
    EXPECT_NEAR(frame.energy, first.energy, 2e-3 * std::abs(first.energy)) << k;
    for (std::size_t m = 0; m < 64; ++m) {
      EXPECT_LT(norm(frame.blobs[m].P), 1e-9) << k;
      EXPECT_LT(norm(frame.box.minimum_image(frame.blobs[m].R - first.blobs[m].R)), 1e-9) << k;
      moved += k % 100 == 0 && k > 0 && norm(frame.blobs[m].R - frames[k - 1].blobs[m].R) > 0.1;
      heat += frame.blobs[m].U_kin;
    }
    EXPECT_GT(std::abs(frame.blobs[0].U_kin - first.blobs[0].U_kin), k % 100 == 0 ? -1 : 1e-6);
  }
  EXPECT_GT(moved, 64) << "free between the configurations";
  EXPECT_NEAR(heat / (300 * 64) / 27, 1, 0.05) << "3 * 18/2 k_B T";
}

TEST_F(HeldBlobsTest, ForcesAreThoseOfTheOtherMolecules) {
  auto const frames = run(small_run(folder_.path()), false);
  int interactions = 0;
  for (std::size_t m = 0; m < 64; ++m) {
    Vec3 force;
    for (std::size_t i = 19 * m; i < 19 * (m + 1); ++i)
      for (std::size_t j = 0; j < last_.q.size(); ++j)
        if (j / 19 != m)
          force += push(last_.box.minimum_image(last_.q[i] - last_.q[j]));
    EXPECT_LT(norm(frames.back().blobs[m].F - force), 1e-8 * (1 + norm(force)));
    interactions += norm(force) > 1;
  }
  EXPECT_GT(interactions, 20);
}

TEST_F(HeldBlobsTest, AResumedRunEqualsTheUnbrokenOneBitForBit) {
  auto const unbroken = run(small_run(folder_.path()), false);
  for (std::int64_t const before_end :
       {700, 1000}) { // in the second configuration, and in the free way to it
    tests::ScratchDirectory elsewhere;
    auto const settings = small_run(elsewhere.path());
    auto before = run(settings, false, md::steps_of(md::plan(settings)) - before_end);
    auto const after = run(settings, true);
    ASSERT_LT(before.size(), unbroken.size());
    ASSERT_GT(before.size(), 90u);
    before.insert(before.end(), after.begin(), after.end());
    ASSERT_EQ(before.size(), unbroken.size());
    for (std::size_t k = 0; k < unbroken.size(); ++k) {
      EXPECT_EQ(before[k].step, unbroken[k].step);
      EXPECT_EQ(before[k].energy, unbroken[k].energy);
      for (std::size_t m = 0; m < 64; ++m) {
        EXPECT_EQ(before[k].blobs[m].F, unbroken[k].blobs[m].F);
        EXPECT_EQ(before[k].blobs[m].U_kin, unbroken[k].blobs[m].U_kin);
      }
    }
  }
}

TEST_F(HeldBlobsTest, SettingsThatMakeNoSenseAreRefused) {
  auto settings = small_run(folder_.path());
  settings.configurations = 0;
  EXPECT_THROW(md::check(settings), InputError);
  settings = small_run(folder_.path()), settings.free_steps = 0;
  EXPECT_THROW(md::check(settings), InputError);
  settings = small_run(folder_.path()), settings.sampling_steps = 501;
  EXPECT_THROW(md::check(settings), InputError);
  EXPECT_NO_THROW(md::check(small_run(folder_.path())));
}

} // namespace
} // namespace mesobridge::cg::test
