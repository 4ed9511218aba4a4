#include "cg/blobs.hpp"
#include "md/molecule_melt.hpp"
#include "md/star_melt.hpp"
#include "scratch_directory.hpp"
#include <cmath>
#include <fmt/os.h>
#include <gtest/gtest.h>

// Blobs of any molecules: the energies that LAMMPS tells of the inside of molecules against those that are
// written down here term by term, and against those of stars, whose laws the program knows itself.

namespace mesobridge::cg::test {
namespace {

std::filesystem::path const examples = MESOBRIDGE_SOURCE_DIR "/workflows/scenes/molecules";

void write(std::filesystem::path const& file, std::string const& text) {
  fmt::output_file(file.string()).print("{}", text);
}

/// Butane whose end atoms interact by half: a short cut-off makes small boxes large enough.
char const* const butane = R"(units real
pair_style lj/cut 9
pair_modify mix arithmetic shift yes
pair_coeff 1 1 0.19475 3.75
pair_coeff 2 2 0.09141 3.95
bond_style harmonic
bond_coeff 1 268 1.54
angle_style harmonic
angle_coeff 1 62.1 114
dihedral_style opls
dihedral_coeff 1 1.41103 -0.27101 3.14503 0
special_bonds lj 0 0 0.5
)";

/// Chains of ten beads that have come together from a thin start.
md::MoleculeMeltSettings chain_melt(std::filesystem::path const& folder, int equilibration, int sampling) {
  return {.data = examples / "chain.data",
          .forces = examples / "chain.settings",
          .replicate = {3, 3, 3},
          .rho = 0.25,
          .dt = 0.005,
          .squeeze_steps = 400,
          .equilibration_steps = equilibration,
          .sampling_steps = sampling,
          .checkpoint_every = 600,
          .directory = folder};
}

class MoleculesTest : public ::testing::Test {
 protected:
  /// The frames of a run, stopped at a step; `blobs_` and `last_` are what it gave.
  void run(md::MoleculeMeltSettings const& settings, bool resume = false,
           std::optional<std::int64_t> stop_at = {}) {
    md::MoleculeMelt const melt(settings);
    BlobMaker maker(model_of(melt.system().molecules.kind, energy_of_mv2(melt.system().units)));
    mass_ = maker.model().mass();
    blobs_.clear(), safe_.clear();
    md::StarConsumers const consumers{
        .frames =
            [&](md::MoleculeFrame const& frame) {
              last_ = frame;
              blobs_.push_back(gather_blobs(world_, frame, maker.blobs(frame)));
            },
        .checkpoint = [&] { safe_ = blobs_; },
        .steps = [&](std::int64_t done, std::int64_t) { return !stop_at || done < *stop_at; }};
    md::sample_molecules(world_, melt, resume, consumers);
  }

  double energy_of_mv2(std::string const& units) {
    md::LammpsSession lammps(world_, md::Ranks::own, folder_ / "units.log");
    lammps.command("units {}", units);
    return lammps.unit_constants().energy_of_mv2;
  }

  /// The molecules' energies together are LAMMPS's, which stays what it is; the molecules touch.
  void expect_sums(double kept) const {
    ASSERT_GE(blobs_.size(), 3u);
    for (auto const& frame : blobs_) {
      double size = 0, Phi = 0;
      Vec3 momentum, force;
      for (auto const& blob : frame.blobs) {
        size += blob.U_kin + norm2(blob.P) / (2 * mass_) + std::abs(blob.U_pot) + std::abs(blob.Phi);
        Phi += std::abs(blob.Phi);
        momentum += blob.P, force += blob.F;
      }
      EXPECT_NEAR(total_energy(frame.blobs, mass_), frame.energy, 1e-12 * size);
      EXPECT_NEAR(frame.energy, blobs_[0].energy, kept * size);
      EXPECT_LT(norm(momentum), 1e-8 * mass_);
      EXPECT_LT(norm(force), 1e-8);
      EXPECT_GT(Phi, 1e-4 * size);
    }
  }

  std::vector<Vec3> joined(std::size_t molecule) const {
    auto const n = std::size_t(last_.atoms_per_molecule);
    std::vector<Vec3> q(last_.q.begin() + std::ptrdiff_t(molecule * n),
                        last_.q.begin() + std::ptrdiff_t((molecule + 1) * n));
    for (std::size_t i = 1; i < n; ++i)
      q[i] = q[i - 1] + last_.box.minimum_image(q[i] - q[i - 1]);
    return q;
  }

  md::MpiWorld world_;
  tests::ScratchDirectory folder_;
  std::vector<BlobFrame> blobs_, safe_; ///< all, and those of the last checkpoint
  md::MoleculeFrame last_;
  double mass_ = 0;
};

TEST_F(MoleculesTest, OfAStarAreTheStarsOwnBlobs) {
  BlobMaker own(model_of(md::StarPolymer{}));
  md::StarMeltSettings const settings{.molecules = 64,
                                      .rho = 0.3,
                                      .squeeze_steps = 200,
                                      .equilibration_steps = 500,
                                      .sampling_steps = 200,
                                      .checkpoint_every = 200,
                                      .directory = folder_.path()};
  md::MoleculeFrame frame;
  md::sample_star_melt(world_, settings, false,
                       {.frames = [&](md::MoleculeFrame const& now) { frame = now; }});
  auto const expected = own.blobs(frame);

  auto system = md::read_molecule_system(examples / "star.data", examples / "star.settings", {});
  system.molecules = md::replicated(system.molecules, {4, 4, 4});
  BlobMaker told(model_of(system.molecules.kind, 1));
  md::InsideEnergies inside(world_, system, folder_.path());
  inside.add_to(frame);
  EXPECT_NEAR(frame.reach, md::wca_cutoff(), 1e-4);
  auto const blobs = told.blobs(frame);
  ASSERT_EQ(blobs.size(), 64u);
  int touching = 0;
  for (std::size_t m = 0; m < blobs.size(); ++m) {
    EXPECT_NEAR(blobs[m].U_kin, expected[m].U_kin, 1e-10);
    EXPECT_NEAR(blobs[m].U_pot, expected[m].U_pot, 1e-10);
    EXPECT_NEAR(blobs[m].Phi, expected[m].Phi, 1e-10);
    EXPECT_LT(norm(blobs[m].P - expected[m].P), 1e-10);
    EXPECT_LT(norm(blobs[m].F - expected[m].F), 1e-10);
    EXPECT_LT(norm(blobs[m].R - expected[m].R), 1e-10);
    touching += expected[m].Phi > 0.01;
  }
  EXPECT_GT(touching, 30);
}

/// The energy of one butane molecule, term by term.
double energy_of_butane(std::vector<Vec3> const& q) {
  auto const cross = [](Vec3 const& a, Vec3 const& b) {
    return Vec3{a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
  };
  double energy = 0;
  for (std::size_t i = 0; i + 1 < 4; ++i)
    energy += 268 * std::pow(norm(q[i + 1] - q[i]) - 1.54, 2);
  for (std::size_t i = 0; i + 2 < 4; ++i) {
    Vec3 const a = q[i] - q[i + 1], b = q[i + 2] - q[i + 1];
    energy += 62.1 * std::pow(std::acos(dot(a, b) / (norm(a) * norm(b))) - 114 * std::acos(-1.0) / 180, 2);
  }
  Vec3 const m = cross(q[1] - q[0], q[2] - q[1]), n = cross(q[2] - q[1], q[3] - q[2]);
  double const phi = std::acos(dot(m, n) / (norm(m) * norm(n)));
  energy += 1.41103 / 2 * (1 + std::cos(phi)) - 0.27101 / 2 * (1 - std::cos(2 * phi)) +
            3.14503 / 2 * (1 + std::cos(3 * phi));
  double const s6 = std::pow(3.75, 6), r6 = std::pow(norm(q[3] - q[0]), 6), c6 = std::pow(9.0, 6);
  auto const lj = [&](double d6) { return 4 * 0.19475 * (s6 * s6 / (d6 * d6) - s6 / d6); };
  return energy + 0.5 * (lj(r6) - lj(c6));
}

md::MoleculeMeltSettings butane_melt(std::filesystem::path const& folder) {
  write(folder / "butane.settings", butane);
  return {.data = examples / "butane.data",
          .forces = folder / "butane.settings",
          .replicate = {3, 3, 3},
          .rho = 0.018,
          .squeeze_steps = 400,
          .equilibration_steps = 400,
          .sampling_steps = 300,
          .sample_every = 100,
          .checkpoint_every = 100,
          .seed = 3,
          .directory = folder};
}

TEST_F(MoleculesTest, OfButaneHaveTheEnergiesOfOneMolecule) {
  run(butane_melt(folder_.path()));
  expect_sums(1e-3);
  ASSERT_EQ(last_.inside.size(), 27u);
  EXPECT_NEAR(last_.reach, 9, 1e-4);
  for (std::size_t m = 0; m < 27; ++m)
    EXPECT_NEAR(last_.inside[m], energy_of_butane(joined(m)), 1e-9 * std::abs(last_.inside[m])) << m;
  EXPECT_NEAR(mass_, 58.124 * 2390.0573615, 1e-4);
}

TEST_F(MoleculesTest, OfButaneHaveTheEnergyThatLammpsGivesOneAlone) {
  run(butane_melt(folder_.path()));
  for (std::size_t m = 0; m < 27; m += 5) {
    auto alone = md::read_molecule_system(examples / "butane.data", folder_ / "butane.settings", {});
    alone.molecules.box = {{200, 200, 200}};
    auto q = joined(m);
    for (Vec3 const first = q[0]; Vec3 & atom : q)
      atom += Vec3{100, 100, 100} - first;
    md::write_data_file(folder_ / "alone.data", alone.molecules.kind, q, alone.molecules.box);
    md::LammpsSession lammps(world_, md::Ranks::own, folder_ / "alone.log");
    lammps.command("units real");
    lammps.command("atom_style molecular");
    for (auto const& line : alone.forces.lines())
      if (line.words[0] == "special_bonds" || line.words[0].ends_with("_style"))
        lammps.command(line.text());
    lammps.command_with_file("read_data", folder_ / "alone.data");
    for (auto const& line : alone.forces.lines())
      if (line.words[0].ends_with("_coeff") || line.words[0] == "pair_modify")
        lammps.command(line.text());
    lammps.command("run 0");
    EXPECT_NEAR(lammps.thermo("pe"), last_.inside[m], 1e-9 * std::abs(last_.inside[m])) << m;
  }
}

TEST_F(MoleculesTest, HaveTheEnergiesAndForcesOfTheirRunFromTheirPlacesAlone) {
  auto const settings = butane_melt(folder_.path());
  run(settings);
  auto system = md::MoleculeMelt(settings).system();
  md::write_data_file(folder_ / "melt.data", system.molecules.kind, system.molecules.q, system.molecules.box);
  auto const told = md::read_molecule_system(folder_ / "melt.data", settings.forces, {});
  md::FrameEnergies whole(world_, told, md::FrameEnergies::Of::whole_system, folder_.path());
  for (int twice = 0; twice < 2; ++twice) {
    auto const found = whole.of(last_.q, last_.box);
    EXPECT_NEAR(found.reach, 9, 1e-4);
    double touching = 0;
    for (std::size_t i = 0; i < last_.q.size(); ++i) {
      EXPECT_NEAR(found.potential[i], last_.potential[i], 1e-9) << i;
      EXPECT_LT(norm(found.f[i] - last_.f[i]), 1e-7) << i;
      touching += norm(last_.f[i]);
    }
    EXPECT_GT(touching, 1);
  }
}

TEST_F(MoleculesTest, OfChainsWithFeneBondsAddUp) {
  run(chain_melt(folder_.path(), 2000, 600));
  expect_sums(1e-3);
  for (std::size_t m = 0; m < 27; ++m) {
    auto const q = joined(m);
    double energy = 0;
    auto const wca = [](double r) {
      return r < md::wca_cutoff() ? 4 * (std::pow(r, -12) - std::pow(r, -6)) + 1 : 0;
    };
    for (std::size_t a = 0; a < q.size(); ++a)
      for (std::size_t b = a + 1; b < q.size(); ++b) {
        double const r = norm(q[a] - q[b]);
        energy += wca(r);
        if (b == a + 1)
          energy -= 0.5 * 30 * 1.5 * 1.5 * std::log(1 - r * r / (1.5 * 1.5));
      }
    EXPECT_NEAR(last_.inside[m], energy, 1e-9 * energy);
  }
}

TEST_F(MoleculesTest, OfChainsHaveLammpssEnergiesByOurOwnLawsToo) {
  run(chain_melt(folder_.path(), 200, 200));
  MoleculeModel model{.masses = std::vector<double>(10, 1.0),
                      .types = std::vector<int>(10, 0),
                      .pairs = {PairLaw(1, 1, md::wca_cutoff(), true)},
                      .type_count = 1,
                      .bonds = {},
                      .excluded = {}};
  for (int a = 0; a < 9; ++a) {
    model.bonds.push_back({a, a + 1, BondLaw::fene(30, 1.5, 1, 1)});
    model.excluded.emplace_back(a, a + 1);
  }
  auto frame = last_;
  frame.inside.clear(); // LAMMPS's word
  auto const blobs = BlobMaker(model).blobs(frame);
  ASSERT_EQ(blobs.size(), 27u);
  for (std::size_t m = 0; m < blobs.size(); ++m)
    EXPECT_NEAR(blobs[m].U_pot, last_.inside[m], 1e-9 * last_.inside[m]) << m;
}

TEST(BondLaw, OfAFeneBondEndsAtItsGreatestLength) {
  auto const law = BondLaw::fene(30, 1.5, 1, 1);
  EXPECT_GT(law.energy(1.4999), 200);
  EXPECT_THROW(law.energy(1.5), PhysicsError);
  EXPECT_THROW(law.energy(2), PhysicsError);
}

TEST_F(MoleculesTest, ResumedEqualTheUnbrokenOnesBitForBit) {
  run(butane_melt(folder_.path()));
  auto const unbroken = blobs_;
  tests::ScratchDirectory const elsewhere;
  auto const settings = butane_melt(elsewhere.path());
  md::MoleculeMelt const melt(settings);
  auto const all = md::plan(melt.protocol(), 4 / std::pow(8.4, 3)).back();
  run(settings, false, all.first_step - 50); // in the middle of the second stretch of sampling
  auto whole = safe_;
  EXPECT_EQ(whole.size(), 1u);
  run(settings, true);
  whole.insert(whole.end(), blobs_.begin(), blobs_.end());
  ASSERT_EQ(whole.size(), unbroken.size());
  for (std::size_t k = 0; k < whole.size(); ++k) {
    EXPECT_EQ(whole[k].step, unbroken[k].step);
    EXPECT_EQ(whole[k].energy, unbroken[k].energy);
    for (std::size_t m = 0; m < whole[k].blobs.size(); ++m) {
      auto const &a = whole[k].blobs[m], &b = unbroken[k].blobs[m];
      EXPECT_EQ(a.R.x, b.R.x);
      EXPECT_EQ(a.P.y, b.P.y);
      EXPECT_EQ(a.U_pot, b.U_pot);
      EXPECT_EQ(a.Phi, b.Phi);
    }
  }
}

} // namespace
} // namespace mesobridge::cg::test
