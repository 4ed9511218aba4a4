#include "workflows/reproduce/list.hpp"

namespace mesobridge::workflows {

// Each is made in a file of this folder; it is declared here and nowhere else.
using Reproduce = Reproduced(ReproduceOptions const&, Context const&);
Reproduce reproduce_chapter_3, reproduce_figure_4_2, reproduce_figure_4_3, reproduce_figure_4_4,
    reproduce_figure_4_5, reproduce_figure_4_6, reproduce_figure_4_7, reproduce_figure_4_8,
    reproduce_figure_4_9, reproduce_table_4_1, reproduce_table_4_2, reproduce_figure_4_10,
    reproduce_stability, reproduce_table_5_1, reproduce_table_5_2, reproduce_figure_5_5, reproduce_figure_5_6,
    reproduce_exact_solutions, reproduce_viscosity, reproduce_table_6_4, reproduce_table_6_5,
    reproduce_figure_6_2, reproduce_figure_6_10, reproduce_figure_6_13, reproduce_structure;

// clang-format off
std::vector<Reproduction> const& reproductions() {
  static std::vector<Reproduction> const list{
      {"chapter-3", "star polymers: key approximation, entropy, heat capacity (figures 3.2 ... 3.14)", reproduce_chapter_3},
      {"figure-4.2", "energy of SSA in time, K = 100", reproduce_figure_4_2},
      {"figure-4.3", "energy drift of SSA over the time step", reproduce_figure_4_3},
      {"figure-4.4", "energy drift of SER over the time step", reproduce_figure_4_4},
      {"figure-4.5", "distributions of internal energies, EMS and AMS", reproduce_figure_4_5},
      {"figure-4.6", "rejected steps, EMS and AMS", reproduce_figure_4_6},
      {"figure-4.7", "energy of EMS in time, K = 5", reproduce_figure_4_7},
      {"figure-4.8", "energy drift of EMS, AMS and SSA, K = 5", reproduce_figure_4_8},
      {"figure-4.9", "energy drift with multiple time steps", reproduce_figure_4_9},
      {"table-4.1", "time per particle and step of the schemes", reproduce_table_4_1},
      {"table-4.2", "a shock in an ideal gas by EMS and AMS; where SSA fails", reproduce_table_4_2},
      {"figure-4.10", "its density through the front", reproduce_figure_4_10},
      {"stability", "which schemes run where: time steps, sizes, extreme states", reproduce_stability},
      {"table-5.1", "pressure, density, temperatures over the particle size", reproduce_table_5_1},
      {"table-5.2", "a shock in argon over the particle size, three equations of state", reproduce_table_5_2, true},
      {"figure-5.5", "its density through the front, eta = 1e-4 Pa s", reproduce_figure_5_5, true},
      {"figure-5.6", "its density through the front, eta = 2e-3 Pa s", reproduce_figure_5_6, true},
      {"figure-6.2", "Hugoniot and Crussard curves of nitromethane, with the Chapman-Jouguet detonation", reproduce_figure_6_2},
      {"table-6.4", "the velocity of a detonation over the particle size (with figures 6.11, 6.12)", reproduce_table_6_4},
      {"table-6.5", "its reaction zone over the rate (with figure 6.14)", reproduce_table_6_5},
      {"figure-6.10", "from a shock to a detonation over the particle size (with figures 6.7, 6.9)", reproduce_figure_6_10},
      {"figure-6.13", "the same over the rate", reproduce_figure_6_13},
      {"exact-solutions", "shock tubes without noise against exact solutions, over the resolution", reproduce_exact_solutions},
      {"viscosity", "the viscosity that SDPD, DPD and DPDE have, beside the one asked for", reproduce_viscosity},
      {"structure", "kernels, neighbours and sizes of SDPD: which are a fluid, a glass, pairs or a crystal", reproduce_structure},
  };
  return list;
}
// clang-format on

} // namespace mesobridge::workflows
