#include "error_text.hpp"
#include "md/lj_fluid.hpp"
#include "md/metal_crystal.hpp"
#include "temporary_log.hpp"
#include <fstream>
#include <gtest/gtest.h>
#include <unistd.h>

namespace mesobridge::md::test {
namespace {

class PotentialFile {
 public:
  PotentialFile(std::string const& ending, std::string const& text)
      : path_(std::filesystem::temp_directory_path() / fmt::format("mesobridge-{}{}", ::getpid(), ending)) {
    std::ofstream(path_) << text;
  }
  ~PotentialFile() { std::filesystem::remove(path_); }
  std::string path() const { return path_.string(); }

 private:
  std::filesystem::path path_;
};

TEST(MetalPotential, ReadsTheHeadersOfAllFormats) {
  struct Case {
    char const *file, *element, *style, *expected;
    Lattice lattice;
    double mass_u, constant_A, cutoff_A;
  };
  int cases = 0;
  for (Case const& c :
       {Case{"Cu_mishin1.eam.alloy", "", "eam/alloy", "Cu", Lattice::fcc, 63.55, 3.615, 5.50679},
        Case{"Cu_u3.eam", "", "eam", "Cu", Lattice::fcc, 63.55, 3.615, 4.95},
        Case{"Fe_mm.eam.fs", "Fe", "eam/fs", "Fe", Lattice::bcc, 55.845, 2.855324, 5.3},
        Case{"CoAl.eam.alloy", "Al", "eam/alloy", "Al", Lattice::fcc, 26.982, 4.05, 5.600044},
        Case{"CoAl.eam.alloy", "Co", "eam/alloy", "Co", Lattice::hcp, 58.9332, 2.507, 5.600044}}) {
    auto const potential = read_metal_potential(c.file, c.element);
    EXPECT_EQ(potential.style, c.style);
    EXPECT_EQ(potential.element, c.expected);
    EXPECT_EQ(potential.lattice, c.lattice);
    EXPECT_NEAR(potential.mass / 1.66053906660e-27, c.mass_u, 1e-3);
    EXPECT_NEAR(potential.lattice_constant * 1e10, c.constant_A, 1e-6);
    EXPECT_NEAR(potential.cutoff * 1e10, c.cutoff_A, 1e-5);
    EXPECT_GT(potential.density_at(0.9 * potential.lattice_constant), 0);
    EXPECT_EQ(potential.density_at(1.01 * potential.cutoff), 0);
    ++cases;
  }
  EXPECT_EQ(cases, 5);
}

TEST(MetalPotential, TheDensityIsThatOfTheFileAndOfItsOwnElement) {
  // Two elements; the second's tables are 3, 4, 5 (embedding), then densities 30, 40, 50, 60 with itself in
  // fs.
  std::string const head = "a\nb\nc\n2 Xx Yy\n3 0.5 4 1.0 3.0\n";
  PotentialFile const alloy(".eam.alloy",
                            head + "1 10.0 3.0 bcc 0 1 2 7 8 9 10\n2 20.0 4.0 fcc 3 4 5 30 40 50 60\n");
  auto const second = read_metal_potential(alloy.path(), "Yy");
  EXPECT_EQ(second.density, (std::vector<double>{30, 40, 50, 60}));
  EXPECT_DOUBLE_EQ(second.density_at(1.5e-10), 45);
  EXPECT_DOUBLE_EQ(second.largest_density, 1.0);
  PotentialFile const fs(".eam.fs", head + "1 10.0 3.0 bcc 0 1 2 7 8 9 10 17 18 19 20\n"
                                           "2 20.0 4.0 fcc 3 4 5 70 80 90 100 30 40 50 60\n");
  EXPECT_EQ(read_metal_potential(fs.path(), "Yy").density, (std::vector<double>{30, 40, 50, 60}));
  EXPECT_EQ(read_metal_potential(fs.path(), "Xx").density, (std::vector<double>{7, 8, 9, 10}));
}

TEST(MetalPotential, RefusesWithTheFileAndTheReason) {
  PotentialFile const cut(".eam.alloy", "a\nb\nc\n1 Xx\n3 0.5 4 1.0 3.0\n1 10.0 3.0 bcc 0 1 2 7 8\n");
  PotentialFile const diamond(".alloy", "a\nb\nc\n1 Si\n3 0.5 3 1.0 3.0\n1 10.0 3.0 dia 0 1 2 7 8 9\n");
  PotentialFile const nonsense(".eam", "a\nwords 1\n");
  PotentialFile const other(".meam", "a\n");
  struct Case {
    std::string file, element, text;
  };
  int cases = 0;
  for (Case const& c :
       {Case{"/no/such.eam.alloy", "", "'/no/such.eam.alloy'"},
        Case{"no-such.eam.alloy", "", "/usr/share/lammps/potentials/no-such.eam.alloy"},
        Case{"Cu_mishin1.eam.alloy", "Sn", "has no element 'Sn'; it has Cu"},
        Case{"Cu_u3.eam", "Ni", "has no element 'Ni'; it has Cu"},
        Case{"CoAl.eam.alloy", "", "it has Co, Al"},
        Case{cut.path(), "", "has no electron density where it should"},
        Case{diamond.path(), "", "must be fcc, bcc or hcp"},
        Case{nonsense.path(), "", "has no atomic number"}, Case{other.path(), "", "must end in .eam"},
        Case{"", "", "must be the name of a file"}}) {
    auto const text = tests::error_text([&] { read_metal_potential(c.file, c.element); });
    EXPECT_NE(text.find(c.text), std::string::npos) << text;
    ++cases;
  }
  EXPECT_EQ(cases, 10);
}

TEST(MetalPotential, CountsTheAtomsBeyondTheTable) {
  MpiWorld const world;
  auto const log = tests::temporary_log("table");
  auto potential = read_metal_potential("Cu_mishin1.eam.alloy", "");
  LammpsSession lammps(world, Ranks::own, log);
  CrystalBlock(Lattice::fcc, 256).create(lammps, potential, stated_density(potential));
  auto const frame = lammps.frame();
  // A density function of 1 out to a distance between the first 12 and the next 6 neighbours.
  potential.density.assign(1000, 1.0);
  potential.spacing = 3.0e-10 / 1000;
  potential.largest_density = 12.5;
  EXPECT_EQ(part_beyond_table(potential, frame), 0.0);
  potential.largest_density = 11.5;
  EXPECT_EQ(part_beyond_table(potential, frame), 1.0);
  std::filesystem::remove(log);
}

TEST(CrystalBlock, IsWhatLammpsBuilds) {
  MpiWorld const world;
  auto const log = tests::temporary_log("block");
  int cases = 0;
  for (auto const& [file, lattice] : {std::pair{"Cu_mishin1.eam.alloy", Lattice::fcc},
                                      {"Fe_mm.eam.fs", Lattice::bcc},
                                      {"Mg_mm.eam.fs", Lattice::hcp}}) {
    auto const potential = read_metal_potential(file, "");
    double const rho = 1.1 * stated_density(potential), n = rho / potential.mass;
    CrystalBlock const block(lattice, 200);
    EXPECT_GE(block.atoms(), 200);
    EXPECT_LT(block.atoms(), 400);
    LammpsSession lammps(world, Ranks::own, log);
    block.create(lammps, potential, rho);
    auto const frame = lammps.frame();
    ASSERT_EQ(int(frame.positions.size()), block.atoms());
    EXPECT_NEAR(block.atoms() * potential.mass / (frame.box.volume() * 1e-30) / rho, 1, 1e-9);
    double nearest = 1e9;
    int neighbours = 0;
    for (int round = 0; round < 2; ++round)
      for (std::size_t j = 1; j < frame.positions.size(); ++j) {
        double const r = norm(frame.box.minimum_image(frame.positions[0] - frame.positions[j])) * 1e-10;
        nearest = std::min(nearest, r);
        neighbours += round == 1 && r < 1.001 * nearest;
      }
    EXPECT_NEAR(block.neighbour_distance(n) / nearest, 1, 1e-6);
    EXPECT_EQ(neighbours, lattice == Lattice::bcc ? 8 : 12);
    EXPECT_NEAR(lattice_order(frame, block.plane_distances(n) * 1e10), 1, 1e-6);
    ++cases;
  }
  EXPECT_EQ(cases, 3);
  std::filesystem::remove(log);
}

} // namespace
} // namespace mesobridge::md::test
