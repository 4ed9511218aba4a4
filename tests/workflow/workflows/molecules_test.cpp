#include "cg/molecule_model.hpp"
#include "program.hpp"
#include "same_blobs.hpp"
#include "scratch_directory.hpp"
#include "unit/workflows/killed_process.hpp"
#include "workflows/star/blob_file.hpp"
#include "workflows/text_file.hpp"
#include "workflows/trajectory/mapping_file.hpp"
#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <sys/wait.h>
#include <thread>
#include <tuple>

namespace mesobridge::workflows {

namespace {

using tests::expect_refusal;
using tests::program;
using tests::ScratchDirectory;
using Words = std::vector<std::string>;

std::string const molecules = MESOBRIDGE_SOURCE_DIR "/workflows/scenes/molecules/";

Words melt(std::string const& data, std::string const& settings, std::filesystem::path const& folder,
           Words const& more) {
  Words words{"md", "molecules", data, "--settings", settings, "-o", folder.string(), "--quiet"};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

Words const short_chains{"--replicate",
                         "2",
                         "--T",
                         "1",
                         "--dt",
                         "0.005",
                         "--sampling-steps",
                         "800",
                         "--sample-every",
                         "20",
                         "--equilibration-steps",
                         "400",
                         "--checkpoint-every",
                         "100"};

TEST(Molecules, OfADataFileBecomeAMelt) {
  ScratchDirectory const scratch;
  auto words = melt(molecules + "chain.data", molecules + "chain.settings", scratch.path(), short_chains);
  words.insert(words.end(), {"--ranks", "1", "--json"});
  auto const result = program(words);
  ASSERT_EQ(result.status, 0) << result.errors;
  auto const json = Json::parse(result.output);
  EXPECT_EQ(json["molecule"], "chain");
  EXPECT_EQ(json["molecules"], 8);
  EXPECT_EQ(json["frames"], 40);
  EXPECT_LT(json["blob_energy_sum_relative_error_max"], 1e-9);
  EXPECT_LT(json["energy_spread_per_bead"], 0.01);
  EXPECT_NEAR(json["T_kin"].get<double>(), 1, 0.5);
  auto const data = read_blobs(scratch / "blobs.h5");
  EXPECT_EQ(data.head.kind, "melt");
  EXPECT_EQ(data.head.mass, 10);
  EXPECT_DOUBLE_EQ(data.head.rho, 10 / (10.8 * 10.8 * 10.8));
  for (char const* file : {"centres.h5", "lammps.log", "summary.json", "molecules.restart"})
    EXPECT_TRUE(std::filesystem::exists(scratch / file)) << file;
  for (auto const& entry : std::filesystem::directory_iterator(scratch.path()))
    EXPECT_NE(entry.path().extension(), ".data") << "written on the way";
  auto const transport = program({"cg", "transport", (scratch / "blobs.h5").string(), "--json"});
  EXPECT_EQ(transport.status, 0) << transport.errors;
}

TEST(Molecules, InKilocaloriesHaveTheirTemperatureInKelvin) {
  ScratchDirectory const scratch;
  auto words =
      melt(molecules + "butane.data", molecules + "butane.settings", scratch.path(),
           {"--replicate", "4", "--equilibration-steps", "1000", "--sampling-steps", "2000", "--sample-every",
            "50", "--checkpoint-every", "1000", "--friction", "0.01", "--ranks", "1", "--json"});
  auto const result = program(words);
  ASSERT_EQ(result.status, 0) << result.errors;
  auto const json = Json::parse(result.output);
  EXPECT_NEAR(json["T_kin"].get<double>(), 300, 40);
  EXPECT_NEAR(json["k_B"].get<double>(), 0.0019872067, 1e-9);
  auto const data = read_blobs(scratch / "blobs.h5");
  EXPECT_EQ(data.head.units, "real");
  EXPECT_NEAR(data.head.T, 0.59616, 1e-4);
  double P2 = 0;
  for (auto const& P : data.P)
    P2 += norm2(P) / double(data.P.size());
  EXPECT_NEAR(P2 / (3 * data.head.mass * data.head.T), 1, 0.4) << "equipartition of the centres";
}

// The thermostat's noise depends on the ranks, so both go on from the same checkpoint.
TEST(Molecules, DoNotDependOnTheNumberOfRanks) {
  ScratchDirectory const scratch;
  auto const call = [&](char const* ranks, char const* steps, Words const& more) {
    auto words = melt(molecules + "butane.data", molecules + "butane.settings", scratch / ranks,
                      {"--replicate", "4", "--equilibration-steps", "200", "--sample-every", "20",
                       "--checkpoint-every", "20", "--ranks", ranks, "--sampling-steps", steps});
    words.insert(words.end(), more.begin(), more.end());
    return program(words);
  };
  ASSERT_EQ(call("1", "20", {}).status, 0);
  std::filesystem::copy(scratch / "1", scratch / "2");
  for (char const* ranks : {"1", "2"}) {
    auto const result = call(ranks, "40", {"--resume"});
    ASSERT_EQ(result.status, 0) << result.errors;
  }
  tests::expect_same_blobs(read_blobs(scratch / "1" / "blobs.h5"), read_blobs(scratch / "2" / "blobs.h5"),
                           2u * 64, 1e-7);
}

TEST(Molecules, ThatAreKilledGoOnToTheBitsOfAnUnbrokenRun) {
  ScratchDirectory const scratch;
  auto const unbroken = scratch / "unbroken", broken = scratch / "broken";
  auto const call = [&](std::filesystem::path const& folder) {
    auto words = melt(molecules + "chain.data", molecules + "chain.settings", folder, short_chains);
    words.insert(words.end(), {"--ranks", "1"});
    if (std::filesystem::exists(folder / "molecules.restart"))
      words.emplace_back("--resume");
    return words;
  };
  ASSERT_EQ(program(call(unbroken)).status, 0);
  auto const until_sampling = [&] {
    for (int k = 0; k < 4000 && !std::filesystem::exists(broken / "molecules.restart"); ++k)
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
  };
  auto words = call(broken);
  words.insert(words.begin(), MESOBRIDGE_PROGRAM);
  ASSERT_TRUE(WIFSIGNALED(tests::killed(until_sampling, SIGKILL, words)));
  auto const last = program(call(broken));
  ASSERT_EQ(last.status, 0) << last.errors;
  auto const a = read_blobs(unbroken / "blobs.h5"), b = read_blobs(broken / "blobs.h5");
  EXPECT_EQ(a.steps, b.steps);
  EXPECT_EQ(a.energies, b.energies);
  EXPECT_EQ(a.U_pot, b.U_pot);
  EXPECT_EQ(a.U_kin, b.U_kin);
  EXPECT_EQ(a.Phi, b.Phi);
  // Another force field is no continuation.
  auto text = read_text_file(molecules + "chain.settings");
  write_text_file(scratch / "other.settings", text + "pair_coeff 1 1 1.01 1\n");
  auto other = melt(molecules + "chain.data", scratch / "other.settings", broken, short_chains);
  other.insert(other.end(), {"--ranks", "1", "--resume"});
  auto const refused = program(other);
  EXPECT_EQ(refused.status, 2);
  EXPECT_NE(refused.errors.find("was made with other settings"), std::string::npos) << refused.errors;
}

struct WrongLine {
  char const *from, *to, *said;
};

TEST(Molecules, WithForcesThatLammpsRefusesAreRefusedInOneMessageThatNamesTheFile) {
  ScratchDirectory const scratch;
  auto const good = read_text_file(molecules + "chain.settings");
  std::vector<WrongLine> const cases{
      {"pair_coeff      1 1 1 1\n", "", "All pair coeffs are not set"},
      {"bond_coeff      1 30 1.5 1 1", "", "Bond coeffs are not set"},
      {"pair_style      lj/cut", "pair_style      lj/cutt",
       "wrong.settings:2: LAMMPS: Unrecognized pair style"},
      {"pair_coeff      1 1 1 1", "pair_coeff      1 2 1 1", "wrong.settings:4: LAMMPS: "},
      {"pair_coeff      1 1 1 1", "pair_coeff      1 1 ${e} 1", "wrong.settings:4: LAMMPS: "},
      {"bond_style      fene", "", "LAMMPS: "},
      {"special_bonds   fene", "run 10", "wrong.settings:7: 'run' is no command of a force field"}};
  for (auto const& [from, to, said] : cases) {
    auto text = good;
    ASSERT_NE(text.find(from), text.npos) << from;
    write_text_file(scratch / "wrong.settings", text.replace(text.find(from), std::string(from).size(), to));
    auto words = melt(molecules + "chain.data", scratch / "wrong.settings", scratch / "out", short_chains);
    words.insert(words.end(), {"--ranks", "1"});
    expect_refusal(program(words), 2, said);
    EXPECT_NE(program(words).errors.find("wrong.settings"), std::string::npos);
  }
  EXPECT_EQ(cases.size(), 7u);
  auto words = melt(molecules + "chain.data", scratch / "wrong.settings", scratch / "out", short_chains);
  words.insert(words.end(), {"--units", "furlong", "--ranks", "1"});
  expect_refusal(program(words), 2, "'run'");
  words[4] = molecules + "chain.settings";
  expect_refusal(program(words), 2, "units = furlong: must be lj, real");
}

TEST(Molecules, BecomeAMappingWithTheModelOfTheStar) {
  ScratchDirectory const scratch;
  auto const file = scratch / "star.toml";
  auto const result = program({"cg", "mapping", molecules + "star.data", "--settings",
                               molecules + "star.settings", "-o", file.string(), "--json"});
  ASSERT_EQ(result.status, 0) << result.errors;
  EXPECT_NE(read_text_file(file).find("\nK = [ 10.0, "), std::string::npos);
  auto const mapping = read_mapping(file);
  auto const star = cg::model_of(md::StarPolymer{});
  EXPECT_EQ(mapping.name, "star");
  EXPECT_EQ(mapping.model.masses, star.masses);
  EXPECT_EQ(mapping.model.excluded, star.excluded);
  ASSERT_EQ(mapping.model.bonds.size(), star.bonds.size());
  auto bonds = star.bonds;
  std::ranges::sort(bonds, {},
                    [](auto const& bond) { return std::tuple(bond.law.length() < 1.5, bond.a, bond.b); });
  for (std::size_t k = 0; k < bonds.size(); ++k) {
    EXPECT_EQ(mapping.model.bonds[k].a, bonds[k].a);
    EXPECT_EQ(mapping.model.bonds[k].b, bonds[k].b);
    EXPECT_EQ(mapping.model.bonds[k].law.stiffness(), 20);
    EXPECT_EQ(mapping.model.bonds[k].law.length(), bonds[k].law.length());
  }
  for (double const r : {0.9, 1.0, 1.1, 1.2})
    EXPECT_NEAR(mapping.model.law(0, 0).energy(r * r), star.law(0, 0).energy(r * r), 1e-12) << r;
}

TEST(Molecules, WithMixedPairsBecomeAMapping) {
  ScratchDirectory const scratch;
  auto const data = read_text_file(molecules + "butane.data");
  write_text_file(scratch / "d.data", data.substr(0, data.find("Angles\n")));
  auto text = read_text_file(scratch / "d.data");
  text.replace(text.find("2 angles\n1 dihedrals\n"), 21, "");
  write_text_file(scratch / "d.data", text);
  write_text_file(scratch / "d.settings",
                  "units real\npair_style lj/cut 12\npair_coeff 1 1 0.2 3.75 10\n"
                  "pair_coeff 2 2 0.05 4\npair_modify mix arithmetic\n"
                  "bond_style harmonic\nbond_coeff * 268 1.54\nspecial_bonds lj 0 1 1\n");
  auto const result = program({"cg", "mapping", (scratch / "d.data").string(), "--settings",
                               (scratch / "d.settings").string(), "-o", (scratch / "d.toml").string()});
  ASSERT_EQ(result.status, 0) << result.errors;
  auto const mapping = read_mapping(scratch / "d.toml");
  EXPECT_EQ(mapping.units.name, "real");
  EXPECT_EQ(mapping.model.bonds[0].law.stiffness(), 536);
  EXPECT_EQ(mapping.model.excluded.size(), 3u);
  EXPECT_NEAR(mapping.model.law(0, 1).cutoff(), 11, 1e-12);
  EXPECT_NEAR(mapping.model.law(0, 1).energy(16),
              4 * 0.1 * (std::pow(3.875 / 4, 12) - std::pow(3.875 / 4, 6)), 1e-12);
}

TEST(Molecules, WithFeneBondsBecomeAMapping) {
  ScratchDirectory const scratch;
  auto const result = program({"cg", "mapping", molecules + "chain.data", "--settings",
                               molecules + "chain.settings", "-o", (scratch / "c.toml").string()});
  ASSERT_EQ(result.status, 0) << result.errors;
  auto const mapping = read_mapping(scratch / "c.toml");
  ASSERT_EQ(mapping.model.bonds.size(), 9u);
  EXPECT_EQ(mapping.model.excluded.size(), 9u);
  double const r = 0.97; // of Kremer and Grest's melts
  EXPECT_NEAR(mapping.model.bonds[4].law.energy(r),
              -15 * 2.25 * std::log(1 - r * r / 2.25) + 4 * (std::pow(r, -12) - std::pow(r, -6)) + 1, 1e-12);
  auto text = read_text_file(scratch / "c.toml");
  for (auto const& [from, to, said] : {std::tuple{"\"fene\"", "\"morse\"", "bonds.style = morse"},
                                       {"R0", "l", "R0"},
                                       {"1.5", "-1.5", "bonds.R0"}}) {
    auto changed = text;
    write_text_file(scratch / "no.toml", changed.replace(changed.find(from), std::string(from).size(), to));
    try {
      read_mapping(scratch / "no.toml");
      FAIL() << to;
    } catch (InputError const& error) {
      EXPECT_NE(std::string(error.what()).find(said), std::string::npos) << error.what();
    }
  }
}

/// Files of the star with one line of its settings changed.
class StarSettings {
 public:
  std::string changed(std::string const& name, std::string const& from, std::string const& to) const {
    auto text = read_text_file(molecules + "star.settings");
    write_text_file(scratch / name, text.replace(text.find(from), from.size(), to));
    return (scratch / name).string();
  }
  ScratchDirectory const scratch;
};

TEST(Molecules, ThatAMappingCannotHoldNameLammpssFiles) {
  StarSettings const star;
  struct Case {
    std::string data, settings, reason;
  };
  std::vector<Case> const cases{
      {"butane.data", molecules + "butane.settings", "'angle_style harmonic'"},
      {"star.data", star.changed("weights", "lj 1 1 1", "lj 1 0 1"),
       "atoms 2 bonds apart count as pairs by the weight 0"},
      {"star.data", star.changed("none", "special_bonds   lj 1 1 1", ""), "special_bonds is not given"},
      {"star.data", star.changed("half", "lj 1 1 1", "lj 0.5 1 1"), "by the weight 0.5"},
      {"star.data", star.changed("morse", "bond_style      harmonic", "bond_style      morse"),
       "'bond_style morse'"},
      {"star.data", star.changed("style", "lj/cut 1.1", "morse 1.1"), "the pair style lj/cut alone"}};
  for (auto const& [data, settings, reason] : cases) {
    auto const file = star.scratch / "map.toml";
    auto const result =
        program({"cg", "mapping", molecules + data, "--settings", settings, "-o", file.string(), "--json"});
    ASSERT_EQ(result.status, 0) << reason << result.errors;
    auto const json = Json::parse(result.output);
    EXPECT_EQ(json["energies"], "LAMMPS");
    EXPECT_NE(json["why_lammps"].get<std::string>().find(reason), std::string::npos) << result.output;
    auto const mapping = read_mapping(file); // whatever folder one is in
    ASSERT_TRUE(mapping.system) << reason;
    EXPECT_EQ(std::filesystem::canonical(mapping.system->data), std::filesystem::canonical(molecules + data));
  }
  EXPECT_EQ(cases.size(), 6u);
}

// Two dimers of charges and an ion in the middle, without other forces: all energies are sums of q q / r.
TEST(Molecules, WithChargesAmongOthersHaveTheEnergiesOfTheirCharges) {
  ScratchDirectory const scratch;
  write_text_file(
      scratch / "ions.data",
      "ions\n\n5 atoms\n2 bonds\n2 atom types\n1 bond types\n0 40 xlo xhi\n0 40 ylo yhi\n0 40 zlo zhi\n\n"
      "Masses\n\n1 2\n2 3\n\nAtoms # full\n\n1 1 1 0.5 10 10 10\n2 1 1 -0.4 11 10 10\n"
      "7 2 2 -0.2 12 12 10\n4 3 1 0.5 14 14 10\n5 3 1 -0.4 15 14 10\n\nBonds\n\n1 1 1 2\n2 1 4 5\n");
  write_text_file(scratch / "ions.settings",
                  "units real\npair_style coul/cut 12\npair_coeff * *\nbond_style harmonic\n"
                  "bond_coeff 1 100 1\nspecial_bonds lj/coul 0 0 0\n");
  write_text_file(
      scratch / "ions.lammpstrj",
      "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n5\nITEM: BOX BOUNDS pp pp pp\n0 40\n0 40\n0 40\n"
      "ITEM: ATOMS id type x y z vx vy vz\n7 2 12 12 10 0 0 0\n1 1 10 10 10 0 0 0\n2 1 11.1 10 10 0 0 0\n"
      "5 1 15 14 10 0 0 0\n4 1 14 14 10 0 0 0\n");
  std::array<Vec3, 5> const q{Vec3{10, 10, 10}, {11.1, 10, 10}, {14, 14, 10}, {15, 14, 10}, {12, 12, 10}};
  std::array<double, 5> const charge{0.5, -0.4, 0.5, -0.4, -0.2};
  double Phi = 0;                       // of the first dimer
  constexpr double coulomb = 332.06371; // kcal Å/mol of two elementary charges, as LAMMPS's units real has it
  for (std::size_t a : {0u, 1u})
    for (std::size_t b : {2u, 3u, 4u})
      Phi += coulomb * charge[a] * charge[b] / norm(q[a] - q[b]) / 2;
  auto const mapping = [&](std::vector<std::string> const& kind) {
    std::vector<std::string> words{"cg", "mapping", scratch / "ions.data"};
    words.insert(words.end(), {"--settings", scratch / "ions.settings", "-o", scratch / "m.toml"});
    words.insert(words.end(), kind.begin(), kind.end());
    return program(words);
  };
  expect_refusal(mapping({}), 2, "cg mapping --kind");
  ASSERT_EQ(mapping({"--kind", "1"}).status, 0);
  auto const made = program({"cg", "blobs", (scratch / "ions.lammpstrj").string(), "--mapping",
                             (scratch / "m.toml").string(), "-o", (scratch / "blobs").string()});
  ASSERT_EQ(made.status, 0) << made.errors;
  auto const data = read_blobs(scratch / "blobs" / "blobs.h5");
  ASSERT_EQ(data.head.molecules, 2);
  EXPECT_NEAR(data.Phi[0], Phi, 1e-9 * std::abs(Phi));
  EXPECT_NEAR(data.U_pot[0], 100 * 0.1 * 0.1, 1e-9);
  EXPECT_NEAR(data.U_pot[1], 0, 1e-9);
  expect_refusal(mapping({"--kind", "3"}), 2, "--kind = 3: must be 1 ... 2");
}

TEST(Molecules, WithWrongCoefficientsBecomeNoMapping) {
  StarSettings const star;
  auto const& scratch = star.scratch;
  struct Case {
    std::string data, settings, said;
  };
  std::vector<Case> const cases{
      {"chain.data", star.changed("unnamed", "bond_style      harmonic", ""), "no bond_style is given"},
      {"chain.data",
       star.changed("twice", "bond_style      harmonic", "bond_style fene\nbond_style      harmonic"),
       "a second bond style"},
      {"star.data", star.changed("five", "1 10 1.615", "1 10 1.615 3"), "has the 2 coefficients K, l"},
      {"star.data", star.changed("negative", "1 10 1.615", "1 -10 1.615"), "K = -10: must be > 0"},
      {"star.data", star.changed("bond", "bond_coeff      2 10 1.147", ""), "bond_coeff = 2"},
      {"star.data", star.changed("pair", "pair_coeff      1 1 1 1", ""), "pair_coeff = 1 1"},
      {"star.data", star.changed("number", "1 10 1.615", "1 ten 1.615"), "K = 'ten'"}};
  for (auto const& [data, settings, said] : cases)
    expect_refusal(program({"cg", "mapping", molecules + data, "--settings", settings, "-o",
                            (scratch / "no.toml").string()}),
                   2, said);
  EXPECT_EQ(cases.size(), 7u);
  EXPECT_FALSE(std::filesystem::exists(scratch / "no.toml"));
}

} // namespace

} // namespace mesobridge::workflows
