#pragma once
#include "sdpd/lammps/decomposed_fluid.hpp"
#include <string>
#include <vector>

namespace LAMMPS_NS {
class LAMMPS;
class Pair;
class Fix;
} // namespace LAMMPS_NS

namespace mesobridge::sdpd {

/// The pair style and the fix of a fluid, whoever registers them: LammpsStyles in this process, or a plugin
/// in a LAMMPS that runs by an input of its own.
inline constexpr char const* fluid_style = "mesobridge";

/// What the words behind `pair_style mesobridge` mean where no program has given the style its fluid.
using FluidReader = SimulationSettings (*)(std::vector<std::string> const& words);
void set_fluid_reader(FluidReader reader);
/// Throws InputError also where there is no reader.
SimulationSettings read_fluid(std::vector<std::string> const& words);

/// As LAMMPS makes styles, and deletes them.
LAMMPS_NS::Pair* make_fluid_pair(LAMMPS_NS::LAMMPS* lammps);
LAMMPS_NS::Fix* make_fluid_fix(LAMMPS_NS::LAMMPS* lammps, int count, char** words);

/// Gives both styles, which must be there, their fluid.
void give_fluid(LAMMPS_NS::LAMMPS& lammps, DecomposedFluid& fluid);

RankParticles particles_of(LAMMPS_NS::LAMMPS const& lammps);

/// The commands that a fluid wants of LAMMPS: `before` the box is there, and `after` it.
struct FluidCommands {
  std::vector<std::string> before, after;
};
FluidCommands fluid_commands(DecomposedFluid const& fluid);

/// The names of the numbers of each atom by which an input gives its energies and temperatures (fix
/// property/atom d_...).
inline constexpr char const *given_eps = "mesobridge_eps", *given_T = "mesobridge_T";

} // namespace mesobridge::sdpd
