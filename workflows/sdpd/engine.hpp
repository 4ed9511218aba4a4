#pragma once
#include <string>

namespace mesobridge::workflows {

/// Who advances the particles: the engine of this program, or the same physics inside LAMMPS on MPI ranks.
enum class Engine { built_in, lammps };

/// "lammps", or anything else for the built-in one.
inline Engine engine_named(std::string const& name) {
  return name == "lammps" ? Engine::lammps : Engine::built_in;
}

} // namespace mesobridge::workflows
