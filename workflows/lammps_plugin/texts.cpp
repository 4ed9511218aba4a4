#include "workflows/lammps_plugin/texts.hpp"
#include <fmt/format.h>

namespace mesobridge::workflows {

std::string batch_script() {
  return R"(#!/bin/sh
#SBATCH --job-name=fluid
#SBATCH --nodes=4
#SBATCH --ntasks-per-node=32
#SBATCH --time=24:00:00
# The plugin and the lmp that it was built for, by the same MPI:
export LD_LIBRARY_PATH="$HOME/mesobridge-plugin:$LD_LIBRARY_PATH"
srun lmp -in in.fluid
)";
}

std::string plugin_page(Scene const& scene, sdpd::ReducedUnits const& units) {
  bool const si = scene.units == UnitSystem::SI;
  auto const in = [&](double value, char const* unit) {
    return si ? fmt::format("{:.9g} {}", value, unit) : fmt::format("{:.9g}", value);
  };
  return fmt::format(R"(# {title}, in a LAMMPS of your own

`in.fluid` goes on from the checkpoint of a run. It wants a LAMMPS with the package PLUGIN, and the plugin, a library that is
built from the sources of mesobridge against those of that LAMMPS, by the same compiler and MPI:

    cmake -S mesobridge -B mesobridge-plugin -DMESOBRIDGE_TESTS=OFF -DMESOBRIDGE_LAMMPS_SOURCE=/path/to/lammps/src
    cmake --build mesobridge-plugin --target mesobridgeplugin
    LD_LIBRARY_PATH=mesobridge-plugin mpirun -np 4 lmp -in in.fluid

(`-DMESOBRIDGE_NATIVE=OFF` where the machine that builds is of another kind than those that run.) LAMMPS itself: `cmake -S cmake -B build
-DPKG_PLUGIN=ON -DBUILD_SHARED_LIBS=ON`, with 32-bit atom numbers, as is usual. `batch.sh` is a script for Slurm.

| file | what it holds |
|---|---|
| `fluid.toml` | the fluid: `pair_style mesobridge fluid.toml` reads method, laws, scheme, time step and seed from it; box and particles come from the data file |
| `particles.data` | positions and momenta; under `Energies` each particle's internal energy and temperature, for `fix property/atom` |
| `in.fluid` | the input; what stands before `pair_style` must stay as it is, the rest is yours |

`fix ID all mesobridge` moves the particles. Its scalar is the sum of their internal energies, its columns are each one's energy and
temperature; LAMMPS's restart files hold both, and so go on with the same `pair_style` and `fix`. Box, timestep and masses must be
those of the fluid's scene; `pe` and `press` are not told: they are nan. Noise is a function of the seed, the step and the two ids: keep `reset_timestep`.

All numbers are reduced; one unit is

| | |
|---|---|
| mass | {mass} |
| length | {length} |
| time | {time} |
| energy | {energy} |
| temperature | {temperature} |

LAMMPS's `temp` takes k_B for one, here it is 1/{K:g}: `v_T` is the temperature in {kelvin}.
)",
                     fmt::arg("title", scene.title), fmt::arg("mass", in(units.mass(), "kg")),
                     fmt::arg("length", in(units.length(), "m")), fmt::arg("time", in(units.time(), "s")),
                     fmt::arg("energy", in(units.energy(), "J")),
                     fmt::arg("temperature", in(units.temperature, "K")), fmt::arg("K", units.K),
                     fmt::arg("kelvin", si ? "K" : "the scene's units"));
}

} // namespace mesobridge::workflows
