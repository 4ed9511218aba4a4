#include "error_text.hpp"
#include "md/lammps_session.hpp"
#include <algorithm>
#include <cmath>
#include <fstream>
#include <gtest/gtest.h>
#include <unistd.h>

namespace mesobridge::md::test {
namespace {

std::filesystem::path temporary(std::string const& name) {
  return std::filesystem::temp_directory_path() / fmt::format("mesobridge-{}-{}", ::getpid(), name);
}

class LammpsSessionTest : public ::testing::Test {
 protected:
  LammpsSession session() { return {world_, Ranks::own, log_}; }
  void TearDown() override { std::filesystem::remove(log_); }

  /// 500 Lennard-Jones atoms on a lattice, ready to run.
  LammpsSession fluid(double time_step) {
    auto lammps = session();
    for (char const* line : {"units lj", "lattice fcc 0.8", "region box block 0 5 0 5 0 5",
                             "create_box 1 box", "create_atoms 1 box", "mass 1 1.0", "pair_style lj/cut 2.5",
                             "pair_coeff 1 1 1.0 1.0", "velocity all create 3.0 12345", "fix move all nve"})
      lammps.command(line);
    lammps.command("timestep {}", time_step);
    return lammps;
  }

  MpiWorld world_;
  std::filesystem::path log_ = temporary("lammps.log");
};

TEST_F(LammpsSessionTest, ErrorsAreExceptionsWithLammpssOwnTextAndTheProcessLivesOn) {
  struct Case {
    char const *command, *text;
  };
  int cases = 0;
  for (Case const& c : {Case{"bogus 1", "Unknown command: bogus 1"},
                        Case{"pair_style nonesuch 2.5", "Unrecognized pair style 'nonesuch'"},
                        Case{"run 10", "Run command before simulation box is defined"},
                        Case{"read_data /dev/null/file", "Cannot open file /dev/null/file"}}) {
    auto lammps = session();
    auto const text = tests::error_text<LammpsError>([&] { lammps.command(c.command); });
    EXPECT_NE(text.find(c.text), std::string::npos) << text;
    EXPECT_NE(text.find(c.command), std::string::npos) << "the command is named: " << text;
    EXPECT_NE(tests::error_text<LammpsError>([&] { lammps.command("units lj"); }).find("after an error"),
              std::string::npos);
    ++cases;
  }
  EXPECT_EQ(cases, 4);
  auto lammps = fluid(0.004);
  lammps.command("run 10");
  EXPECT_EQ(lammps.step(), 10);
}

TEST_F(LammpsSessionTest, LostAtomsOfAnUnstableRunAreAnException) {
  auto lammps = fluid(0.2);
  auto const text = tests::error_text<LammpsError>([&] { lammps.command("run 500"); });
  EXPECT_TRUE(text.find("Lost atoms") != std::string::npos || text.find("Non-numeric") != std::string::npos)
      << text;
}

TEST_F(LammpsSessionTest, ALogThatCannotBeWrittenIsAnException) {
  auto const text =
      tests::error_text<LammpsError>([&] { LammpsSession(world_, Ranks::own, "/dev/null/lammps.log"); });
  EXPECT_NE(text.find("Cannot open logfile"), std::string::npos) << text;
  EXPECT_THROW(LammpsSession(world_, Ranks::own, "a\"b"), InputError);
}

TEST_F(LammpsSessionTest, KeepsQuietOnTheTerminalAndWritesItsLog) {
  ::testing::internal::CaptureStdout();
  ::testing::internal::CaptureStderr();
  {
    auto lammps = fluid(0.004);
    lammps.command("run 1");
  }
  EXPECT_EQ(::testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
  std::ifstream log(log_);
  std::string const text(std::istreambuf_iterator<char>(log), {});
  EXPECT_NE(text.find("pair_style lj/cut 2.5"), std::string::npos);
  EXPECT_NE(text.find("Loop time"), std::string::npos);
}

TEST_F(LammpsSessionTest, EnergyIsConservedAndTheFrameAgreesWithTheThermodynamics) {
  auto lammps = fluid(0.001);
  lammps.command(
      "pair_modify shift yes"); // without the shift, atoms that cross the cut-off change the energy
  lammps.command("run 0");
  double const before = lammps.thermo("etotal");
  lammps.command("run 200");
  EXPECT_NEAR(lammps.thermo("etotal"), before, 2e-3);
  auto const frame = lammps.frame();
  ASSERT_EQ(frame.positions.size(), 500u);
  EXPECT_EQ(frame.step, 200);
  EXPECT_EQ(frame.types, std::vector<int>(500, 1));
  EXPECT_NEAR(frame.box.volume(), 500 / 0.8, 1e-10);
  double twice_kinetic = 0;
  for (Vec3 const& v : frame.velocities)
    twice_kinetic += norm2(v);
  EXPECT_NEAR(lammps.thermo("temp"), twice_kinetic / (3 * 500 - 3), 1e-12);
  EXPECT_NEAR(lammps.compute("thermo_temp"), lammps.thermo("temp"), 1e-12);
  // The potential energy summed here over minimum images.
  double const at_cut_off = 4 * (std::pow(2.5, -12) - std::pow(2.5, -6));
  double potential = 0;
  for (std::size_t i = 0; i < 500; ++i)
    for (std::size_t j = i + 1; j < 500; ++j)
      if (double const r2 = norm2(frame.box.minimum_image(frame.positions[i] - frame.positions[j]));
          r2 < 6.25)
        potential += 4 * (std::pow(r2, -6) - std::pow(r2, -3)) - at_cut_off;
  EXPECT_NEAR(lammps.thermo("pe"), potential / 500, 1e-10);
  for (Vec3 const& q : frame.positions)
    EXPECT_TRUE(q.x >= 0 && q.x < frame.box.edge.x && q.y >= 0 && q.y < frame.box.edge.y);
}

TEST_F(LammpsSessionTest, UnknownKeywordsAndComputesAreErrorsNotZeros) {
  auto lammps = fluid(0.004);
  lammps.command("run 0");
  EXPECT_THROW(lammps.compute("nonesuch"), InputError);
  EXPECT_NE(tests::error_text<LammpsError>([&] { lammps.thermo("nonesuch"); }).find("nonesuch"),
            std::string::npos);
}

TEST_F(LammpsSessionTest, TellsWhatIsInstalled) {
  auto const found = lammps_installation(world_);
  EXPECT_GE(found.version, 20200000);
  EXPECT_NE(std::find(found.packages.begin(), found.packages.end(), "MOLECULE"), found.packages.end());
  auto lammps = session();
  EXPECT_TRUE(lammps.has_style("pair", "lj/cut"));
  EXPECT_FALSE(lammps.has_style("pair", "nonesuch"));
}

} // namespace
} // namespace mesobridge::md::test
