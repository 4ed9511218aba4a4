#include "md/error.hpp"
#include "scene_error.hpp"
#include "workflows/scene/keys.hpp"
#include "workflows/scene/scene.hpp"
#include "workflows/sdpd/layout_of.hpp"
#include "workflows/sdpd/riemann_problem.hpp"
#include "workflows/sdpd/run_health.hpp"
#include "workflows/sdpd/settings.hpp"
#include <gtest/gtest.h>
#include <numbers>

namespace mesobridge::workflows {
namespace {

using tests::error_of, tests::replaced;

/// Three regions in a box of argon.
std::string const good = R"(title = "Three regions"
[fluid]
eos = "argon"
rho = "1150 kg/m^3"
T = "500 K"
[particles]
K = 100
[box]
size = ["20 nm", "20 nm", "60 nm"]
z = "walls"
[transport]
eta = "2 mPa*s"
[scheme]
dt = 0.02
[run]
steps = 100
[[region]]
name = "flyer"
shape = "slab"
from = "50 %"
rho = "1300 kg/m^3"
velocity = ["0 m/s", "0 m/s", "-300 m/s"]
[[region]]
shape = "sphere"
centre = ["10 nm", "10 nm", "45 nm"]
radius = "5 nm"
fill = "vacuum"
[[region]]
shape = "cylinder"
axis = "x"
radius = "4 nm"
eos = "ideal-gas"
K = 50
lattice = "fcc"
)";

std::string const with_m0 = replaced(good, "T = \"500 K\"", "T = \"500 K\"\nm0 = \"1e-25 kg\"");

TEST(RegionScene, ReadsEveryKindOfRegion) {
  auto const scene = parse_scene(with_m0, "good.toml");
  ASSERT_EQ(scene.regions.size(), 3u);
  EXPECT_EQ(scene.regions[0].from, (std::vector<Coordinate>{{50, true}}));
  EXPECT_EQ(scene.regions[0].velocity, (std::vector<double>{0, 0, -300}));
  EXPECT_DOUBLE_EQ(scene.regions[1].centre[2].value, 45e-9);
  EXPECT_FALSE(scene.regions[1].centre[2].is_share);
  EXPECT_EQ(scene.regions[2].lattice, "fcc");
  auto const settings = settings_of(scene, 1);
  auto const& layout = *settings.layout;
  ASSERT_EQ(layout.regions().size(), 4u); // the fluid first
  EXPECT_EQ(layout.regions()[2].vacuum, true);
  EXPECT_EQ(layout.particles()[2], 0u);
  EXPECT_EQ(settings.as<sdpd::Sdpd>().species.size(), 2u);
  double const mass = 100 * 6.64e-26;                                            // of a particle of argon
  double const volume = (20 * 20 * 30 - std::numbers::pi * 16 / 2 * 20) * 1e-27; // half a cylinder is missing
  EXPECT_NEAR(static_cast<double>(layout.particles()[0]) * mass / volume / 1150, 1, 0.02);
  EXPECT_EQ(particles_of(scene), static_cast<std::int64_t>(layout.size()));
}

TEST(RegionScene, ReadsBackAsTheSame) {
  auto const scene = parse_scene(with_m0, "good.toml");
  EXPECT_TRUE(parse_scene(resolved_toml(scene), "resolved.toml") == scene);
}

TEST(RegionScene, TakesOverridesByTheNumberOfTheRegion) {
  auto const scene =
      parse_scene(with_m0, "good.toml", {"region.1.rho=1.2 g/cm^3", "region.2.radius=\"3 nm\""});
  EXPECT_EQ(scene.regions[0].rho, 1200);
  EXPECT_DOUBLE_EQ(scene.regions[1].radius.value(), 3e-9);
  for (std::string const path : {"region.0.rho", "region.4.rho", "region.rho", "region.x.rho", "region.1"})
    EXPECT_NE(error_of(with_m0, {path + "=1 g/cm^3"}).find("--set"), std::string::npos) << path;
}

TEST(RegionScene, BadRegionsAreNamed) {
  struct Case {
    std::string what, by;
    std::vector<std::string> parts;
  };
  std::vector<Case> const cases{
      {"shape = \"slab\"", "shape = \"slap\"", {"bad.toml", "region.1.shape", "did you mean 'slab'"}},
      {"shape = \"slab\"", "", {"region.1.shape", "is missing"}},
      {"rho = \"1300 kg/m^3\"", "rhp = 1", {"region.1.rhp", "did you mean 'rho'"}},
      {"rho = \"1300 kg/m^3\"", "rho = \"-1 kg/m^3\"", {"region.1.rho", "> 0"}},
      {"from = \"50 %\"", "from = \"50 percent\"", {"region.1.from", "wrong unit"}},
      {"from = \"50 %\"", "from = \"nan %\"", {"region.1.from", "50 %"}},
      {"from = \"50 %\"", "from = \"50 %\"\nto = \"40 %\"", {"region.1.to", "must be >"}},
      {"from = \"50 %\"", "from = [\"1 nm\", \"2 nm\"]", {"region.1.from", "three"}},
      {"from = \"50 %\"", "from = [\"1 nm\", \"2 nm\", \"3 nm\"]", {"region.1.from", "must be 1 for a slab"}},
      {"from = \"50 %\"", "from = \"120 %\"", {"region.1.to", "must be >"}},
      {"from = \"50 %\"", "from = \"50 %\"\nradius = \"1 nm\"", {"region.1.radius", "a slab has none"}},
      {"\"-300 m/s\"]", "]", {"region.1.velocity", "three"}},
      {"radius = \"5 nm\"", "", {"region.2.radius", "must be given"}},
      {"fill = \"vacuum\"", "fill = \"vacuum\"\nT = \"3 K\"", {"region.2.T", "vacuum"}},
      {"fill = \"vacuum\"", "from = \"1 nm\"", {"region.2.from", "a sphere has none"}},
      {"eos = \"ideal-gas\"", "eos = \"argom\"", {"region.3.eos", "did you mean 'argon'"}},
      {"eos = \"ideal-gas\"", "eos = \"lj\"", {"region.3.eos", "units"}},
      {"rho = \"1300 kg/m^3\"",
       "eos = \"water\"\nrho = \"1600 kg/m^3\"",
       {"region.1.rho = 1600", "stiffened gas", "1487"}},
      {"K = 50", "K = 0.1", {"region.3.K", ">= 1"}},
      {"K = 50", "mass = \"1 kg\"", {"region.3.mass", "belongs to method.name"}},
      {"[[region]]\nname", "[region]\nname", {"region"}},
      {"steps = 100", "steps = 100\nequilibrate = 10", {"run.equilibrate = 10", "must be 0"}},
      {"K = 100", "K = 100\nN = 1000", {"particles.N = 1000", "box.size"}},
      {"size = [\"20 nm\", \"20 nm\", \"60 nm\"]", "", {"particles.N", "box.size"}},
      {"size = [\"20 nm\", \"20 nm\", \"60 nm\"]", "size = [\"20 nm\", \"20 nm\"]", {"box.size", "three"}},
  };
  for (auto const& [what, by, parts] : cases) {
    std::string message;
    try {
      settings_of(parse_scene(replaced(with_m0, what, by), "bad.toml"), 1);
    } catch (InputError const& error) {
      message = error.what();
    }
    for (auto const& part : parts)
      EXPECT_NE(message.find(part), std::string::npos) << by << ": looked for " << part << " in: " << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  }
}

// A lattice that does not fit is told: 20 nm hold 11 or 12 particles of argon, not 11.15.
TEST(RegionScene, SaysByHowMuchALatticeMissesItsDensity) {
  auto const scene = parse_scene(with_m0, "good.toml",
                                 {"box.size=[\"20 nm\", \"20 nm\", \"21 nm\"]", "region.2.radius=1 nm",
                                  "region.2.centre=[\"50 %\",\"50 %\",\"50 %\"]"});
  auto const doubts = doubts_about(scene, settings_of(scene, 1));
  EXPECT_TRUE(std::ranges::any_of(doubts, [](auto const& of) { return of.name == "region"; }));
}

TEST(RegionScene, OfTwoSlabsIsARiemannProblem) {
  std::string tube = good.substr(0, good.find("[[region]]\nshape = \"sphere\""));
  auto const scene = parse_scene(tube + "[profile]\naxis = \"z\"\n", "tube.toml");
  auto const problem = riemann_problem(scene, settings_of(scene, 1));
  ASSERT_TRUE(problem);
  EXPECT_NEAR(problem->membrane, 30e-9, 1e-20);
  EXPECT_EQ(problem->at(1e-9, 0).u, 0);
  EXPECT_EQ(problem->at(59e-9, 0).u, -300);
  EXPECT_NEAR(problem->at(59e-9, 0).state.rho, 1300, 1e-9);
  EXPECT_TRUE(problem->exact.left_shock());
  EXPECT_FALSE(
      riemann_problem(parse_scene(with_m0, "good.toml"), settings_of(parse_scene(with_m0, "good.toml"), 1)));
}

} // namespace
} // namespace mesobridge::workflows
