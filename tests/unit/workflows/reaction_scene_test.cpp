#include "law_keys.hpp"
#include "md/error.hpp"
#include "sdpd/kinetics/list.hpp"
#include "sdpd/simulation.hpp"
#include "sdpd_scene.hpp"
#include "workflows/quantity.hpp"
#include "workflows/sdpd/run_checks.hpp"
#include "workflows/sdpd/settings.hpp"
#include <gtest/gtest.h>

namespace mesobridge::workflows {
namespace {

using tests::error_of, tests::replaced;

std::string const burning = tests::burning_scene("steps = 100\n").text();

TEST(ReactionScene, ReadsItsKeysAndReadsBackAsTheSame) {
  auto const scene = parse_scene(burning, "burning.toml");
  EXPECT_TRUE(scene.features().reacts);
  EXPECT_TRUE(parse_scene(resolved_toml(scene), "resolved.toml") == scene) << resolved_toml(scene);
  auto const settings = settings_of(scene, 1);
  EXPECT_NO_THROW(sdpd::check(settings));
  auto const& reaction = settings.as<sdpd::Sdpd>().reaction.value();
  EXPECT_NEAR(reaction.heat, 4.7159e6, 2e2); // 4.78e-19 J in 61.04 u
  EXPECT_EQ(reaction.progress, 0.3);
  auto const& law = std::get<sdpd::SecondOrder>(reaction.kinetics);
  EXPECT_EQ(law.forward.Z, 1e15);
  EXPECT_EQ(law.forward.T_a, 3e-19); // the energy, until it is in the engine's units
  EXPECT_NEAR(law.in_units(settings.units()).forward.T_a * 2500, 21728.9, 0.1);
  EXPECT_EQ(law.weights, sdpd::NeighbourWeights::kernel);
  auto const other =
      parse_scene(burning, "burning.toml",
                  {"reaction.weights=normalised", "reaction.integrator=euler", "reaction.volumes=paper"});
  EXPECT_TRUE(parse_scene(resolved_toml(other), "resolved.toml") == other);
  auto const changed = settings_of(other, 1).as<sdpd::Sdpd>().reaction.value();
  EXPECT_EQ(std::get<sdpd::SecondOrder>(changed.kinetics).weights, sdpd::NeighbourWeights::normalised);
  EXPECT_EQ(changed.integrator, sdpd::RateIntegrator::euler);
  EXPECT_FALSE(changed.additive_volumes);
}

// Whatever law is in the list, a scene can name it, and every key that it needs, and no other.
TEST(ReactionScene, TakesEveryLawByItsOwnKeys) {
  std::string const usual = "kinetics = \"second-order\"\nZ = \"1e15 1/s\"\nE_a = \"3e-19 J\"\n";
  int missing = 0, foreign = 0;
  for (auto const& law : sdpd::kinetics()) {
    tests::LawKeys const keys("reaction.kinetics", law, [](sdpd::Parameter const& of) {
      return of.dimension ? fmt::format("{} = \"2 {}\"\n", of.name, si_unit(*of.dimension))
                          : fmt::format("{} = 2\n", of.name);
    });
    missing += expect_all_keys_needed(burning, usual, keys);
    expect_foreign_key(burning, usual, keys,
                       law.name == "pressure" ? "E_a = \"1e-19 J\"\n" : "growth_power = 2\n");
    ++foreign;
  }
  EXPECT_EQ(foreign, 6);
  EXPECT_GE(missing, 20);
}

TEST(ReactionScene, RefusesWhatDoesNotGoTogether) {
  auto const refused = [](std::string const& old, std::string const& now, std::string const& words) {
    auto const error = error_of(replaced(burning, old, now));
    EXPECT_NE(error.find(words), std::string::npos) << now << ": " << error;
  };
  refused("product = \"nitromethane-products\"\n", "", "needs reaction.product");
  refused("heat_per_molecule = \"4.78e-19 J\"\n", "", "needs the heat of reaction");
  refused("heat_per_molecule", "heat = \"1e6 J/kg\"\nheat_per_molecule", "needs the heat of reaction");
  refused("nitromethane-products", "nitromethane-product", "did you mean");
  refused("progress = 0.3", "progress = 1.3", "from 0 to 1");
  refused("kinetics = \"second-order\"", "kinetics = \"first-order\"\nweights = \"normalised\"",
          "second-order kinetics only");
  refused("[transport]", "[[region]]\nshape = \"slab\"\nto = \"50 %\"\neos = \"water\"\n[transport]",
          "must be fluid.eos");
  refused("[transport]", "[[region]]\nshape = \"slab\"\nto = \"50 %\"\nK = 50\n[transport]",
          "must be particles.K");
  auto const plain = replaced(
      burning,
      burning.substr(burning.find("[reaction]"), burning.find("[transport]") - burning.find("[reaction]")),
      "");
  EXPECT_EQ(error_of(plain), "no error");
  EXPECT_NE(error_of(replaced(plain, "[transport]",
                              "[[region]]\nshape = \"slab\"\nto = \"50 %\"\nprogress = 1\n[transport]"))
                .find("needs reaction.product"),
            std::string::npos);
}

TEST(ReactionScene, BeginsRegionsWithTheirProgress) {
  auto const text =
      replaced(burning, "[transport]",
               "[[region]]\nshape = \"slab\"\nto = \"25 %\"\nprogress = 1\nT = \"4800 K\"\n[transport]");
  auto const settings = settings_of(parse_scene(text, "scene.toml"), 1);
  auto const& regions = settings.layout->regions();
  ASSERT_EQ(regions.size(), 2u);
  EXPECT_EQ(regions[0].progress, 0.3);
  EXPECT_EQ(regions[1].progress, 1);
  EXPECT_TRUE(settings.as<sdpd::Sdpd>().species.empty());
}

// A particle that has burnt is one of the product alone, of fewer molecules if they are heavier; `check` says
// what `run` would, with the key.
TEST(ReactionScene, RefusesParticlesThatCannotBeTheProduct) {
  auto const refusal = [](std::vector<std::string> const& overrides) -> std::string {
    auto const scene =
        parse_scene(replaced(burning, "steps = 100", "steps = 1000"), "burning.toml", overrides);
    try {
      check_run(scene, 1);
    } catch (InputError const& error) {
      EXPECT_THROW(sdpd::check(settings_of(scene, 1)), InputError);
      return error.what();
    }
    EXPECT_NO_THROW(sdpd::Simulation(settings_of(scene, 1)));
    return "none";
  };
  std::vector<std::string> const gas{"fluid.eos=ideal-gas", "fluid.m0=39.948 u", "fluid.T=1500 K",
                                     "fluid.rho=1150 kg/m^3", "reaction.progress=0"};
  auto const of_gas = [&](std::vector<std::string> more) {
    more.insert(more.begin(), gas.begin(), gas.end());
    return refusal(more);
  };
  EXPECT_EQ(of_gas({}), "none");
  auto const small = of_gas({"particles.K=5.576", "reaction.product=pbx-9502-products"});
  EXPECT_TRUE(small.starts_with("particles.K = 5.576: is too small")) << small;
  EXPECT_NE(small.find("0.8629 molecules"), std::string::npos) << small;
  EXPECT_EQ(of_gas({"particles.K=5.576", "reaction.product=pbx-9502-products", "fluid.centre_of_mass=bulk"}),
            "none");
  EXPECT_TRUE(refusal({"reaction.product=argon"}).starts_with("reaction.product = argon: cannot be a part"));
  EXPECT_TRUE(refusal({"fluid.eos=argon", "fluid.rho=1150 kg/m^3", "fluid.T=500 K"})
                  .starts_with("fluid.eos = argon: cannot be a part"));
}

} // namespace
} // namespace mesobridge::workflows
