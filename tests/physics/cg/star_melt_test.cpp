#include "md/star_melt.hpp"
#include "md/star_system.hpp"
#include "md/star_width.hpp"
#include "physics/cg/blob_run.hpp"
#include <algorithm>
#include <cmath>

namespace mesobridge::cg::test {
namespace {

/// A melt of 64 6-3 stars that runs in a second.
md::StarMeltSettings small_melt(std::filesystem::path const& directory) {
  return {.molecules = 64,
          .rho = 0.2,
          .squeeze_steps = 400,
          .equilibration_steps = 1000,
          .sampling_steps = 600,
          .sample_every = 100,
          .checkpoint_every = 300,
          .seed = 5,
          .directory = directory};
}

/// The energy of two beads, written down anew: WCA.
double wca(double r2) {
  return r2 < std::cbrt(2.0) ? 4 * (std::pow(r2, -6) - std::pow(r2, -3)) + 1 : 0;
}

/// The force on a bead at a separation r from another.
Vec3 wca_force(Vec3 const& r) {
  double const r2 = norm2(r);
  return r2 < std::cbrt(2.0) ? r * ((48 * std::pow(r2, -6) - 24 * std::pow(r2, -3)) / r2) : Vec3{};
}

class StarMeltTest : public BlobRun {
 protected:
  std::vector<BlobFrame> run(md::StarMeltSettings const& settings, bool resume,
                             std::optional<std::int64_t> stop_at = {}) {
    md::sample_star_melt(world_, settings, resume, recorder(settings.star, stop_at));
    return stop_at ? safe_ : frames_;
  }

  /// The blobs' energies against that of LAMMPS in every frame, and those of the last frame against sums over
  /// all pairs of atoms.
  void expect_sums(md::StarMeltSettings const& settings, std::vector<BlobFrame> const& frames) const {
    auto const atoms = std::size_t(settings.star.atoms()), molecules = std::size_t(settings.molecules);
    for (auto const& frame : frames) {
      ASSERT_EQ(frame.blobs.size(), molecules);
      EXPECT_NEAR(total_energy(frame.blobs, double(atoms)), frame.energy, 1e-9 * std::abs(frame.energy));
      Vec3 momentum;
      for (auto const& blob : frame.blobs)
        momentum += blob.P;
      EXPECT_LT(norm(momentum), 1e-10);
    }
    auto const& blobs = frames.back().blobs;
    int interactions = 0;
    for (std::size_t m = 0; m < molecules; ++m) {
      double inside = 0, outside = 0;
      Vec3 force;
      for (std::size_t i = m * atoms; i < (m + 1) * atoms; ++i)
        for (std::size_t j = 0; j < last_.q.size(); ++j) {
          Vec3 const r = last_.box.minimum_image(last_.q[i] - last_.q[j]);
          bool const same = j / atoms == m;
          if (i == j || norm2(r) > 1.3)
            continue;
          (same ? inside : outside) += wca(norm2(r)) / 2;
          if (!same)
            force += wca_force(r), ++interactions;
        }
      for (auto const& bond : settings.star.bonds())
        inside += 10 * std::pow(norm(last_.box.minimum_image(last_.q[m * atoms + std::size_t(bond.a)] -
                                                             last_.q[m * atoms + std::size_t(bond.b)])) -
                                    bond.l,
                                2);
      EXPECT_NEAR(blobs[m].U_pot, inside, 1e-9);
      EXPECT_NEAR(blobs[m].Phi, outside, 1e-9);
      EXPECT_LT(norm(blobs[m].F - force), 1e-8) << "only other molecules push a centre of mass";
    }
    EXPECT_GT(interactions, 50) << "the molecules touch";
  }
};

TEST_F(StarMeltTest, BlobsAddUpAndAgreeWithAnIndependentSum) {
  auto const settings = small_melt(folder_.path());
  auto const frames = run(settings, false);
  ASSERT_EQ(frames.size(), 6u);
  for (auto const& frame : frames) {
    EXPECT_NEAR(frame.energy, frames[0].energy, 1e-4 * std::abs(frame.energy)) << "NVE";
    EXPECT_NEAR(frame.box.volume(), 64 * 19 / 0.2, 1e-6);
  }
  expect_sums(settings, frames);
}

TEST_F(StarMeltTest, BlobsAddUpWhenSomeAreWiderThanHalfTheBox) {
  auto settings = small_melt(folder_.path());
  settings.T = 5, settings.rho = 0.32;
  auto const frames = run(settings, false);
  std::ptrdiff_t wide = 0;
  for (auto const& frame : frames)
    wide += std::ranges::count_if(frame.blobs,
                                  [&](auto const& blob) { return blob.width > frame.box.edge.x / 2; });
  EXPECT_GT(wide, 0);
  expect_sums(settings, frames);
}

TEST_F(StarMeltTest, TheSmallestBoxHoldsItsStars) {
  struct Case {
    md::StarPolymer star;
    double T;
  };
  std::vector<Case> const cases{{{.arms = 1, .beads = 6}, 1}, {{.arms = 2, .beads = 1}, 5},
                                {{.arms = 2, .beads = 8}, 1}, {{.arms = 4, .beads = 1}, 1},
                                {{.arms = 6, .beads = 3}, 1}, {{.arms = 12, .beads = 4}, 1}};
  for (auto const& [star, T] : cases) {
    auto settings = small_melt(folder_.path());
    settings.star = star, settings.T = T, settings.sampling_steps = 3000;
    double const edge = md::smallest_edge(star, T);
    settings.molecules = std::max(8, int(std::ceil(1.01 * settings.rho * edge * edge * edge / star.atoms())));
    auto const frames = run(settings, false); // throws if one meets its own image
    double mean = 0;
    for (auto const& frame : frames)
      for (auto const& blob : frame.blobs)
        mean += blob.width / double(frames.size() * frame.blobs.size());
    auto const width = md::star_width(star, T);
    EXPECT_LT(mean, width.mean) << star.name();
    EXPECT_GT(mean, 0.6 * width.mean) << star.name() << ": no wider than it need be";
    settings.molecules = int(0.95 * settings.rho * edge * edge * edge / star.atoms());
    EXPECT_THROW(md::check(settings), InputError) << star.name();
  }
}

TEST_F(StarMeltTest, AResumedRunEqualsTheUnbrokenOneBitForBit) {
  auto const unbroken = run(small_melt(folder_.path()), false);
  tests::ScratchDirectory elsewhere;
  auto const settings = small_melt(elsewhere.path());
  std::int64_t const all = md::plan(settings).back().first_step + 300;
  auto before = run(settings, false, all - 200); // in the middle of the last stretch
  auto const after = run(settings, true);
  EXPECT_EQ(before.size(), 3u);
  before.insert(before.end(), after.begin(), after.end());
  ASSERT_EQ(before.size(), unbroken.size());
  for (std::size_t k = 0; k < unbroken.size(); ++k) {
    EXPECT_EQ(before[k].step, unbroken[k].step);
    EXPECT_EQ(before[k].energy, unbroken[k].energy);
    EXPECT_EQ(before[k].time, double(before[k].step) * settings.dt);
    for (std::size_t m = 0; m < 64; ++m) {
      EXPECT_EQ(before[k].blobs[m].R, unbroken[k].blobs[m].R);
      EXPECT_EQ(before[k].blobs[m].U_kin, unbroken[k].blobs[m].U_kin);
    }
  }
}

TEST_F(StarMeltTest, AnUnstableTimeStepEndsWithOneClearMessage) {
  auto settings = small_melt(folder_.path());
  settings.dt = 0.02;
  settings.T = 10;
  std::string text;
  try {
    run(settings, false);
  } catch (PhysicsError const& error) {
    text = error.what();
  }
  EXPECT_NE(text.find("--dt"), std::string::npos) << text;
  EXPECT_NE(text.find("0.02"), std::string::npos) << text;
}

TEST_F(StarMeltTest, StarsThatWouldOverlapAtTheStartAreRefused) {
  md::LammpsSession lammps(world_, md::Ranks::all, folder_.path() / "log");
  md::prepare_for_stars(lammps, {});
  try {
    md::create_stars(world_, lammps, {.molecules = 8, .spacing = 5}, folder_.path() / "data");
    FAIL() << "accepted";
  } catch (InputError const& error) {
    EXPECT_NE(std::string(error.what()).find("overlap"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("at least 8.9"), std::string::npos) << error.what();
  }
}

TEST(Blobs, AMoleculeAcrossTheBordersIsJoined) {
  BlobMaker maker(model_of({.arms = 2, .beads = 1}));
  Box const box{{10, 10, 10}};
  std::vector<Vec3> const v(3), f(3), inside{{5, 5, 5}, {6.5, 5, 5}, {3.5, 5, 5}};
  auto across = inside;
  for (Vec3& q : across)
    q = box.wrap(q + Vec3{5, 5, 5});
  auto const here = maker.blob(inside, v, f, {}, box), there = maker.blob(across, v, f, {}, box);
  EXPECT_NEAR(here.U_pot, there.U_pot, 1e-12);
  EXPECT_NEAR(here.U_pot, 2 * 10 * 0.115 * 0.115, 1e-12);
  EXPECT_LT(norm(box.minimum_image(there.R - here.R - Vec3{5, 5, 5})), 1e-12);
  EXPECT_NEAR(there.width, 3, 1e-12);
}

TEST(Blobs, MoleculesThatTheBoxCannotHoldAreRefused) {
  auto model = model_of({.arms = 2, .beads = 1});
  Box const box{{10, 10, 10}};
  auto const refusal = [&](double arm) {
    std::vector<Vec3> const v(3), f(3), q{{5, 5, 5}, {5 + arm, 5, 5}, {5 - arm, 5, 5}};
    try {
      BlobFrame frame{.box = box, .blobs = {BlobMaker(model).blob(q, v, f, {}, box)}};
      frame.blobs.push_back({.width = 3});
      refuse_large_molecules(frame);
    } catch (PhysicsError const& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(refusal(3.4), "") << "one of two";
  EXPECT_NE(refusal(3.6).find("5.1 wide on average, more than half of the box, 10"), std::string::npos);
  EXPECT_NE(refusal(4.43).find("on average"), std::string::npos) << "the WCA potential reaches 1.122";
  EXPECT_NE(refusal(4.45).find("its own image. Take a larger box (more molecules)"), std::string::npos);
  model.bonds.pop_back();
  EXPECT_EQ(refusal(2.4), "");
  EXPECT_NE(refusal(2.6).find("bonds do not join"), std::string::npos);
}

} // namespace
} // namespace mesobridge::cg::test
