#pragma once
#include "workflows/sdpd/run_scene.hpp"

namespace CLI {
class App;
}

namespace mesobridge::workflows {

/// --engine: built-in or lammps.
void add_engine(CLI::App& app, std::string& engine);

/// Runs a scene by LAMMPS on MPI ranks. The first rank does `run` with the engine, and its result is told;
/// the others take part in its steps. Where no rank runs yet, this program is started again on --ranks of
/// them. Throws EnvironmentError when a rank was ended from outside.
Result run_on_lammps(Scene const& scene, std::filesystem::path const& directory, Context const& context,
                     std::function<Result(OtherEngine const&)> const& run);

} // namespace mesobridge::workflows
