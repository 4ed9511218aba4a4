#include "md/molecule_forces.hpp"
#include "md/molecule_melt.hpp"
#include "scratch_directory.hpp"
#include <fmt/os.h>
#include <gtest/gtest.h>

namespace mesobridge::md::test {
namespace {

void write(std::filesystem::path const& file, std::string const& text) {
  fmt::output_file(file.string()).print("{}", text);
}

/// Two trimers, one across the border of the box, with their atoms in no order.
std::string const two_trimers = R"(two trimers

6 atoms
4 bonds
2 angles
2 atom types
1 bond types
1 angle types
0 10 xlo xhi
-5 5 ylo yhi
0 10 zlo zhi

Masses

1 2.5  # ends
2 3

Bond Coeffs # harmonic

1 10 1.5

Atoms # molecular

12 7 1 9.5 0 5
10 7 1 1.5 0 5 1 0 0
11 7 2 0.5 0 5
4 3 2 5 0 5
3 3 1 4 0 5
5 3 1 6 0 5

Bonds

1 1 4 3
2 1 4 5
3 1 10 11
4 1 12 11

Angles

1 1 5 4 3
2 1 10 11 12
)";

std::string const forces = R"(units lj
pair_style lj/cut 2.5 # a comment
pair_coeff * * 1 &
  1
bond_style harmonic
angle_style harmonic
angle_coeff 1 5 180
)";

class MoleculeFiles : public ::testing::Test {
 protected:
  MoleculeSystem read(std::string const& data, std::string const& settings,
                      MoleculeStyles const& styles = {}) {
    write(folder_ / "t.data", data);
    write(folder_ / "t.settings", settings);
    return read_molecule_system(folder_ / "t.data", folder_ / "t.settings", styles);
  }

  static std::string replaced(std::string text, std::string const& from, std::string const& to) {
    auto const at = text.find(from);
    EXPECT_NE(at, text.npos) << from;
    return text.replace(at, from.size(), to);
  }

  std::string refusal(std::string const& data, std::string const& settings,
                      MoleculeStyles const& styles = {}) {
    try {
      read(data, settings, styles);
    } catch (InputError const& error) {
      return error.what();
    }
    return "not refused";
  }

  tests::ScratchDirectory folder_;
};

TEST_F(MoleculeFiles, AreReadWhateverTheOrderOfTheirAtoms) {
  auto const system = read(two_trimers, forces);
  auto const& [kind, count, box, ids, q] = system.molecules;
  EXPECT_EQ(count, 2);
  EXPECT_EQ(ids.size(), 6u);
  EXPECT_EQ(kind.name, "t");
  EXPECT_EQ(kind.atom_style, "molecular");
  EXPECT_EQ(kind.types, (std::vector<int>{1, 2, 1}));
  EXPECT_EQ(kind.masses(), (std::vector<double>{2.5, 3, 2.5}));
  ASSERT_EQ(kind.bonded[0].size(), 2u);
  EXPECT_EQ(kind.bonded[0][1].atoms, (std::array<std::int64_t, 4>{1, 2, 0, 0}));
  ASSERT_EQ(kind.bonded[1].size(), 1u);
  EXPECT_EQ(box.edge.y, 10);
  ASSERT_EQ(q.size(), 6u);
  EXPECT_EQ(q[0].y, 5) << "from the corner of the box";
  EXPECT_EQ(q[3].x, 1.5);
  EXPECT_EQ(q[5].x, -0.5) << "joined across the border";
  EXPECT_EQ(mean_width(system.molecules), 2);
  ASSERT_EQ(system.coefficients.size(), 1u);
  EXPECT_EQ(system.coefficients[0].text(), "bond_coeff 1 10 1.5");
  ASSERT_EQ(system.forces.lines().size(), 5u);
  EXPECT_EQ(system.forces.lines()[1].text(), "pair_coeff * * 1 1") << "a line that goes on";
  EXPECT_EQ(system.units, "lj");
  auto const more = replicated(system.molecules, {1, 2, 3});
  EXPECT_EQ(more.count, 12);
  EXPECT_EQ(more.box.edge.z, 30);
  EXPECT_EQ(more.q.back().y, q.back().y + 10);
}

TEST_F(MoleculeFiles, ThatAreWrittenReadBack) {
  auto const system = read(replaced(two_trimers, "# molecular", "# angle"), forces);
  write_data_file(folder_ / "again.data", system.molecules.kind, system.molecules.q, system.molecules.box);
  auto const again = equal_molecules(read_data_file(folder_ / "again.data", ""));
  EXPECT_EQ(again.kind.types, system.molecules.kind.types);
  EXPECT_EQ(again.kind.bonded, system.molecules.kind.bonded);
  EXPECT_EQ(again.kind.atom_style, "angle");
  for (std::size_t i = 0; i < again.q.size(); ++i)
    EXPECT_LT(norm(again.box.minimum_image(again.q[i] - system.molecules.q[i])), 1e-12) << i;
}

TEST_F(MoleculeFiles, ChargesAndMassesOfTheSettingsCount) {
  std::string charged = two_trimers;
  for (char const* of : {"7 1 9.5", "7 1 1.5", "3 1 4", "3 1 6"})
    charged = replaced(charged, of, std::string(of).insert(3, " 0.25"));
  for (char const* of : {"7 2 0.5", "3 2 5"})
    charged = replaced(charged, of, std::string(of).insert(3, " -0.5"));
  charged = replaced(charged, "# molecular", "");
  auto const system = read(charged, forces + "mass 2 4\n");
  EXPECT_EQ(system.molecules.kind.atom_style, "full") << "by the number of columns";
  EXPECT_EQ(system.molecules.kind.charges, (std::vector<double>{0.25, -0.5, 0.25}));
  EXPECT_EQ(system.molecules.kind.masses(), (std::vector<double>{2.5, 4, 2.5}));
  EXPECT_NE(
      refusal(replaced(charged, "-0.5", "-0.4"), forces).find("the charge of its atom 2, -0.4 and -0.5"),
      std::string::npos);
}

TEST_F(MoleculeFiles, OfWrongDataAreRefusedByName) {
  struct Case {
    char const *from, *to, *said;
  };
  std::vector<Case> const cases{
      {"4 3 2 5 0 5", "4 3 1 5 0 5", "molecule 7 differs from molecule 3 in the type of its atom 2, 2 and 1"},
      {"4 3 2 5 0 5", "4 0 2 5 0 5", "t.data: molecule of atom 4 = 0: must be > 0"},
      {"5 3 1 6", "5 7 1 6", "joins atoms 4 and 5 of the molecules 3 and 7"},
      {"5 3 1 6 0 5", "5 3 1 6 0", "t.data:29: an atom of the style molecular has 6 columns"},
      {"5 3 1 6 0 5", "5 3 3 6 0 5", "atom type = 3: must be 1 ... 2"},
      {"5 3 1 6 0 5", "5 3 1 nan 0 5", "t.data:29: x = 'nan': must be a finite number"},
      {"5 3 1 6 0 5\n", "", "atoms = 5: must be 6"},
      {"5 3 1 6 0 5", "4 3 1 6 0 5", "atom 4 is there twice"},
      {"3 1 10 11", "3 1 10 12", "differs from molecule 3 in its bonds"},
      {"3 1 10 11", "3 1 10 99", "atom of a bond = 99: no atom has this number"},
      {"2 1 10 11 12\n", "", "angles = 1: must be 2"},
      {"2 3\n", "", "mass of atom type 2: must be there"},
      {"2 3\n", "2 -3\n", "mass = -3"},
      {"0 10 zlo zhi\n", "", "must have edges > 0"},
      {"0 10 zlo zhi", "0 10 zlo", "'0 10 zlo' is not understood"},
      {"Angles\n", "Ellipsoids\n", "section 'Ellipsoids'"},
      {"# molecular", "# charge", "atom style 'charge': must be bond, angle, molecular or full"}};
  for (auto const& [from, to, said] : cases)
    EXPECT_NE(refusal(replaced(two_trimers, from, to), forces).find(said), std::string::npos)
        << said << ": " << refusal(replaced(two_trimers, from, to), forces);
  EXPECT_EQ(cases.size(), 17u);
  EXPECT_THROW(read_data_file(folder_ / "none.data", ""), InputError);
  EXPECT_THROW(read_data_file(folder_.path(), ""), InputError);
}

TEST_F(MoleculeFiles, OfSettingsThatDoMoreThanForcesAreRefusedByNameAndLine) {
  struct Case {
    char const *line, *said;
  };
  std::vector<Case> const cases{
      {"run 100", "t.settings:8: 'run' is no command of a force field"},
      {"fix 1 all nve", "'fix' is no command"},
      {"minimize 1 1 1 1", "'minimize'"},
      {"velocity all create 1 1", "'velocity'"},
      {"shell rm -r x", "'shell'"},
      {"include other.in", "'include'"},
      {"read_data t.data", "the data file is the command's first argument"},
      {"kspace_style pppm 1e-4", "a sum on a mesh has no part inside a molecule"},
      {"pair_style lj/cut/coul/long 9", "pair style 'lj/cut/coul/long': a long-range sum"},
      {"pair_style hybrid lj/cut 9 coul/msm 9", "'coul/msm'"},
      {"pair_modify shift yes tail yes", "belongs to no molecule"},
      {"neigh_modify every 1 exclude type 1 1", "change the forces"},
      {"variable a python f", "variables may be of the styles equal, index, string"},
      {"units", "'units' must be followed by one style"},
      {"mass 3 1", "atom type = 3: must be 1 ... 2"},
      {"mass 1 0", "mass = 0: must be > 0"}};
  for (auto const& [line, said] : cases)
    EXPECT_NE(refusal(two_trimers, forces + line + "\n").find(said), std::string::npos)
        << refusal(two_trimers, forces + line + "\n");
  EXPECT_EQ(cases.size(), 16u);
  EXPECT_NE(refusal(two_trimers, forces, {.units = "real"}).find("--units = real"), std::string::npos);
  EXPECT_NE(refusal(two_trimers, forces, {.atom_style = "full"}).find("t.data:22"), std::string::npos)
      << refusal(two_trimers, forces, {.atom_style = "full"});
}

TEST_F(MoleculeFiles, GiveAMeltWithUsualNumbersOrARefusal) {
  write(folder_ / "t.data", two_trimers);
  write(folder_ / "t.settings", forces);
  MoleculeMeltSettings const usual{.data = folder_ / "t.data", .forces = folder_ / "t.settings"};
  MoleculeMelt const melt(usual);
  EXPECT_EQ(melt.protocol().T, 1);
  EXPECT_EQ(melt.protocol().dt, 0.002);
  EXPECT_DOUBLE_EQ(melt.protocol().friction, 0.5);
  EXPECT_DOUBLE_EQ(melt.protocol().rho, 0.006);
  int cases = 0;
  auto const refused = [&](auto change, std::string const& said) {
    auto settings = usual;
    change(settings);
    try {
      MoleculeMelt const none(settings);
      ADD_FAILURE() << said;
    } catch (InputError const& error) {
      EXPECT_NE(std::string(error.what()).find(said), std::string::npos) << error.what();
    }
    ++cases;
  };
  refused([](auto& s) { s.rho = -1; }, "density rho");
  refused([](auto& s) { s.rho = 1; }, "a larger --replicate");
  refused([](auto& s) { s.T = 0; }, "temperature T = 0");
  refused([](auto& s) { s.dt = std::nan(""); }, "time step = nan");
  refused([](auto& s) { s.friction = 0; }, "friction");
  refused([](auto& s) { s.replicate = {0, 1, 1}; }, "--replicate = 0");
  refused([](auto& s) { s.sampling_steps = 150; }, "multiple");
  refused([](auto& s) { s.checkpoint_every = 150; }, "multiple");
  write(folder_ / "si.settings", replaced(forces, "units lj", "units si"));
  refused([&](auto& s) { s.forces = folder_ / "si.settings"; }, "must be given in these");
  EXPECT_EQ(cases, 9);
  auto other = usual;
  other.T = 2;
  EXPECT_NE(MoleculeMelt(other).fingerprint(), melt.fingerprint());
  write(folder_ / "t.settings", forces + "pair_modify shift yes\n");
  EXPECT_NE(MoleculeMelt(usual).fingerprint(), melt.fingerprint());
}

} // namespace
} // namespace mesobridge::md::test
