#include "workflows/scene/keys/line.hpp"
#include "workflows/scene/keys/tables.hpp"

namespace mesobridge::workflows {

std::vector<SceneKey> run_keys() {
  Table const run{"run", &Scene::run};
  return {
      run("equilibrate", &Scene::Run::equilibrate, "steps before the first sample").in(not_negative),
      run("thermostat", &Scene::Run::thermostat,
          "of the equilibration: momenta and heat set now and then (rescale), or a Langevin bath for the "
          "first "
          "half of its steps (langevin)")
          .choices({"rescale", "langevin"}),
      run("bath_rate", &Scene::Run::bath_rate,
          "rate at which the Langevin bath takes hold, per reduced time unit of size K")
          .in(positive),
      run("steps", &Scene::Run::steps, "steps that are sampled").required().in(at_least_one),
      run("sample_every", &Scene::Run::sample_every, "steps between samples").in(at_least_one),
      run("instant_every", &Scene::Run::instant_every,
          "steps between the instants whose particles' energies, densities and pressures make the "
          "distributions; "
          "0: 40 instants")
          .in(not_negative),
      run("trajectory_every", &Scene::Run::trajectory_every,
          "steps between frames of trajectory.h5md (H5MD, for MDAnalysis and VMD); 0: none")
          .in(not_negative),
      run("vtkhdf_every", &Scene::Run::vtkhdf_every,
          "steps between frames of trajectory.vtkhdf (for ParaView; for its version 5.11 open "
          "trajectory.hdf.series); "
          "0: none")
          .in(not_negative),
      run("xyz_every", &Scene::Run::xyz_every,
          "steps between frames of trajectory.xyz (extended XYZ, for OVITO and ASE); 0: none")
          .in(not_negative),
      run("checkpoint_every", &Scene::Run::checkpoint_every,
          "steps between checkpoints, also of the equilibration; 0: none by steps")
          .in(not_negative),
      run("checkpoint_minutes", &Scene::Run::checkpoint_minutes,
          "minutes after which there is a checkpoint in any case; 0: only by steps, when interrupted and at "
          "the end")
          .in(not_negative),
      run("seed", &Scene::Run::seed, "seed of all random numbers").in(not_negative),
  };
}

std::vector<SceneKey> output_keys() {
  Table const output{"output", &Scene::output};
  return {
      output("directory", &Scene::Output::directory,
             "where to write if -o is not given; default out/ and the scene's name"),
  };
}

} // namespace mesobridge::workflows
