#include "scratch_directory.hpp"
#include "workflows/process.hpp"
#include "workflows/star/blob_file.hpp"
#include "workflows/text_file.hpp"
#include "workflows/trajectory/dump_lines.hpp"
#include <array>
#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <regex>
#include <sstream>

// Trajectories as other programs write them: those of tests/cases, of which another code has computed the
// blobs (expected.json), and small ones that are written here.

namespace mesobridge::workflows {

namespace {

using tests::ScratchDirectory;
namespace fs = std::filesystem;

std::string const cases = MESOBRIDGE_SOURCE_DIR "/tests/cases/";

ProcessResult blobs_of(fs::path const& trajectory, fs::path const& mapping, fs::path const& folder,
                       std::vector<std::string> const& more = {}) {
  std::vector<std::string> words{
      MESOBRIDGE_PROGRAM, "cg",    "blobs", trajectory.string(), "--mapping", mapping.string(), "-o",
      folder.string(),    "--json"};
  words.insert(words.end(), more.begin(), more.end());
  return run_process(words);
}

TEST(Trajectory, EveryFormOfOneMeltGivesTheBlobsThatAnotherCodeFinds) {
  ScratchDirectory const scratch;
  auto const expected = Json::parse(read_text_file(cases + "h5md/expected.json"));
  struct Form {
    char const* file;
    std::vector<std::size_t> frames; ///< of expected.json that it has
  };
  std::vector<std::size_t> const all{0, 1, 2, 3, 4, 5};
  std::vector<Form> const forms{{"h5md/t.h5", all},
                                {"h5md/within.h5", all},
                                {"h5md/trajectory.h5md", all},
                                {"h5md/edges-fixed3.h5", all},
                                {"h5md/edges-once.h5", {0}},
                                {"h5md/velocity-every-2nd.h5", {0, 2, 4}},
                                {"dump/both.lammpstrj", all},
                                {"dump/type-element.lammpstrj", all},
                                {"dump/truncated.lammpstrj", {0, 1, 2, 3, 4}}};
  std::size_t compared = 0;
  for (auto const& form : forms) {
    auto const folder = scratch / std::to_string(compared);
    auto const result = blobs_of(cases + form.file, cases + "h5md/map.toml", folder);
    ASSERT_EQ(result.status, 0) << form.file << result.errors;
    auto const data = read_blobs(folder / "blobs.h5");
    ASSERT_EQ(data.frames(), form.frames.size()) << form.file;
    for (std::size_t k = 0; k < form.frames.size(); ++k) {
      auto const& frame = expected[form.frames[k]];
      ASSERT_EQ(data.steps[k], frame["step"].get<std::int64_t>()) << form.file;
      for (std::size_t m = 0; m < 27; ++m) {
        std::size_t const blob = 27 * k + m;
        constexpr double digits = 2e-6; // dumps have ten digits, H5MD files more
        EXPECT_NEAR(data.U_kin[blob], frame["U_kin"][m].get<double>(), digits) << form.file;
        EXPECT_NEAR(data.U_pot[blob], frame["U_pot"][m].get<double>(), digits) << form.file;
        auto const P = frame["P"][m].get<std::vector<double>>();
        EXPECT_LT(norm(data.P[blob] - Vec3{P[0], P[1], P[2]}), digits) << form.file;
      }
    }
    ++compared;
  }
  EXPECT_EQ(compared, 9u);
}

/// The lines of a dump, with the box and what else is said of it changed.
std::string dump_with_box(std::string const& text, std::string const& head,
                          std::array<std::string, 3> const& box,
                          std::function<Vec3(Vec3 const&)> const& turned) {
  std::istringstream in(text);
  std::string line, out;
  int of_box = 3;
  while (std::getline(in, line)) {
    if (line.starts_with("ITEM: BOX"))
      line = "ITEM: BOX BOUNDS " + head + " pp pp pp", of_box = 0;
    else if (of_box < 3)
      line = box[std::size_t(of_box++)];
    else if (auto const words = words_of(line); words.size() == 12) {
      auto const vector = [&](std::size_t k) {
        return turned({std::stod(std::string(words[k])), std::stod(std::string(words[k + 1])),
                       std::stod(std::string(words[k + 2]))});
      };
      Vec3 const q = vector(3), v = vector(9);
      line = fmt::format("{} {} {} {} {} {} 0 0 0 {} {} {}", words[0], words[1], words[2], q.x, q.y, q.z, v.x,
                         v.y, v.z);
    }
    out += line + "\n";
  }
  return out;
}

// The box of 18 x 20 x 22, whose corner is (-9, 1, -3), by other edges of the same lattice: b + a, c + b - a.
TEST(Trajectory, OfATiltedBoxIsThatOfTheUprightOneOfTheSameLattice) {
  ScratchDirectory const scratch;
  auto const text = read_text_file(cases + "dump/both.lammpstrj");
  auto const same = [](Vec3 const& v) { return v; };
  // A quarter turn about z, then one about x.
  auto const turned = [](Vec3 const& v) { return Vec3{-v.y, -v.z, v.x}; };
  std::array<Vec3, 4> const given{turned({18, 0, 0}), turned({18, 20, 0}), turned({-18, 20, 22}),
                                  turned({-9, 1, -3})};
  std::array<std::string, 3> vectors;
  for (int k = 0; k < 3; ++k)
    vectors[std::size_t(k)] = fmt::format("{} {} {} {}", given[std::size_t(k)].x, given[std::size_t(k)].y,
                                          given[std::size_t(k)].z, component(given[3], k));
  write_text_file(scratch / "0.lammpstrj",
                  dump_with_box(text, "xy xz yz", {"-27 27 18", "1 41 -18", "-3 19 20"}, same));
  write_text_file(scratch / "1.lammpstrj", dump_with_box(text, "abc origin", vectors, turned));
  auto const expected = Json::parse(read_text_file(cases + "h5md/expected.json"));
  for (std::string const name : {"0", "1"}) {
    auto const result = blobs_of(scratch / (name + ".lammpstrj"), cases + "h5md/map.toml", scratch / name);
    ASSERT_EQ(result.status, 0) << result.errors;
    auto const data = read_blobs(scratch / name / "blobs.h5");
    ASSERT_EQ(data.frames(), 6u);
    for (std::size_t k = 0; k < 6; ++k) {
      EXPECT_NEAR(data.boxes[k].xy, 18, 1e-12);
      EXPECT_NEAR(data.boxes[k].xz, -18, 1e-12);
      EXPECT_NEAR(data.boxes[k].yz, 20, 1e-12);
      EXPECT_NEAR(data.boxes[k].volume(), 18 * 20 * 22, 1e-9);
      for (std::size_t m = 0; m < 27; ++m) {
        EXPECT_NEAR(data.U_pot[27 * k + m], expected[k]["U_pot"][m].get<double>(), 2e-6) << name;
        auto const P = expected[k]["P"][m].get<std::vector<double>>();
        EXPECT_LT(norm(data.P[27 * k + m] - Vec3{P[0], P[1], P[2]}), 2e-6) << name;
      }
    }
  }
  auto const upright = blobs_of(cases + "dump/both.lammpstrj", cases + "h5md/map.toml", scratch / "upright");
  ASSERT_EQ(upright.status, 0);
  auto const a = read_blobs(scratch / "upright" / "blobs.h5"), b = read_blobs(scratch / "1" / "blobs.h5");
  double Phi = 0;
  for (std::size_t k = 0; k < a.Phi.size(); ++k) {
    EXPECT_NEAR(b.Phi[k], a.Phi[k], 1e-9);
    EXPECT_LT(norm(a.boxes[0].minimum_image(a.R[k] - b.R[k])), 1e-9);
    Phi += a.Phi[k];
  }
  EXPECT_GT(Phi, 1);
}

/// LAMMPS's files of the melt of tetramers: its first frame, where the last molecules may be another kind by
/// the type of their bonds, which is no other law.
void write_lammps_files(fs::path const& folder, int molecules_of_another_kind) {
  std::istringstream in(read_text_file(cases + "dump/both.lammpstrj"));
  std::string line, atoms, bonds;
  int count = 0, bond = 0;
  while (std::getline(in, line) && count < 108)
    if (auto const words = words_of(line); words.size() == 12) {
      int const id = std::stoi(std::string(words[0])), molecule = (id - 1) / 4 + 1;
      atoms += fmt::format("{} {} 1 {} {} {}\n", id, molecule, words[3], words[4], words[5]);
      if (id % 4 != 0)
        bonds += fmt::format("{} {} {} {}\n", ++bond, molecule > 27 - molecules_of_another_kind ? 2 : 1, id,
                             id + 1);
      ++count;
    }
  write_text_file(folder / "melt.data",
                  "tetramers\n\n108 atoms\n81 bonds\n1 atom types\n2 bond types\n-9 9 xlo xhi\n1 21 ylo yhi\n"
                  "-3 19 zlo zhi\n\nMasses\n\n1 1\n\nAtoms # bond\n\n" +
                      atoms + "\nBonds\n\n" + bonds);
  write_text_file(folder / "melt.settings",
                  "units lj\npair_style lj/cut 1.122462048309373\npair_modify shift yes\n"
                  "pair_coeff * * 1 1\nbond_style harmonic\nbond_coeff * 25 1\n"
                  "special_bonds lj 1 1 1\n");
}

TEST(Trajectory, ByLammpssEnergiesGivesTheBlobsOfTheMappingsOwnLaws) {
  ScratchDirectory const scratch;
  auto const own = blobs_of(cases + "dump/both.lammpstrj", cases + "h5md/map.toml", scratch / "own");
  ASSERT_EQ(own.status, 0) << own.errors;
  auto const expected = read_blobs(scratch / "own" / "blobs.h5");
  write_text_file(scratch / "tilted.lammpstrj",
                  dump_with_box(read_text_file(cases + "dump/both.lammpstrj"), "xy xz yz",
                                {"-27 27 18", "1 41 -18", "-3 19 20"}, [](Vec3 const& v) { return v; }));
  int compared = 0;
  for (int const others : {0, 5}) {
    auto const folder = scratch / fmt::format("{}", others);
    fs::create_directories(folder);
    write_lammps_files(folder, others);
    write_text_file(folder / "map.toml", "format = \"mesobridge mapping 1\"\nname = \"tetramer\"\n[lammps]\n"
                                         "data = \"melt.data\"\nsettings = \"melt.settings\"\nkind = 1\n");
    for (auto const& file : {fs::path(cases + "dump/both.lammpstrj"), scratch / "tilted.lammpstrj",
                             fs::path(cases + "h5md/within.h5")}) {
      auto const result = blobs_of(file, folder / "map.toml", folder / "blobs");
      ASSERT_EQ(result.status, 0) << result.errors;
      auto const json = Json::parse(result.output);
      EXPECT_NEAR(json["energy_last"].get<double>(), Json::parse(own.output)["energy_last"].get<double>(),
                  1e-5);
      auto const data = read_blobs(folder / "blobs" / "blobs.h5");
      std::size_t const molecules = std::size_t(27 - others);
      ASSERT_EQ(data.head.molecules, 27 - others);
      for (std::size_t k = 0; k < data.frames(); ++k)
        for (std::size_t m = 0; m < molecules; ++m) {
          std::size_t const at = molecules * k + m, of = 27 * k + m;
          EXPECT_NEAR(data.U_pot[at], expected.U_pot[of], 2e-6);
          EXPECT_NEAR(data.U_kin[at], expected.U_kin[of], 2e-6);
          EXPECT_NEAR(data.Phi[at], expected.Phi[of], 2e-6);
          EXPECT_LT(norm(data.P[at] - expected.P[of]), 2e-6);
        }
      auto const forces = read_blob_forces(folder / "blobs" / "blobs.h5");
      auto const of_own = read_blob_forces(scratch / "own" / "blobs.h5");
      for (std::size_t m = 0; m < molecules; ++m)
        EXPECT_LT(norm(forces[m] - of_own[m]), 1e-4) << m; // of positions with ten digits
      ++compared;
    }
  }
  EXPECT_EQ(compared, 6);
}

// LAMMPS itself fills the memory with images for half a minute before it says so.
TEST(Trajectory, CutoffsThatReachTooManyImagesAreRefusedAtOnce) {
  ScratchDirectory const scratch;
  int refused = 0;
  for (std::string const wide : {"pair_style lj/cut 1120000\n", "pair_style lj/cut 1e300\n",
                                 "pair_style lj/cut 1.12\ncomm_modify cutoff 1e9\n"}) {
    write_lammps_files(scratch.path(), 0);
    auto text = read_text_file(scratch / "melt.settings");
    std::string const usual = "pair_style lj/cut 1.122462048309373\n";
    text.replace(text.find(usual), usual.size(), wide);
    write_text_file(scratch / "melt.settings", text);
    write_text_file(scratch / "map.toml", "format = \"mesobridge mapping 1\"\nname = \"tetramer\"\n[lammps]\n"
                                          "data = \"melt.data\"\nsettings = \"melt.settings\"\nkind = 1\n");
    auto const result = blobs_of(cases + "dump/both.lammpstrj", scratch / "map.toml", scratch / "blobs");
    EXPECT_EQ(result.status, 2) << wide;
    EXPECT_NE(result.errors.find("melt.settings"), std::string::npos) << result.errors;
    EXPECT_NE(result.errors.find("images of its 108 atoms"), std::string::npos) << result.errors;
    auto const melt =
        run_process({MESOBRIDGE_PROGRAM, "md", "molecules", (scratch / "melt.data").string(), "--settings",
                     (scratch / "melt.settings").string(), "-o", (scratch / "md").string()});
    EXPECT_EQ(melt.status, 2) << wide;
    EXPECT_NE(melt.errors.find("images of its 108 atoms"), std::string::npos) << melt.errors;
    ++refused;
  }
  EXPECT_EQ(refused, 3);
}

/// A dimer a frame: atoms at x = 5 and 6.1, z near the two ends of a box of 12, moving apart.
struct Written {
  std::vector<double> position{5, 5, 0.45, 6.1, 5, 0.45, 5, 5, 11.5, 6.1, 5, 11.5}, velocity;
  std::vector<std::int64_t> step{0, 10}, id;
  std::vector<double> time{0, 0.1};
  std::vector<std::string> boundary{"periodic", "periodic", "periodic"};
  std::string length_unit, velocity_unit, time_unit;
  Store::Shape edges_shape{3};
  std::vector<double> edges{12, 12, 12};
  std::vector<std::string> groups{"all"};
};

void write(fs::path const& file, Written const& of) {
  Store store(file, Store::Mode::create);
  auto const frames = of.step.size();
  auto twice = [&](std::vector<double> const& one) {
    std::vector<double> all;
    for (std::size_t k = 0; k < frames; ++k)
      all.insert(all.end(), one.begin(), one.end());
    return all;
  };
  auto const v = of.velocity.empty() ? std::vector<double>(12, 0.0) : of.velocity;
  for (auto const& name : of.groups) {
    auto const group = "particles/" + name;
    auto element = [&](std::string const& which, std::vector<double> const& one, std::string const& unit) {
      auto const path = group + "/" + which;
      store.write(path + "/value", twice(one), {frames, one.size() / 3, 3});
      store.write(path + "/step", of.step);
      store.write(path + "/time", of.time);
      if (!unit.empty())
        store.set_attribute(path + "/value", "unit", unit);
      if (!of.time_unit.empty())
        store.set_attribute(path + "/time", "unit", of.time_unit);
    };
    element("position", of.position, of.length_unit);
    element("velocity", v, of.velocity_unit);
    store.write(group + "/box/edges", of.edges, of.edges_shape);
    if (!of.length_unit.empty())
      store.set_attribute(group + "/box/edges", "unit", of.length_unit);
    if (!of.id.empty())
      store.write(group + "/id", of.id);
    store.set_attribute(group + "/box", "boundary", std::span<std::string const>(of.boundary));
  }
  store.close();
}

std::string mapping(std::string const& units, double mass, double l) {
  return fmt::format(
      "format = \"mesobridge mapping 1\"\nname = \"dimer\"\nunits = \"{}\"\natoms = 2\nmasses = [ {}, "
      "{} ]\n[bonds]\ncount = 1\na = [ 1 ]\nb = [ 2 ]\nk = [ 100.0 ]\nl = [ {} ]\n[pairs]\ncount = "
      "1\ntype_a = [ 1 ]\ntype_b = [ 1 ]\nepsilon = [ 1.0 ]\nsigma = [ {} ]\ncutoff = [ {} ]\n"
      "shifted = \"yes\"\nbonded = \"no\"\n",
      units, mass, mass, l, l, l * 1.122462048309373);
}

TEST(Trajectory, AnH5mdFileIsTakenAsItSays) {
  ScratchDirectory const scratch;
  write_text_file(scratch / "lj.toml", mapping("lj", 1, 1));
  // The bonds are 1.1 long: 50 * 0.01 each. Transverse the border the dimers' atoms are 0.95 apart.
  double const bonds = 2 * 0.5, s6 = std::pow(0.95, -6), pairs = 2 * (4 * (s6 * s6 - s6) + 1);
  struct Taken {
    Written file;
    double energy;
    std::vector<std::string> options;
  };
  Written periodic, open, sorted, several;
  open.boundary[2] = "none";
  // Atoms in the order 3, 1, 4, 2: without the ids the bonds would lie across the box.
  sorted.position = {5, 5, 11.5, 5, 5, 0.45, 6.1, 5, 11.5, 6.1, 5, 0.45};
  sorted.id = {3, 1, 4, 2};
  several.groups = {"all", "water"};
  std::vector<Taken> const all{{periodic, bonds + pairs, {}},
                               {open, bonds, {}},
                               {sorted, bonds + pairs, {}},
                               {several, bonds + pairs, {"--group", "water"}}};
  std::size_t tried = 0;
  for (auto const& [file, energy, options] : all) {
    write(scratch / "a.h5", file);
    auto const result = blobs_of(scratch / "a.h5", scratch / "lj.toml", scratch / "out", options);
    ASSERT_EQ(result.status, 0) << tried << result.errors;
    auto const json = Json::parse(result.output);
    EXPECT_NEAR(json["potential_energy_first"].get<double>(), energy, 1e-9) << tried;
    EXPECT_EQ(json["frames"], 2) << tried;
    EXPECT_EQ(read_blobs(scratch / "out" / "blobs.h5").times[1], 0.1);
    ++tried;
  }
  EXPECT_EQ(tried, 4u);
}

// nm and ps in the file, Angstrom, fs and kcal/mol in the mapping.
TEST(Trajectory, UnitsOfAnH5mdFileBecomeThoseOfTheMapping) {
  ScratchDirectory const scratch;
  write_text_file(scratch / "real.toml", mapping("real", 12, 10));
  write_text_file(scratch / "lj.toml", mapping("lj", 12, 10));
  Written file;
  file.length_unit = "nm", file.velocity_unit = "nm ps-1", file.time_unit = "ps";
  file.velocity = {1, 0, 0, -1, 0, 0, 0, 0, 0, 0, 0, 0};
  file.boundary[2] = "none";
  write(scratch / "a.h5", file);
  auto const result = blobs_of(scratch / "a.h5", scratch / "real.toml", scratch / "out");
  ASSERT_EQ(result.status, 0) << result.errors;
  auto const data = read_blobs(scratch / "out" / "blobs.h5");
  EXPECT_NEAR(data.R[0].x, 55.5, 1e-9);                 // A
  EXPECT_NEAR(data.U_pot[0], 50 * 1 * 1, 1e-9);         // stretched by 1 A
  EXPECT_NEAR(data.times[1], 100, 1e-9);                // fs
  EXPECT_NEAR(data.U_kin[0], 12e-3 * 1e6 / 4184, 1e-9); // 12 g/mol (1000 m/s)^2 in kcal/mol
  auto const contradiction = blobs_of(scratch / "a.h5", scratch / "lj.toml", scratch / "out");
  EXPECT_EQ(contradiction.status, 2);
  EXPECT_NE(contradiction.errors.find("'nm'"), std::string::npos) << contradiction.errors;
}

TEST(Trajectory, WhatContradictsItselfInAnH5mdFileIsRefusedByName) {
  ScratchDirectory const scratch;
  write_text_file(scratch / "lj.toml", mapping("lj", 1, 1));
  struct Refused {
    std::function<void(Written&)> spoil;
    std::vector<std::string> words;
  };
  std::vector<Refused> const all{
      {[](Written& f) { f.velocity.assign(12, 0.0), f.velocity[7] = NAN; },
       {"velocity/value", R"(\[0\]\[2\]\[1\] = nan)"}},
      {[](Written& f) { f.position[3] = INFINITY; }, {"position/value", R"(\[0\]\[1\]\[0\] = inf)"}},
      {[](Written& f) { f.position[3] = 1e30; }, {"position", "box edges away"}},
      {[](Written& f) {
         f.step = {10, 0};
       },
       {"step 0 stands after step 10"}},
      {[](Written& f) {
         f.time = {0.1, 0};
       },
       {"time 0 of step 10 is not after 0.1"}},
      {[](Written& f) {
         f.id = {1, 2, 2, 3};
       },
       {"id has the id 2 twice"}},
      {[](Written& f) {
         f.id = {1, 2, 3};
       },
       {"id has frames of 3: must be 4"}},
      {[](Written& f) {
         f.edges = {12, 0, 12};
       },
       {"edges", "12 x 0 x 12"}},
      {[](Written& f) {
         f.edges = {12, 12}, f.edges_shape = {2};
       },
       {"edges has frames of 2"}},
      {[](Written& f) {
         f.edges = {12, 0, 0, 0, 12, 0, 12, 12, 0}, f.edges_shape = {3, 3};
       },
       {"edges", "make no box"}},
      {[](Written& f) {
         f.boundary = {"periodic", "open", "none"};
       },
       {"boundary", "periodic, open, none"}},
      {[](Written& f) {
         f.groups = {"a", "b"};
       },
       {"--group", "a, b"}},
      {[](Written& f) { f.length_unit = "parsec"; }, {"parsec"}},
      {[](Written& f) { f.velocity.assign(6, 0.0); },
       {"velocity has frames of 2 x 3, the positions of 4 x 3"}},
      {[](Written& f) { f.position.resize(9), f.velocity.assign(9, 0.0); }, {"3 atoms", "2 each"}}};
  std::size_t tried = 0;
  for (auto const& [spoil, words] : all) {
    Written file;
    spoil(file);
    write(scratch / "a.h5", file);
    auto const result = blobs_of(scratch / "a.h5", scratch / "lj.toml", scratch / "out");
    EXPECT_EQ(result.status, 2) << tried << result.errors;
    EXPECT_NE(result.errors.find("a.h5"), std::string::npos) << result.errors;
    for (auto const& word : words)
      EXPECT_TRUE(std::regex_search(result.errors, std::regex(word))) << word << "\n" << result.errors;
    EXPECT_FALSE(fs::exists(scratch / "out" / "blobs.h5")) << tried;
    ++tried;
  }
  EXPECT_EQ(tried, 15u);
}

/// A dump of two far dimers that swing as harmonic ones do, r = 1 + 0.1 cos(omega t) with omega^2 = 2 k / m,
/// k = 100, m = 1: their energy is constant.
std::string swinging_dimers() {
  std::string text;
  double const omega = std::sqrt(200.0);
  for (int k = 0; k < 12; ++k) {
    text +=
        fmt::format("ITEM: TIMESTEP\n{}\nITEM: NUMBER OF ATOMS\n4\nITEM: BOX BOUNDS pp pp pp\n0 20\n0 20\n0 "
                    "20\nITEM: ATOMS id mol x y z vx vy vz\n",
                    k);
    for (int dimer = 0; dimer < 2; ++dimer) {
      double const phase = omega * 0.03 * k + dimer, half = (1 + 0.1 * std::cos(phase)) / 2,
                   v = -0.1 * omega * std::sin(phase) / 2;
      for (int side : {-1, 1})
        text += fmt::format("{} {} {} {} 10 {} 0 0\n", 2 * dimer + 1 + (side + 1) / 2, dimer + 1,
                            5 + side * half, 5 + 10 * dimer, side * v);
    }
  }
  return text;
}

TEST(Trajectory, AnEnergyThatWandersIsTold) {
  ScratchDirectory const scratch;
  write_text_file(scratch / "a.lammpstrj", swinging_dimers());
  struct Try {
    char const* k;
    double mass;
    bool wanders;
  };
  std::size_t tried = 0;
  for (auto const& [k, mass, wanders] :
       {Try{"k = [ 100.0 ]", 1, false}, Try{"K = [ 50.0 ]", 1, false}, Try{"K = [ 100.0 ]", 1, true},
        Try{"k = [ 50.0 ]", 1, true}, Try{"k = [ 100.0 ]", 2, true}}) {
    auto text = mapping("lj", mass, 1);
    text.replace(text.find("k = [ 100.0 ]"), 13, k);
    write_text_file(scratch / "m.toml", text.substr(0, text.find("[pairs]")));
    auto const result =
        blobs_of(scratch / "a.lammpstrj", scratch / "m.toml", scratch / "out", {"--dt", "0.03"});
    ASSERT_EQ(result.status, 0) << result.errors;
    EXPECT_EQ(result.errors.find("wanders") != std::string::npos, wanders) << k << mass << result.errors;
    if (!wanders) {
      EXPECT_NEAR(Json::parse(result.output)["energy_last"].get<double>(), 2 * 50 * 0.01, 1e-9);
    }
    ++tried;
  }
  EXPECT_EQ(tried, 5u);
}

} // namespace

} // namespace mesobridge::workflows
