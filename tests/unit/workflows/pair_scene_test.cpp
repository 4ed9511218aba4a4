#include "law_keys.hpp"
#include "md/error.hpp"
#include "scratch_directory.hpp"
#include "sdpd/potential/list.hpp"
#include "soft_scene.hpp"
#include "workflows/sdpd/column_file.hpp"
#include "workflows/sdpd/settings.hpp"
#include "workflows/text_file.hpp"
#include <algorithm>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

namespace mesobridge::workflows {
namespace {

std::string const dpde = tests::SoftScene{.N = 1000, .run = "steps = 100\n"}.text();

using tests::error_of, tests::replaced;

TEST(PairScene, ReadsItsKeysAndReadsBackAsTheSame) {
  auto const scene = parse_scene(dpde, "dpde.toml");
  EXPECT_EQ(scene.method.name, "dpde");
  EXPECT_EQ(scene.potential.parameters["a"], 25);
  EXPECT_EQ(scene.friction.gamma_par, 4.5);
  EXPECT_EQ(scene.internal_energy.heat_capacity, 60);
  auto const resolved = resolved_toml(scene);
  EXPECT_TRUE(parse_scene(resolved, "resolved.toml") == scene);
  for (auto const* absent : {"eos", "K =", "kernel", "eta", "h_factor"})
    EXPECT_EQ(resolved.find(absent), std::string::npos) << absent << resolved;
  auto const settings = settings_of(scene, 1);
  ASSERT_TRUE(std::holds_alternative<sdpd::Dpde>(settings.method));
  EXPECT_EQ(settings.dt, 0.01);
  EXPECT_DOUBLE_EQ(settings.spacing(), std::cbrt(1.0 / 3));
  EXPECT_NO_THROW(sdpd::check(settings));
}

// Whatever potential is in the list, a scene can name it, and every key that it needs, and no other.
TEST(PairScene, TakesEveryPotentialByItsOwnKeys) {
  std::string const usual = "name = \"soft\"\na = 25\ncutoff = 1\n";
  int missing = 0, foreign = 0;
  for (auto const& kind : sdpd::potentials()) {
    tests::LawKeys const keys("potential.name", kind, [](sdpd::Parameter const& of) {
      return fmt::format("{} = {}\n", of.name, of.range.min > 0 ? 2 * of.range.min : 1);
    });
    missing += expect_all_keys_needed(dpde, usual, keys);
    auto const knows = [&](auto const& name) {
      return std::ranges::find(kind.parameters, name, &sdpd::Parameter::name) != kind.parameters.end();
    };
    for (auto const& other : sdpd::potentials())
      for (auto const& parameter : other.parameters)
        if (!knows(parameter.name)) {
          expect_foreign_key(dpde, usual, keys, fmt::format("{} = 9\n", parameter.name));
          ++foreign;
        }
  }
  EXPECT_GE(missing, 11);
  EXPECT_GE(foreign, 20);
}

/// The same fluid in SI: k_B T, m and r_c of some substance.
std::string const si = R"(title = "DPDE"
[method]
name = "dpde"
[fluid]
rho = "3000 kg/m^3"
T = "300 K"
[particles]
N = 1000
mass = "1e-24 kg"
[potential]
name = "soft"
a = "1.0354867500e-10 N"
cutoff = "1 nm"
[friction]
gamma_par = "2.896108e-13 kg/s"
cutoff = "1 nm"
[internal_energy]
heat_capacity = 60
[scheme]
dt = "0.1 ps"
[run]
steps = 100
)";

// All reduced quantities are those of the plain scene.
TEST(PairScene, InSiIsTheSameFluid) {
  auto const plain = settings_of(parse_scene(dpde, "dpde.toml"), 1),
             physical = settings_of(parse_scene(si, "si.toml"), 1);
  auto const units = physical.units();
  EXPECT_DOUBLE_EQ(units.length(), 1e-9);
  EXPECT_DOUBLE_EQ(units.energy(), 1.380649e-23 * 300);
  EXPECT_NEAR(physical.spacing(), plain.spacing(), 1e-12);
  EXPECT_NEAR(physical.dt * units.time(), 1e-13, 1e-22);
  auto force = [](sdpd::SimulationSettings const& s) {
    auto const potential = s.as<sdpd::Dpde>().parts(s).potential;
    return std::get<sdpd::SoftPotential>(potential)(0.5, 2.0).strength;
  };
  EXPECT_NEAR(force(physical) / force(plain), 1, 1e-6);
  auto friction = [](sdpd::SimulationSettings const& s) {
    auto const law = s.as<sdpd::Dpde>().parts(s).law;
    auto const& shape = std::get<sdpd::DpdeLaw<sdpd::Transverse::none>>(law).shape;
    return std::get<sdpd::PowerFriction>(shape)(0.5).par;
  };
  EXPECT_NEAR(friction(physical) / friction(plain), 1, 1e-3);
}

TEST(PairScene, RefusesWhatDoesNotBelongTogether) {
  struct Case {
    std::string what, by;
    std::vector<std::string> message;
  };
  std::vector<Case> const cases{
      {"\"dpde\"", "\"dpdee\"", {"method.name", "dpde"}},
      {"N = 1000", "N = 1000\nK = 10", {"particles.K", "sdpd"}},
      {"mass = 1\n", "", {"particles.mass", "missing"}},
      {"a = 25\n", "", {"potential.a", "soft"}},
      {"a = 25\n", "a = 25\nsigma = 1\n", {"potential.sigma", "lj"}},
      {"\"soft\"", "\"lj\"", {"potential.a", "not to \"lj\""}},
      {"gamma_par = 4.5\n", "", {"friction.gamma_par"}},
      {"gamma_par = 4.5", "gamma_par = -1", {"friction.gamma_par"}},
      {"heat_capacity = 60", "", {"internal_energy.heat_capacity"}},
      {"heat_capacity = 60", "heat_capacity = 0", {"internal_energy.heat_capacity", "> 0"}},
      {"heat_capacity = 60", "model = \"none.toml\"", {"internal_energy.model", "none.toml"}},
      {"name = \"dpde\"", "name = \"dpd\"", {"internal_energy.heat_capacity", "dpde"}},
      {"[scheme]", "[conduction]\nkappa = -1\n[scheme]", {"conduction.kappa", "-1"}},
      {"[scheme]", "[conduction]\ncutoff = 1\n[scheme]", {"conduction.cutoff", "conduction.kappa"}},
      {"[scheme]", "[conduction]\nexponent = 3\n[scheme]", {"conduction.exponent", "conduction.kappa"}},
      {"[scheme]", "[conduction]\nfile = \"none.csv\"\n[scheme]", {"conduction.file", "none.csv"}},
      {"[scheme]", "[conduction]\nkapa = 1\n[scheme]", {"kapa", "kappa"}},
  };
  int ran = 0;
  for (auto const& [what, by, parts] : cases) {
    auto const message = error_of(replaced(dpde, what, by));
    for (auto const& part : parts)
      EXPECT_NE(message.find(part), std::string::npos) << "looked for " << part << " in: " << message;
    ++ran;
  }
  EXPECT_EQ(ran, 17);
  auto dpd = replaced(replaced(dpde, "name = \"dpde\"", "name = \"dpd\""),
                      "[internal_energy]\nheat_capacity = 60\n", "");
  EXPECT_EQ(error_of(dpd), "no error");
  EXPECT_NE(error_of(dpd + "[conduction]\nkappa = 1\n").find("dpde"), std::string::npos);
  EXPECT_NE(error_of(replaced(dpd, "dt = 0.01", "dt = 0.01\nname = \"ems\"")).find("no internal energies"),
            std::string::npos);
}

/// The conduction's weight of a pair at distance r, reduced.
double conduction_weight(Scene const& scene, double r) {
  auto const settings = settings_of(scene, 1);
  auto const law = settings.as<sdpd::Dpde>().parts(settings).conduction;
  return std::visit([r](auto const& shape) { return shape(r).par; },
                    std::get<sdpd::DpdeConduction>(law).shape);
}

// In SI: energy temperature/time with k_B T = 4.141947e-21 J, T = 300 K and the time r_c (m/k_B T)^(1/2).
TEST(PairScene, ReadsConductionInBothUnitSystems) {
  auto const reduced = parse_scene(dpde + "[conduction]\nkappa = 20\ncutoff = 1.5\n", "dpde.toml");
  EXPECT_DOUBLE_EQ(conduction_weight(reduced, 0.75), 5);
  EXPECT_TRUE(parse_scene(resolved_toml(reduced), "resolved.toml") == reduced);
  EXPECT_DOUBLE_EQ(settings_of(reduced, 1).range(), 1.5);
  auto const as_friction = parse_scene(dpde + "[conduction]\nkappa = 20\nexponent = 1\n", "dpde.toml");
  EXPECT_DOUBLE_EQ(conduction_weight(as_friction, 0.75), 5);
  EXPECT_FALSE(settings_of(parse_scene(dpde, "dpde.toml"), 1).conducts());

  double const kappa = 20 * 4.141947e-21 * 300 / (1e-9 * std::sqrt(1e-24 / 4.141947e-21));
  auto const physical = parse_scene(si + fmt::format("[conduction]\nkappa = \"{} W*K\"\n", kappa), "si.toml");
  EXPECT_NEAR(conduction_weight(physical, 0.5), 5, 1e-5);
}

TEST(PairScene, TakesTablesAndModelsFromFiles) {
  tests::ScratchDirectory const scratch;
  std::string potential = "# r,u,f\nr,u,f\n";
  for (double r = 0.05; r <= 1; r += 0.05)
    potential += fmt::format("{},{},{}\n", r, 12.5 * (1 - r) * (1 - r), 25 * (1 - r));
  write_text_file(scratch / "u.csv", potential);
  write_text_file(scratch / "gamma.csv", "r,gamma_par\n0,4.5\n0.5,1.1\n1.0,0\n");
  write_text_file(scratch / "model.toml",
                  "format = \"mesobridge internal energy 1\"\nkind = \"constant\"\ntemperature_unit = "
                  "\"reduced\"\n[constant]\nC_kB = 30.0\n");
  auto text = replaced(dpde, "name = \"soft\"\na = 25\ncutoff = 1", "name = \"table\"\nfile = \"u.csv\"");
  text = replaced(text, "gamma_par = 4.5\ncutoff = 1", "file = \"gamma.csv\"");
  text = replaced(text, "heat_capacity = 60", "model = \"model.toml\"");
  write_text_file(scratch / "kappa.csv", "r,kappa\n0,8\n0.5,2\n1.2,0\n");
  text += "[conduction]\nfile = \"kappa.csv\"\n";
  auto const scene = parse_scene(text, scratch / "scene.toml");
  EXPECT_NEAR(conduction_weight(scene, 0.5), 2, 1e-3);
  try {
    parse_scene(replaced(text, "[friction]", "[friction]\nexponent = 3"), scratch / "scene.toml");
    FAIL();
  } catch (InputError const& error) {
    EXPECT_NE(std::string(error.what()).find("friction.file"), std::string::npos) << error.what();
  }
  try {
    parse_scene(text + "kappa = 1\n", scratch / "scene.toml");
    FAIL();
  } catch (InputError const& error) {
    EXPECT_NE(std::string(error.what()).find("stands in place of kappa"), std::string::npos) << error.what();
  }
  auto const settings = settings_of(scene, 1);
  auto const& fluid = settings.as<sdpd::Dpde>();
  EXPECT_NEAR(std::get<sdpd::TabulatedPotential>(fluid.potential)(0.325, 1 / 0.325).strength * 0.325,
              25 * 0.675, 1e-6);
  EXPECT_NEAR(std::get<sdpd::TabulatedFriction>(fluid.friction)(0.5).par, 1.1, 1e-3);
  EXPECT_EQ(std::get<fitting::ConstantHeatCapacity>(fluid.internal_energy).heat_capacity(1), 30);

  write_text_file(scratch / "bad.csv", "r,u\n0.1,2\n0.2,x\n");
  try {
    read_columns(scratch / "bad.csv", {"r", "u"}, {});
    FAIL();
  } catch (InputError const& error) {
    EXPECT_NE(std::string(error.what()).find("bad.csv:3: column 'u': 'x' must be"), std::string::npos)
        << error.what();
  }
  EXPECT_THROW(read_columns(scratch / "bad.csv", {"r"}, {}), InputError);
  write_text_file(scratch / "kappa.csv", "r,kappa\n0,8\n0.5,-2\n1.2,0\n");
  try {
    settings_of(scene, 1);
    FAIL();
  } catch (InputError const& error) {
    std::string const message = error.what();
    for (auto const* part : {"conduction.file", "kappa.csv", "-2", ">= 0"})
      EXPECT_NE(message.find(part), std::string::npos) << message;
  }
  EXPECT_THROW(read_columns(scratch / "bad.csv", {"r", "u", "f"}, {}), InputError);
}

std::string const particle = R"(format = "mesobridge particle 1"
kind = "constant"
temperature_unit = "reduced"
[constant]
C_kB = 30.0
[particle]
mass = 2.0
[potential]
points = 4
r = [0.0, 0.5, 0.75, 1.0]
u = [8.0, 2.0, 0.5, 0.0]
[friction]
points = 3
r = [0.0, 0.5, 1.0]
gamma_par = [4.0, 1.0, 0.0]
gamma_perp = [2.0, 0.5, 0.0]
[conduction]
points = 3
r = [0.0, 0.5, 1.5]
kappa = [9.0, 3.0, 0.0]
)";

/// The scene with its mass, potential, friction and internal energy left to a model.
std::string scene_by_model(std::string const& more = "") {
  auto text = replaced(dpde, "mass = 1\n", "model = \"particle.toml\"\n");
  text = replaced(text, "[potential]\nname = \"soft\"\na = 25\ncutoff = 1\n", "");
  text = replaced(text, "[friction]\ngamma_par = 4.5\ncutoff = 1\n", "");
  return replaced(text, "[internal_energy]\nheat_capacity = 60\n", "") + more;
}

TEST(PairScene, TakesAllOfAParticleFromItsModel) {
  tests::ScratchDirectory const scratch;
  write_text_file(scratch / "particle.toml", particle);
  auto const scene = parse_scene(scene_by_model(), scratch / "scene.toml");
  EXPECT_EQ(scene.particles.mass, 2);
  auto const settings = settings_of(scene, 1);
  auto const& fluid = settings.as<sdpd::Dpde>();
  EXPECT_EQ(fluid.mass, 2);
  EXPECT_NEAR(std::get<sdpd::TabulatedFriction>(fluid.friction)(0.5).perp, 0.5, 1e-3);
  EXPECT_EQ(std::get<fitting::ConstantHeatCapacity>(fluid.internal_energy).heat_capacity(1), 30);
  EXPECT_NEAR(std::get<sdpd::TabulatedFriction>(fluid.conduction.value())(0.5).par, 3, 1e-3);
  EXPECT_TRUE(std::holds_alternative<sdpd::TabulatedPotential>(fluid.potential));
  EXPECT_TRUE(parse_scene(resolved_toml(scene), "elsewhere.toml") == scene);
}

TEST(PairScene, WhatItSaysTakesThePlaceOfItsModel) {
  tests::ScratchDirectory const scratch;
  write_text_file(scratch / "particle.toml", particle);
  auto const of = [&](std::string const& more) {
    auto const scene = parse_scene(scene_by_model(more), scratch / "scene.toml");
    EXPECT_TRUE(parse_scene(resolved_toml(scene), "elsewhere.toml") == scene);
    return settings_of(scene, 1).as<sdpd::Dpde>();
  };
  EXPECT_TRUE(
      std::holds_alternative<sdpd::PowerFriction>(of("[friction]\ngamma_par = 1\ncutoff = 1\n").friction));
  EXPECT_FALSE(of("[conduction]\nkappa = 0\n").conduction);
  EXPECT_TRUE(std::holds_alternative<sdpd::NoPotential>(of("[potential]\nname = \"none\"\n").potential));
  auto const heavy = of("[internal_energy]\nheat_capacity = 70\n");
  EXPECT_EQ(std::get<fitting::ConstantHeatCapacity>(heavy.internal_energy).heat_capacity(1), 70);
}

TEST(PairScene, NamesWhatItsModelLacks) {
  tests::ScratchDirectory const scratch;
  auto const error = [&](std::string const& model, std::string const& more = "") {
    write_text_file(scratch / "particle.toml", model);
    try {
      parse_scene(scene_by_model(more), scratch / "scene.toml");
      return std::string("no error");
    } catch (InputError const& refused) {
      return std::string(refused.what());
    }
  };
  auto const without = [](std::string const& part) {
    auto const begin = particle.find(part), end = particle.find("\n[", begin);
    return particle.substr(0, begin) + (end == std::string::npos ? "" : particle.substr(end + 1));
  };
  EXPECT_EQ(error(particle), "no error");
  EXPECT_EQ(error(without("[conduction]")), "no error");
  EXPECT_EQ(error(without("[potential]")), "no error");
  EXPECT_NE(error(without("[particle]")).find("particles.mass"), std::string::npos);
  EXPECT_NE(error(without("[friction]")).find("friction.gamma_par"), std::string::npos);
  EXPECT_NE(error(without("[potential]"), "[potential]\nname = \"model\"\n").find("potential.name"),
            std::string::npos);
  EXPECT_NE(error(replaced(particle, "reduced", "K")).find("particle.toml"), std::string::npos);
  EXPECT_NE(error(replaced(particle, "C_kB = 30.0", "C_kB = 0.0")).find("must be > 0"), std::string::npos);
}

} // namespace
} // namespace mesobridge::workflows
