#include "cg/entropy.hpp"
#include "md/star_vacuum.hpp"
#include "physics/cg/blob_run.hpp"
#include <cmath>

namespace mesobridge::cg::test {
namespace {

class StarVacuumTest : public BlobRun {
 protected:
  /// The frames that were put in safety.
  std::vector<BlobFrame> run(md::StarVacuumSettings settings, bool resume = false,
                             std::optional<std::int64_t> stop_at = {}) {
    settings.directory = folder_.path();
    md::sample_star_vacuum(world_, settings, resume, recorder(settings.star, stop_at));
    return safe_;
  }
};

/// A star of springs of rest length 0 without repulsion has an exact S(U) = (3N - 4) ln U.
constexpr md::StarPolymer harmonic{
    .arms = 3, .beads = 2, .k = 20, .arm_length = 0, .centre_length = 0, .repulsion = false};

TEST_F(StarVacuumTest, EveryRouteFindsTheExactEntropyOfAHarmonicStar) {
  auto const frames = run({.star = harmonic,
                           .levels = {0.8, 1.25},
                           .molecules = 200,
                           .dt = 0.002,
                           .redraw_every = 200,
                           .equilibration_steps = 4000,
                           .sampling_steps = 16000,
                           .sample_every = 200,
                           .seed = 3});
  ASSERT_EQ(frames.size(), 80u);
  std::vector<EnergySamples> samples;
  for (std::size_t level = 0; level < 2; ++level) {
    EnergySamples set{.beta = level == 0 ? 1 / 0.8 : 1 / 1.25,
                      .U = std::vector<std::vector<double>>(20, std::vector<double>{}),
                      .U_kin = std::vector<std::vector<double>>(20, std::vector<double>{}),
                      .beta_without = {}};
    for (std::size_t m = level; m < 200; m += 2)
      for (auto const& frame : frames) {
        EXPECT_LT(norm(frame.blobs[m].P), 1e-10) << "the centre of mass stays";
        set.U[m / 2 % 20].push_back(frame.blobs[m].U());
        set.U_kin[m / 2 % 20].push_back(frame.blobs[m].U_kin);
      }
    samples.push_back(std::move(set));
  }
  int const atoms = harmonic.atoms();
  double const n = 3 * atoms - 3;
  int cases = 0;
  for (auto route : {EntropyRoute::density, EntropyRoute::kinetic}) {
    auto const fit = fit_entropy(samples, route, atoms, {.order = 2});
    auto const T = fit.estimate([](auto const& c) { return c.T(17); });
    auto const C = fit.estimate([](auto const& c) { return c.C(17); });
    EXPECT_TRUE(agrees(T, 17 / (n - 1), 4)) << T.mean << " +- " << T.se << " for " << 17 / (n - 1);
    EXPECT_TRUE(agrees(C, n - 1, 4)) << C.mean << " +- " << C.se << " for " << n - 1;
    EXPECT_LT(C.se, 0.05 * n);
    ++cases;
  }
  EXPECT_EQ(cases, 2);
  Equipartition const equipartition(samples, atoms);
  EXPECT_TRUE(agrees(equipartition.T(17), 17.0 / (3 * atoms), 4)) << "low by the predicted part";
  EXPECT_FALSE(agrees(equipartition.T(17), 17 / (n - 1), 8));
}

TEST_F(StarVacuumTest, TheAngularMomentumTakesPartInTheEquilibrium) {
  auto const frames = run({.levels = {1.0},
                           .molecules = 216,
                           .dt = 0.002,
                           .redraw_every = 250,
                           .equilibration_steps = 500,
                           .sampling_steps = 500,
                           .sample_every = 250});
  // <L . I^-1 . L> = 3 T. For a star I is nearly round: I = (2/3) sum r^2.
  double sum = 0;
  for (int m = 0; m < 216; ++m) {
    Vec3 L;
    double r2 = 0;
    Vec3 const first = last_.q[std::size_t(m) * 19], centre = [&] {
      Vec3 mean;
      for (std::size_t i = 0; i < 19; ++i)
        mean += last_.box.minimum_image(last_.q[std::size_t(m) * 19 + i] - first) / 19;
      return mean;
    }();
    for (std::size_t i = std::size_t(m) * 19; i < std::size_t(m + 1) * 19; ++i) {
      Vec3 const r = last_.box.minimum_image(last_.q[i] - first) - centre, v = last_.v[i];
      L += Vec3{r.y * v.z - r.z * v.y, r.z * v.x - r.x * v.z, r.x * v.y - r.y * v.x};
      r2 += norm2(r);
    }
    sum += norm2(L) / (2.0 / 3 * r2);
  }
  EXPECT_NEAR(sum / 216, 3.0, 0.5) << "0 would mean that it is frozen";
}

TEST_F(StarVacuumTest, SetEnergiesAreKept) {
  auto const frames = run({.ensemble = md::VacuumEnsemble::microcanonical,
                           .levels = {32, 45},
                           .molecules = 64,
                           .equilibration_steps = 2000,
                           .sampling_steps = 2000,
                           .sample_every = 500});
  ASSERT_EQ(frames.size(), 4u);
  int molecules = 0;
  for (auto const& frame : frames)
    for (std::size_t m = 0; m < 64; ++m, ++molecules) {
      EXPECT_NEAR(frame.blobs[m].U(), m % 2 == 0 ? 32 : 45, 0.01);
      EXPECT_NEAR(frame.blobs[m].Phi, 0, 1e-9);
    }
  EXPECT_EQ(molecules, 256);
}

TEST_F(StarVacuumTest, AResumedRunEqualsTheUnbrokenOneBitForBit) {
  // Draws, samples and checkpoints at steps of their own; stopped while it thermalises, settles and samples.
  int frames = 0;
  for (auto const ensemble : {md::VacuumEnsemble::canonical, md::VacuumEnsemble::microcanonical}) {
    bool const canonical = ensemble == md::VacuumEnsemble::canonical;
    md::StarVacuumSettings const settings{.ensemble = ensemble,
                                          .levels = canonical ? std::vector{0.9, 1.1} : std::vector{36., 42.},
                                          .molecules = 16,
                                          .redraw_every = 70,
                                          .equilibration_steps = 300,
                                          .sampling_steps = 1000,
                                          .sample_every = 60,
                                          .checkpoint_every = 250,
                                          .seed = 8};
    auto const unbroken = run(settings);
    ASSERT_EQ(unbroken.size(), 16u);
    for (std::int64_t const stop_at : {200, 400, 1100}) {
      auto parts = run(settings, false, stop_at);
      EXPECT_LT(parts.size(), unbroken.size());
      auto const rest = run(settings, true);
      parts.insert(parts.end(), rest.begin(), rest.end());
      ASSERT_EQ(parts.size(), unbroken.size()) << "stopped at step " << stop_at;
      for (std::size_t k = 0; k < parts.size(); ++k, ++frames) {
        EXPECT_EQ(parts[k].step, unbroken[k].step);
        EXPECT_EQ(parts[k].energy, unbroken[k].energy);
        for (std::size_t m = 0; m < 16; ++m) {
          EXPECT_EQ(parts[k].blobs[m].R, unbroken[k].blobs[m].R);
          EXPECT_EQ(parts[k].blobs[m].U_kin, unbroken[k].blobs[m].U_kin);
          EXPECT_EQ(parts[k].blobs[m].U_pot, unbroken[k].blobs[m].U_pot);
        }
      }
    }
  }
  EXPECT_EQ(frames, 2 * 3 * 16);
}

TEST_F(StarVacuumTest, AnEnergyBelowThePotentialOneIsRefused) {
  // Springs of rest length 0, stretched as they start.
  EXPECT_THROW(run({.star = harmonic,
                    .ensemble = md::VacuumEnsemble::microcanonical,
                    .levels = {1},
                    .molecules = 8,
                    .equilibration_steps = 10,
                    .sampling_steps = 500}),
               PhysicsError);
}

} // namespace
} // namespace mesobridge::cg::test
