#pragma once
#include "md/lj_fluid.hpp"
#include <span>

namespace mesobridge::md {

/// A region of states of the fluid, in Lennard-Jones units.
struct LjRegion {
  double rho_min, rho_max;
  double T_min, T_max;
};

/// The default region: the supercritical states that argon visits in SDPD at 1000 K and 1150 kg/m^3 (T*
/// = 8.33, rho* = 0.684) and in a shock of 500 m/s from 500 K (T* = 4.17 and 0.684, behind it 8.07 and
/// 0.915). A particle of K = 10 atoms fluctuates by about (K c_v/k_B)^-1/2 = 0.2 of its temperature and 0.1
/// of its density, and a fit is only good between its data, so the region reaches three such deviations from
/// the equilibrium state and two from the others. Its dense cold corner stays below the freezing density
/// (about 1.1 at T* = 2.75), so that all of it is one phase.
inline constexpr LjRegion default_lj_region{.rho_min = 0.45, .rho_max = 1.05, .T_min = 2.75, .T_max = 14.0};

/// States on a grid: densities at equal distances, temperatures in equal ratios (the equation of state bends
/// most where it is cold). Throws InputError for an empty region or less than 2 points along an edge.
std::vector<LjState> lj_grid(LjRegion region, int densities, int temperatures);

/// The default region with 5 x 5, 8 x 8 or 12 x 12 states.
std::vector<LjState> default_lj_grid(Preset preset);

/// Who watches a grid of runs, on rank 0; each may be absent.
struct LjGridConsumers {
  /// New samples of one state, in their order; false stops all runs at once.
  std::function<bool(std::size_t state_index, std::span<ThermoSample const>)> samples;
  /// Called often from the start on with the part of all work that is done, 0 ... 1; false stops all runs at
  /// once.
  std::function<bool(double fraction)> progress;
};

/// Samples every state once, each on one rank; the ranks share the states, the longest run first. All ranks
/// call it with the same arguments; the consumers of rank 0 are called, while the runs go on. The seed of a
/// state depends on (settings.seed, its index) only, so the samples are the same bit for bit on any number of
/// ranks. Rank r > 0 writes LAMMPS's log to a file of its own: `<stem>-<r><extension>`. Returns (on rank 0)
/// whether all states are complete, false when a consumer stopped the runs. Throws as sample_lj_fluid; bad
/// input before any run begins. An exception on one rank alone must be ended by MpiWorld::abort.
bool sample_lj_grid(MpiWorld const& world, std::span<LjState const> states, LjFluidSettings const& settings,
                    LjGridConsumers const& consumers);

/// Which rank runs which states, by index: each state in turn, the costliest first, to the rank with the
/// least work. A state's cost is that of its pairs, proportional to its density.
std::vector<std::vector<std::size_t>> share_states(std::span<LjState const> states, int ranks);

} // namespace mesobridge::md
