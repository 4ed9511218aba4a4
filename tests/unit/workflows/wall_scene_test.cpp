#include "scene_error.hpp"
#include "workflows/sdpd/disk_estimate.hpp"
#include "workflows/sdpd/resumption.hpp"
#include "workflows/sdpd/settings.hpp"
#include <gtest/gtest.h>

namespace mesobridge::workflows {
namespace {

using tests::error_of;

std::string const gas = R"(title = "a DPD gas"
units = "lj"
[method]
name = "dpd"
[fluid]
rho = 3
T = 1
[particles]
N = 1000
mass = 1
[box]
lattice = [5, 10, 20]
body_force = 0.1
[friction]
gamma_par = 4.5
cutoff = 1
[scheme]
dt = 0.02
[run]
steps = 200
)";

TEST(WallScene, FlowsAlongTheFirstAxisAlongWhichTheBoxIsPeriodic) {
  struct Case {
    std::string x, y, z;
    int along;
  };
  for (auto const& [x, y, z, along] : {Case{"periodic", "periodic", "periodic", 0},
                                       {"walls", "periodic", "periodic", 1},
                                       {"walls", "walls", "periodic", 2},
                                       {"walls", "open", "periodic", 2},
                                       {"open", "periodic", "walls", 1}}) {
    auto const scene = parse_scene(gas, "gas.toml", {"box.x=" + x, "box.y=" + y, "box.z=" + z});
    EXPECT_EQ(flow_axes(scene).along, along) << x << " " << y << " " << z;
  }
  EXPECT_NE(error_of(gas, {"box.x=walls", "box.y=open", "box.z=walls"}).find("needs an axis along which"),
            std::string::npos);
}

TEST(FilmScene, GoesOnWithTheIntervalThatItBeganWith) {
  std::vector<std::string> const film{"film.quantity=velocity_x"};
  auto const begun = parse_scene(gas, "gas.toml", film);
  auto longer = film;
  longer.push_back("run.steps=1000");
  EXPECT_EQ(film_every(begun), 40);
  EXPECT_EQ(film_every(parse_scene(gas, "gas.toml", longer)), 200);
  auto const resumed = [&](std::vector<std::string> const& overrides, Scene const& before) {
    return film_every(
        resumed_scene(parse_scene(gas, "gas.toml", overrides), resolved_toml(before), {}, "run"));
  };
  EXPECT_EQ(resumed(longer, begun), 40);
  EXPECT_EQ(resumed(longer, parse_scene(gas, "gas.toml")), 200); // it had none
  longer.push_back("film.every=25");
  EXPECT_EQ(resumed(longer, begun), 25);
}

// Three numbers a point and frame: of 1000 particles a fifth along the shortest edge, all of them in the
// direction and thickness that the second says.
TEST(FilmScene, NeedsTheRoomOfTheParticlesInItsSlab) {
  auto const without = estimate_disk(parse_scene(gas, "gas.toml")).results;
  auto const room = [&](std::vector<std::string> overrides) {
    overrides.insert(overrides.end(), {"film.quantity=velocity_x", "film.every=1"});
    return (estimate_disk(parse_scene(gas, "gas.toml", overrides)).results - without) / (3 * 8 * 201);
  };
  EXPECT_NEAR(room({}), 200, 60); // files grow by chunks of 64 kB
  EXPECT_NEAR(room({"film.axis=z", "film.thickness=100"}), 1000, 80);
}

} // namespace
} // namespace mesobridge::workflows
