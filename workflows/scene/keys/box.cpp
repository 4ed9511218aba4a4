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
               fmt::format("its faces across {}: periodic; walls, which mirror the fluid; or open to vacuum",
                           axis))
        .choices({"periodic", "walls", "open"});
  };
  std::vector<SceneKey> keys{
      box("lattice", &Scene::Box::lattice,
          "particles along x, y and z at the start, N in all; if not given, as cubic as N allows")
          .in({.min = 1, .max = 4e9}),
      box("size", &Scene::Box::size, "its edges along x, y and z, in place of particles.N: as many as fit")
          .quantity(Dimension::length, positive),
      face('x', &Scene::Box::x),
      face('y', &Scene::Box::y),
      face('z', &Scene::Box::z),
      box("piston", &Scene::Box::piston,
          "velocity of the lower wall, into the fluid, after the equilibration; see also piston_times")
          .quantity(Dimension::velocity, any_number),
      box("ramp", &Scene::Box::ramp,
          "time in which the piston comes to its velocity, or it overheats the fluid before it for ever; too "
          "long, and there is no shock at first. Best are some 8 mean distances between particles over the "
          "velocity of the shock, which is the default for sdpd; 0 for dpde and dpd")
          .quantity(Dimension::time, not_negative),
      box("piston_times", &Scene::Box::piston_times,
          "a table in place of piston and ramp: from 0 on, rising, counted from the end of the equilibration")
          .quantity(Dimension::time, not_negative)
          .of_any_length(),
      box("piston_velocities", &Scene::Box::piston_velocities,
          "of the lower wall at each of those times; linear between them, and the last one is kept")
          .quantity(Dimension::velocity, any_number)
          .of_any_length(),
      box("piston_file", &Scene::Box::piston_file,
          "the same table as CSV with the columns t_s, v_m_s (lj units: t, v)"),
      box("moving", &Scene::Box::moving,
          "the axis whose walls move, by piston or slide; needed where walls are across several axes")
          .choices({"x", "y", "z"}),
      box("slip", &Scene::Box::slip,
          "\"none\": walls with the friction of the fluid, and the noise of their temperature; \"free\": "
          "mirrors alone, which take no heat")
          .choices({"free", "none"}),
      box("wall_temperature", &Scene::Box::wall_temperature,
          "of walls with slip = \"none\"; that of the fluid, if not given")
          .quantity(Dimension::temperature, positive),
      box("wall_heat", &Scene::Box::wall_heat,
          "of walls with slip = \"none\". \"bath\": heat goes to and comes from walls at their temperature; "
          "\"none\": the walls are adiabatic, the heat of friction stays in the fluid (sdpd, dpde)")
          .choices({"bath", "none"}),
      box("wall_friction", &Scene::Box::wall_friction,
          "factor of the friction with walls of slip = \"none\"; if not given, one that makes up for what "
          "moving particles carry: 1 for viscous fluids, more where they fly far")
          .in(positive),
      box("slide", &Scene::Box::slide,
          "velocity of the upper wall along the flow, with slip = \"none\", after the equilibration: "
          "Couette's flow")
          .quantity(Dimension::velocity, any_number),
      box("slide_ramp", &Scene::Box::slide_ramp,
          "time in which the sliding wall comes to its velocity; at once, if not given")
          .quantity(Dimension::time, not_negative),
      box("body_force", &Scene::Box::body_force,
          "acceleration of all particles along the flow, after the equilibration: between walls Poiseuille's "
          "flow. Without walls to take the heat, sdpd and dpde need energy = \"kept\", which does")
          .quantity(Dimension::acceleration, any_number),
      box("waves", &Scene::Box::waves,
          "of the body force, which goes as a cosine along z (along x if the flow is along z), in the length "
          "of a periodic box; 0: it is the same everywhere")
          .in({.min = 0, .max = 100}),
      box("flow", &Scene::Box::flow,
          "the axis of slide and body_force, along which the box is periodic; the first such one, if not "
          "given")
          .choices({"x", "y", "z"}),
  };
  for (auto& key : keys)
    key.written = is_not_plain;
  return keys;
}

} // namespace mesobridge::workflows
