#include "workflows/scene/keys/line.hpp"
#include "workflows/scene/keys/tables.hpp"

namespace mesobridge::workflows {

std::vector<SceneKey> run_keys() {
  return {
      Line(
          "run", "equilibrate", [](Scene& s) { return &s.run.equilibrate; }, "steps before the first sample")
          .in(not_negative),
      Line(
          "run", "thermostat", [](Scene& s) { return &s.run.thermostat; },
          "of the equilibration: momenta and heat set now and then (rescale), or a Langevin bath for the "
          "first "
          "half of its steps (langevin)")
          .choices({"rescale", "langevin"}),
      Line(
          "run", "bath_rate", [](Scene& s) { return &s.run.bath_rate; },
          "rate at which the Langevin bath takes hold, per reduced time unit of size K")
          .in(positive),
      Line(
          "run", "steps", [](Scene& s) { return &s.run.steps; }, "steps that are sampled")
          .required()
          .in(at_least_one),
      Line(
          "run", "sample_every", [](Scene& s) { return &s.run.sample_every; }, "steps between samples")
          .in(at_least_one),
      Line(
          "run", "instant_every", [](Scene& s) { return &s.run.instant_every; },
          "steps between the instants whose particles' energies, densities and pressures make the "
          "distributions; "
          "0: 40 instants")
          .in(not_negative),
      Line(
          "run", "trajectory_every", [](Scene& s) { return &s.run.trajectory_every; },
          "steps between frames of trajectory.h5 (H5MD, for MDAnalysis and VMD); 0: none")
          .in(not_negative),
      Line(
          "run", "vtkhdf_every", [](Scene& s) { return &s.run.vtkhdf_every; },
          "steps between frames of trajectory.vtkhdf (for ParaView 5.12 and later); 0: none")
          .in(not_negative),
      Line(
          "run", "xyz_every", [](Scene& s) { return &s.run.xyz_every; },
          "steps between frames of trajectory.xyz (extended XYZ, for OVITO and ASE); 0: none")
          .in(not_negative),
      Line(
          "run", "checkpoint_every", [](Scene& s) { return &s.run.checkpoint_every; },
          "steps between checkpoints, also of the equilibration; 0: none by steps")
          .in(not_negative),
      Line(
          "run", "checkpoint_minutes", [](Scene& s) { return &s.run.checkpoint_minutes; },
          "minutes after which there is a checkpoint in any case; 0: only by steps, when interrupted and at "
          "the end")
          .in(not_negative),
      Line(
          "run", "seed", [](Scene& s) { return &s.run.seed; }, "seed of all random numbers")
          .in(not_negative),
  };
}

std::vector<SceneKey> output_keys() {
  return {
      Line(
          "output", "directory", [](Scene& s) { return &s.output.directory; },
          "where to write if -o is not given; default out/ and the scene's name"),
  };
}

} // namespace mesobridge::workflows
