#include "md/error.hpp"
#include "scene_error.hpp"
#include "workflows/scene/scene.hpp"
#include "workflows/sdpd/density_constants.hpp"
#include "workflows/sdpd/settings.hpp"
#include <filesystem>
#include <fmt/core.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>

namespace mesobridge::workflows {

namespace {

std::string const good = R"(title = "Argon"
units = "SI"
[fluid]
eos = "argon"
rho = "1150 kg/m^3"
T = "1000 K"
[particles]
N = 1000
K = 100
[transport]
eta = "2 mPa*s"
[scheme]
dt = "1.5 fs"
[run]
steps = 100
)";

using tests::error_of, tests::replaced;

TEST(Scene, ReadsEveryValueInSI) {
  auto const scene = parse_scene(good, "good.toml");
  EXPECT_EQ(scene.title, "Argon");
  EXPECT_EQ(scene.units, UnitSystem::SI);
  EXPECT_EQ(scene.fluid.rho, 1150);
  EXPECT_EQ(scene.fluid.T, 1000);
  EXPECT_FALSE(scene.fluid.m0);
  EXPECT_EQ(scene.particles.K, 100);
  EXPECT_EQ(scene.particles.kernel, "wendland-c4");
  EXPECT_EQ(scene.particles.density, "auto");
  EXPECT_EQ(scene.transport.eta, 2e-3);
  EXPECT_FALSE(scene.scheme.dt.reduced);
  EXPECT_DOUBLE_EQ(scene.scheme.dt.value, 1.5e-15);
  EXPECT_EQ(scene.run.seed, 1);
}

TEST(Scene, OverridesWinOverTheFile) {
  auto const scene = parse_scene(good, "good.toml",
                                 {"fluid.rho=1.2 g/cm^3", "scheme.dt=0.05", "run.seed=7",
                                  "fluid.eos=ideal-gas", "fluid.m0=\"1e-25 kg\"", "output.directory=here"});
  EXPECT_EQ(scene.fluid.rho, 1200);
  EXPECT_EQ(scene.scheme.dt, (TimeStep{0.05, true}));
  EXPECT_EQ(scene.run.seed, 7);
  EXPECT_EQ(scene.fluid.m0, 1e-25);
  EXPECT_EQ(scene.output.directory, "here");
}

TEST(Scene, ReducedUnitsTakePlainNumbers) {
  auto text = replaced(good, "\"SI\"", "\"lj\"");
  text = replaced(replaced(text, "\"argon\"", "\"lj\""), "\"1150 kg/m^3\"", "0.68");
  text = replaced(replaced(replaced(text, "\"1000 K\"", "8"), "\"2 mPa*s\"", "1.5"), "\"1.5 fs\"", "0.01");
  auto const scene = parse_scene(text, "lj.toml");
  EXPECT_EQ(scene.fluid.rho, 0.68);
  EXPECT_EQ(scene.fluid.T, 8);
  EXPECT_NE(error_of(replaced(text, "rho = 0.68", "rho = \"0.68 kg/m^3\"")).find("bad.toml:5: fluid.rho"),
            std::string::npos);
}

std::string lj_scene(std::string const& dt) {
  auto text = replaced(good, "\"SI\"", "\"lj\"");
  text = replaced(replaced(text, "\"argon\"", "\"lj\""), "\"1150 kg/m^3\"", "0.68");
  text = replaced(replaced(text, "\"1000 K\"", "8"), "\"2 mPa*s\"", "1.5");
  return replaced(text, "\"1.5 fs\"", dt);
}

TEST(Scene, TakesATimeStepInLennardJonesTimes) {
  int cases = 0;
  for (auto const& [text, dt] : {std::pair("\"0.05 tau\"", TimeStep{0.05, false}),
                                 {"\"2e-3tau\"", TimeStep{2e-3, false}},
                                 {"0.05", TimeStep{0.05, true}}}) {
    auto const scene = parse_scene(lj_scene(text), "lj.toml");
    EXPECT_EQ(scene.scheme.dt, dt) << text;
    EXPECT_EQ(parse_scene(resolved_toml(scene), "resolved.toml"), scene) << text;
    ++cases;
  }
  EXPECT_EQ(cases, 3);
  // sigma (m/epsilon)^(1/2) is one; the engine's unit is (m/rho)^(1/3) (m_0/k_B T)^(1/2), m = 100, m_0 = 1.
  auto const settings = settings_of(parse_scene(lj_scene("\"0.05 tau\""), "lj.toml"), 1);
  EXPECT_NEAR(settings.dt, 0.05 / (std::cbrt(100 / 0.68) * std::sqrt(1 / 8.0)), 1e-15);
  for (auto const* text :
       {"\"0.05 fs\"", "\"0.05\"", "\"-1 tau\"", "\"nan tau\"", "\"tau\"", "\"0.05 taus\""})
    for (auto const* part : {"bad.toml:13: scheme.dt", "0.05 tau", "auto"})
      EXPECT_NE(error_of(lj_scene(text)).find(part), std::string::npos) << text << error_of(lj_scene(text));
  EXPECT_NE(error_of(replaced(good, "1.5 fs", "1.5 tau")).find("wrong unit 'tau'"), std::string::npos);
}

TEST(Scene, CalibratesItsDensitiesUnlessThatMakesNoSense) {
  struct Case {
    std::vector<std::string> overrides;
    bool calibrates;
  };
  std::vector<Case> const cases{
      {{}, true},
      {{"particles.density=plain"}, false},
      {{"particles.density=glass"}, false},
      {{"particles.density_scale=1.02", "particles.density_self=0.2"}, false}, // found before
      {{"particles.density=calibrated"}, true},
      {{"method.name=sph"}, false},
      {{"method.name=sph", "particles.density=calibrated"}, true},
      {{"scheme.conservative=none"}, false},
      {{"fluid.rho=1400 kg/m^3", "fluid.T=87 K"}, true},                     // by the response
      {{"fluid.eos=water", "fluid.rho=900 kg/m^3", "fluid.T=300 K"}, false}, // under tension
  };
  for (auto const& [overrides, calibrates] : cases)
    EXPECT_EQ(wants_calibration(parse_scene(good, "good.toml", overrides)), calibrates) << overrides.size();
  EXPECT_EQ(cases.size(), 10u);
}

TEST(Scene, CalibratesForAQuarterOfTheRun) {
  int cases = 0;
  for (auto const& [steps, equilibrate, expected] :
       {std::tuple(100, 0, 200), {4000, 2000, 1500}, {1000000, 0, 6000}}) {
    auto const scene =
        parse_scene(good, "good.toml",
                    {fmt::format("run.steps={}", steps), fmt::format("run.equilibrate={}", equilibrate)});
    EXPECT_EQ(calibration_steps(scene), expected);
    ++cases;
  }
  EXPECT_EQ(cases, 3);
  EXPECT_EQ(calibration_steps(parse_scene(good, "good.toml", {"particles.calibration_steps=777"})), 777);
  EXPECT_NE(error_of(replaced(good, "K = 100", "K = 100\ncalibration_steps = 7"))
                .find("bad.toml:10: particles.calibration_steps"),
            std::string::npos);
}

TEST(Scene, ReadsWhatTextsWereCalledBefore) {
  auto const old = parse_scene(lj_scene("0.05\nconservative = \"two-stage\""), "lj.toml");
  EXPECT_EQ(old.scheme.conservative, "mclachlan");
  ASSERT_EQ(old.notes.size(), 1u);
  for (auto const& part : {"lj.toml:", "scheme.conservative = \"two-stage\"", "\"mclachlan\" now"})
    EXPECT_NE(old.notes[0].find(part), std::string::npos) << old.notes[0];
  auto const now = parse_scene(resolved_toml(old), "r.toml");
  EXPECT_EQ(now.scheme.conservative, "mclachlan");
  EXPECT_TRUE(now.notes.empty());
}

TEST(Scene, ReadsTheNoiseThatWasAKeyOfTheScheme) {
  auto const old = parse_scene(good, "good.toml", {"scheme.noise=off"});
  EXPECT_FALSE(old.noise());
  ASSERT_EQ(old.notes.size(), 1u);
  EXPECT_NE(old.notes[0].find("--set: scheme.noise = \"off\": is method.name = \"sph\" now"),
            std::string::npos)
      << old.notes[0];
  auto const now = parse_scene(resolved_toml(old), "r.toml");
  EXPECT_EQ(now.method.name, "sph");
  EXPECT_TRUE(now.notes.empty());
  EXPECT_TRUE(parse_scene(good, "good.toml", {"scheme.noise=on"}).noise());
  int refused = 0;
  for (auto const& [noise, method] :
       {std::pair("off", "dpd"), {"on", "sph"}, {"maybe", "sdpd"}, {"1", "sdpd"}})
    try {
      parse_scene(good, "good.toml",
                  {fmt::format("scheme.noise={}", noise), fmt::format("method.name={}", method)});
    } catch (InputError const& error) {
      EXPECT_NE(std::string(error.what()).find("--set: scheme.noise"), std::string::npos) << error.what();
      ++refused;
    }
  EXPECT_EQ(refused, 4);
  EXPECT_THROW(parse_scene("method = \"sdpd\"\n" + std::string(good), "s.toml", {"scheme.noise=off"}),
               InputError);
}

TEST(Scene, ReadsWholeNumbersThatNoDoubleHolds) {
  auto const scene = parse_scene(lj_scene("0.05"), "lj.toml", {"fluid.T=9223372036854775807"});
  EXPECT_EQ(scene.fluid.T, 0x1p63);
}

TEST(Scene, BadInputNamesFileLineKeyValueAndWhatIsAllowed) {
  struct Case {
    std::string what, by;
    std::vector<std::string> parts; ///< all of them stand in the message
  };
  std::vector<Case> const cases{
      {"rho =", "rhp =", {"bad.toml:5", "fluid.rhp", "did you mean 'rho'"}},
      {"[particles]", "[particle]", {"bad.toml:7", "particle", "did you mean 'particles'"}},
      {"K = 100", "eta = 1", {"bad.toml:9", "particles.eta", "it belongs into [transport]"}},
      {"\"1150 kg/m^3\"", "1150", {"bad.toml:5", "fluid.rho = 1150", "a unit is missing", "kg/m^3"}},
      {"1150 kg/m^3", "1150 kg/m", {"bad.toml:5", "fluid.rho", "wrong unit 'kg/m'", "did you mean 'kg/m^3'"}},
      {"1150 kg/m^3", "-1150 kg/m^3", {"bad.toml:5", "-1150 kg/m^3", "> 0"}},
      {"1150 kg/m^3", "nan kg/m^3", {"bad.toml:5", "nan kg/m^3", "not a finite number"}},
      {"1150 kg/m^3", "1150", {"bad.toml:5", "the unit is missing"}},
      {"\"1000 K\"", "true", {"bad.toml:6", "fluid.T = true"}},
      {"1000 K", "0 K", {"bad.toml:6", "fluid.T", "> 0"}},
      {"K = 100", "K = 0.5", {"bad.toml:9", "particles.K = 0.5", ">= 1"}},
      {"K = 100", "K = nan", {"bad.toml:9", "particles.K = nan", ">= 1"}},
      {"K = 100", "K = inf", {"bad.toml:9", "particles.K = inf"}},
      {"K = 100", "K = \"100\"", {"bad.toml:9", "particles.K = \"100\"", "a number"}},
      {"K = 100", "K = [10, 100]", {"bad.toml:9", "particles.K = [", "a number"}},
      {"N = 1000", "N = 1000.5", {"bad.toml:8", "particles.N = 1000.5", "an integer >= 1"}},
      {"N = 1000", "N = -3", {"bad.toml:8", "particles.N = -3", ">= 1"}},
      {"K = 100",
       "K = 100\nkernel = \"cubik\"",
       {"bad.toml:10", "cubik", "\"cubic\", \"lucy\"", "did you mean 'cubic'"}},
      {"\"2 mPa*s\"",
       "\"2 mPa*s\"\nzeta = \"4 mPa*s\"",
       {"bad.toml:12", "transport.zeta = 0.004", "5 eta / 3"}},
      {"\"2 mPa*s\"", "\"2 mPa*s\"\nzeta = \"-1 mPa*s\"", {"bad.toml:12", "transport.zeta", ">= 0"}},
      {"\"2 mPa*s\"", "\"2 mPa*s\"\nkappa = 0.1", {"bad.toml:12", "transport.kappa = 0.1", "W/(m*K)"}},
      {"\"2 mPa*s\"", "\"2 mPa*s\"\nkappa = \"-1 W/(m*K)\"", {"bad.toml:12", "transport.kappa", ">= 0"}},
      {"\"1.5 fs\"",
       "0.1\nname = \"ems\"\nnoise = \"off\"",
       {"bad.toml:14", "scheme.name", "without noise", "Metropolis"}},
      {"steps = 100", "steps = 100\nbath_rate = 0", {"bad.toml:16", "run.bath_rate = 0", "> 0"}},
      {"1.5 fs", "-1.5 fs", {"bad.toml:13", "scheme.dt", "> 0"}},
      {"\"1.5 fs\"", "0", {"bad.toml:13", "scheme.dt = 0", "> 0"}},
      {"\"argon\"", "\"argom\"", {"bad.toml:4", "fluid.eos", "did you mean 'argon'"}},
      {"\"argon\"", "\"ideal-gas\"", {"bad.toml:4", "fluid.m0"}},
      {"\"argon\"", "\"argon\"\nm0 = \"1 u\"", {"bad.toml:5", "fluid.m0", "ideal-gas"}},
      {"\"argon\"", "\"lj\"", {"bad.toml:4", "fluid.eos = lj", "units"}},
      {"\"argon\"", "\"no/such.toml\"", {"bad.toml:4", "no/such.toml", "no model file"}},
      {"\"SI\"", "\"si\"", {"bad.toml:2", "units = \"si\"", "\"SI\", \"lj\""}},
      {"title = \"Argon\"", "", {"bad.toml", "'title' is missing"}},
      {"steps = 100", "", {"bad.toml", "'run.steps' is missing"}},
      {"steps = 100",
       "steps = 100\ninstant_every = 7",
       {"bad.toml:16", "run.instant_every", "too few instants"}},
      {"steps = 100", "steps = 100\nsample_every = 101", {"bad.toml:16", "run.sample_every", "<= run.steps"}},
      {"steps = 100", "steps = 100\nseed = -1", {"bad.toml:16", "run.seed = -1", ">= 0"}},
      {"[fluid]", "fluid = 3\n[fluids]", {"bad.toml:3", "fluid = 3", "[fluid]"}},
      {"title = \"Argon\"", "title = \"Argon", {"bad.toml:1"}},
      {"K = 100", "K = 100\nK = 10", {"bad.toml:10"}},
  };
  int ran = 0;
  for (auto const& [what, by, parts] : cases) {
    auto const message = error_of(replaced(good, what, by));
    for (auto const& part : parts)
      EXPECT_NE(message.find(part), std::string::npos) << "looked for " << part << " in: " << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    ++ran;
  }
  EXPECT_EQ(ran, 40);
}

TEST(Scene, BadOverridesAreTracedToTheCommandLine) {
  EXPECT_NE(error_of(good, {"fluid.rho=-1 kg/m^3"}).find("--set: fluid.rho"), std::string::npos);
  EXPECT_NE(error_of(good, {"fluid.rhp=1 kg/m^3"}).find("--set: unknown key 'fluid.rhp'; did you mean"),
            std::string::npos);
  EXPECT_NE(error_of(good, {"fluid.rho"}).find("section.key=value"), std::string::npos);
  EXPECT_NE(error_of(good, {"title.x=1"}).find("'title' is no section"), std::string::npos);
}

TEST(Scene, ResolvedSceneReadsBackAsTheSame) {
  EXPECT_TRUE(rc::check("parse(resolved(scene)) == scene", [] {
    auto const positive = [] { return 1e-3 * *rc::gen::inRange(1, 1 << 30) / 3.0; };
    auto const ideal = *rc::gen::arbitrary<bool>();
    Scene scene;
    scene.title =
        *rc::gen::container<std::string>(rc::gen::inRange<char>(32, 127)); // quotes and backslashes too
    scene.fluid = {ideal ? "ideal-gas" : "argon", positive(), positive(), {}};
    if (ideal)
      scene.fluid.m0 = positive() * 1e-27;
    scene.particles = {*rc::gen::inRange(125, 1 << 20), 1 + positive(), ideal ? "lucy" : "cubic", 2.5};
    scene.transport.eta = positive();
    scene.transport.zeta = scene.transport.eta * *rc::gen::inRange(0, 166) / 100.0;
    scene.transport.kappa = positive();
    scene.run.bath_rate = positive();
    scene.scheme.dt = {positive() * (ideal ? 1 : 1e-15), ideal};
    scene.run.steps = *rc::gen::inRange(1, 1 << 30);
    scene.run.sample_every = 1;
    RC_ASSERT(parse_scene(resolved_toml(scene), "resolved.toml") == scene);
  }));
}

TEST(Scene, TheShippedScenesAreValid) {
  int ran = 0;
  for (auto const& entry : std::filesystem::directory_iterator(MESOBRIDGE_SOURCE_DIR "/workflows/scenes")) {
    if (entry.is_directory())
      continue; // the models that they name
    EXPECT_NO_THROW(load_scene(entry.path())) << entry.path();
    ++ran;
  }
  EXPECT_GE(ran, 2);
  EXPECT_THROW(load_scene("/no/such/scene.toml"), InputError);
}

TEST(Scene, TheKeysExplainThemselves) {
  auto const text = scene_keys_text();
  for (auto const* part : {"[fluid]", "*rho", "kg/m^3, g/cm^3", "default \"wendland-c4\"", "default \"auto\"",
                           "less than 5 eta / 3"})
    EXPECT_NE(text.find(part), std::string::npos) << part;
}

} // namespace

} // namespace mesobridge::workflows
