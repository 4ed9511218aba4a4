#include "workflows/scene/box_checks.hpp"

namespace mesobridge::workflows {
namespace {

/// The box is as large as its particles need, or holds as many as fit.
void check_size(Scene const& scene, Places const& places) {
  auto const& box = scene.box;
  auto const N = scene.particles.N;
  if (box.size.empty())
    require_together(N > 0, places, "particles.N", N, "must be an integer >= 1, or give box.size");
  else
    require_together(N == 0 && box.lattice.empty(), places, N > 0 ? "particles.N" : "box.lattice",
                     N > 0 ? N : std::int64_t(box.lattice.size()),
                     "must not be given beside box.size, which says how many fit");
}

/// Walls with friction, and what drives a flow.
void check_flow(Scene const& scene, Places const& places) {
  auto const& box = scene.box;
  bool const walls = scene.features().walls, rough = box.slip == "none";
  require_together(!rough || walls, places, "box.slip", box.slip,
                   "needs walls: give box.x, box.y or box.z = \"walls\"");
  bool const has_friction =
      scene.features().densities
          ? scene.transport.eta > 0
          : scene.friction.file || scene.friction.gamma_par.value_or(0) > 0 || scene.friction.gamma_perp > 0;
  require_together(!rough || has_friction, places, "box.slip", box.slip,
                   "needs a fluid with friction, which is the walls' too");
  for (auto const& [key, value] : {std::pair("box.wall_temperature", box.wall_temperature),
                                   {"box.wall_friction", box.wall_friction},
                                   {"box.slide", box.slide}})
    if (value)
      require_together(rough, places, key, *value, "needs slip = \"none\"");
  bool const driven = box.slide || box.body_force;
  if (box.flow) {
    require_together(driven, places, "box.flow", *box.flow,
                     "needs box.slide or box.body_force, whose axis it is");
    auto const& across = *box.flow == "x" ? box.x : *box.flow == "y" ? box.y : box.z;
    require_together(across == "periodic", places, "box.flow", *box.flow,
                     fmt::format("must be an axis along which the box is periodic; it has {} there", across));
  }
  require_together(box.waves == 0 || (box.body_force && !walls), places, "box.waves", box.waves,
                   "must be 0 without box.body_force, and between walls");
  require_together(!scene.features().body_force || rough || !scene.features().energies ||
                       scene.scheme.energy == "kept",
                   places, "box.body_force", box.body_force.value_or(0),
                   "heats the fluid; walls with slip = \"none\" or energy = \"kept\" take the heat out");
}

} // namespace

void check_box(Scene const& scene, Places const& places) {
  check_size(scene, places);
  auto const& box = scene.box;
  if (!box.lattice.empty()) {
    require_together(box.lattice.size() == 3, places, "box.lattice", box.lattice.size(),
                     "numbers; must be 3: the particles along x, y and z");
    double particles = 1;
    for (auto const n : box.lattice)
      particles *= static_cast<double>(n);
    require_together(particles == static_cast<double>(scene.particles.N), places, "box.lattice", particles,
                     fmt::format("particles in all; must be particles.N = {}", scene.particles.N));
  }
  int walled = 0;
  for (auto const* face : {&box.x, &box.y, &box.z})
    walled += *face == "walls";
  if (walled > 1)
    throw InputError(
        fmt::format("{}: walls across {} axes: must be one, since particles in a corner would need the "
                    "images of images",
                    places.of("box.z"), walled));
  if (box.piston)
    require_together(walled == 1, places, "box.piston", *box.piston,
                     "needs a wall to move: give box.x, box.y or box.z = \"walls\"");
  if (box.ramp)
    require_together(box.piston.has_value(), places, "box.ramp", *box.ramp,
                     "needs box.piston, whose start it is");
  check_flow(scene, places);
}

} // namespace mesobridge::workflows
