#include "workflows/scene/keys/line.hpp"
#include "workflows/scene/keys/tables.hpp"

namespace mesobridge::workflows {
namespace {

bool is_not_plain(Scene const& scene) {
  return scene.box != Scene::Box{};
}

} // namespace

std::vector<SceneKey> box_keys() {
  Table const box{"box", &Scene::box};
  auto const face = [&](char axis, std::string Scene::Box::*member) {
    return box(std::string(1, axis), member,
               fmt::format(
                   "its faces across {}: periodic; walls, which mirror the fluid and slip; or open to vacuum",
                   axis))
        .choices({"periodic", "walls", "open"})
        .written_if(is_not_plain);
  };
  return {
      box("lattice", &Scene::Box::lattice,
          "particles along x, y and z at the start, N in all; if not given, as cubic as N allows")
          .in({.min = 1, .max = 4e9})
          .written_if(is_not_plain),
      box("size", &Scene::Box::size, "its edges along x, y and z, in place of particles.N: as many as fit")
          .quantity(Dimension::length, positive)
          .written_if(is_not_plain),
      face('x', &Scene::Box::x),
      face('y', &Scene::Box::y),
      face('z', &Scene::Box::z),
      box("piston", &Scene::Box::piston,
          "velocity of the lower wall, into the fluid, after the equilibration")
          .quantity(Dimension::velocity, any_number)
          .written_if(is_not_plain),
      box("ramp", &Scene::Box::ramp,
          "time in which the piston comes to its velocity, or it overheats the fluid before it for ever; too "
          "long, and "
          "there is no shock at first. Best are some 8 mean distances between particles over the velocity of "
          "the shock, "
          "which is the default for sdpd; 0 for dpde and dpd")
          .quantity(Dimension::time, not_negative)
          .written_if(is_not_plain),
  };
}

} // namespace mesobridge::workflows
