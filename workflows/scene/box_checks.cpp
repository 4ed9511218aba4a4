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
  if (box.slide_ramp)
    require_together(box.slide.has_value(), places, "box.slide_ramp", *box.slide_ramp,
                     "needs box.slide, whose start it is");
  bool const bath = box.wall_heat == "bath";
  require_together(bath || rough, places, "box.wall_heat", box.wall_heat, "needs slip = \"none\"");
  require_together(bath || scene.features().energies, places, "box.wall_heat", box.wall_heat,
                   "particles without internal energies have no other place for the heat of friction");
  require_together(bath || !box.wall_temperature, places, "box.wall_temperature",
                   box.wall_temperature.value_or(0), "has no meaning beside wall_heat = \"none\"");
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
  require_together(
      !scene.features().body_force || (rough && bath) || !scene.features().energies ||
          scene.scheme.energy == "kept",
      places, "box.body_force", box.body_force.value_or(0),
      "heats the fluid; walls with slip = \"none\" and a bath or energy = \"kept\" take the heat out");
}

int walled_axes(Scene::Box const& box) {
  return (box.x == "walls") + (box.y == "walls") + (box.z == "walls");
}

/// Which walls move, where there are several pairs of them.
void check_moving(Scene const& scene, Places const& places) {
  auto const& box = scene.box;
  int const walled = walled_axes(box);
  bool const moves = box.piston || box.piston_file || !box.piston_times.empty() || box.slide;
  if (box.moving) {
    require_together(moves, places, "box.moving", *box.moving, "needs a piston or box.slide");
    auto const& across = *box.moving == "x" ? box.x : *box.moving == "y" ? box.y : box.z;
    require_together(across == "walls", places, "box.moving", *box.moving,
                     fmt::format("must be an axis with walls; it has {} there", across));
  }
  require_together(!moves || walled <= 1 || box.moving, places, "box.moving", "not given",
                   "must be the axis whose walls move, since there are several with walls");
  bool const along = box.x == "periodic" || box.y == "periodic" || box.z == "periodic";
  require_together(
      along || !(box.slide || box.body_force), places, box.slide ? "box.slide" : "box.body_force",
      box.slide ? *box.slide : box.body_force.value_or(0), "needs an axis along which the box is periodic");
}

/// A piston's motion: a velocity with its ramp, or one table.
void check_piston(Scene const& scene, Places const& places) {
  auto const& box = scene.box;
  auto const &times = box.piston_times, &velocities = box.piston_velocities;
  bool const inline_table = !times.empty() || !velocities.empty();
  bool const walls = walled_axes(box) > 0;
  auto const needed = "needs a wall to move: give box.x, box.y or box.z = \"walls\"";
  require_together(walls || !box.piston, places, "box.piston", box.piston.value_or(0), needed);
  require_together(walls || !inline_table, places, "box.piston_times", times.size(), needed);
  require_together(walls || !box.piston_file, places, "box.piston_file", box.piston_file.value_or(""),
                   needed);
  if (box.ramp)
    require_together(box.piston.has_value(), places, "box.ramp", *box.ramp,
                     "needs box.piston, whose start it is");
  require_together(!(inline_table && box.piston), places, "box.piston", box.piston.value_or(0),
                   "must not be given beside box.piston_times");
  require_together(!box.piston_file || (!inline_table && !box.piston), places, "box.piston_file",
                   box.piston_file.value_or(""), "must not be given beside box.piston or box.piston_times");
  require_together(times.size() == velocities.size(), places, "box.piston_velocities", velocities.size(),
                   fmt::format("numbers; must be as many as box.piston_times has, {}", times.size()));
  for (std::size_t k = 0; k < times.size(); ++k)
    require_together(k > 0 ? times[k] > times[k - 1] : times[k] == 0, places, "box.piston_times", times[k],
                     "must begin with 0 and rise");
}

} // namespace

void resolve_piston_file(Scene& scene, std::filesystem::path const& folder, Places const& places) {
  auto& file = scene.box.piston_file;
  if (!file)
    return;
  auto const path = std::filesystem::absolute(folder / *file).lexically_normal();
  require_together(std::filesystem::is_regular_file(path), places, "box.piston_file", *file,
                   fmt::format("there is no file '{}'", path.string()));
  file = path.string();
}

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
  check_piston(scene, places);
  check_moving(scene, places);
  check_flow(scene, places);
}

} // namespace mesobridge::workflows
