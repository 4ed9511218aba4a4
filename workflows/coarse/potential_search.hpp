#pragma once
#include "cg/inverse_boltzmann.hpp"
#include <cstdint>
#include <functional>
#include <optional>

namespace mesobridge::workflows {

/// The structure that coarse particles are to have, in any units with k_B = 1.
struct CoarseStructure {
  double density = 0, mass = 0, kT = 0; ///< particles per volume; of one; all > 0
  cg::RadialBins g;
  std::optional<double> P = {}; ///< if it is to be kept too
};

/// How a potential is looked for. Each iteration is a run of DPD with it, which begins on a cubic lattice.
struct PotentialSearch {
  cg::InversionSettings inversion;                       ///< whose kT is the structure's
  int iterations = 20;                                   ///< at most
  double enough = 1e-5;                                  ///< distance at which it ends
  std::uint32_t lattice = 10;                            ///< particles along an edge of the box
  std::uint64_t settle = 500, sample = 3000, every = 30; ///< steps
  double dt = 0.02;      ///< in the units of DPD: mass, cut-off and kT are one
  double friction = 4.5; ///< in those units too
  std::uint64_t seed = 1;
  int threads = 1;
};

/// One potential, and what particles with it show.
struct PotentialTrial {
  cg::PairPotential potential;
  cg::RadialBins g;
  double difference = 0; ///< of the structures, cg::g_difference
  /// What the search makes small: the same and, where P is kept, ((P - P_target)/scale)^2, the scale
  /// being the larger of |P_target| and density kT.
  double distance = 0;
  cg::Estimate P;
};

/// The structure and pressure of particles with a potential. Throws InputError where the box is too small for
/// the bins, PhysicsError where the run fails, Interrupted.
PotentialTrial try_potential(cg::PairPotential const& potential, CoarseStructure const& structure,
                             PotentialSearch const& search);

/// Throws InputError for numbers of iterations and steps that make no search.
void check_search(PotentialSearch const& search);

/// Iterative Boltzmann inversion on our own engine: all trials, until their structure is near enough or has
/// not come nearer five times. `done` is called after each with its number. Throws as check_search and
/// try_potential.
std::vector<PotentialTrial> search_potential(CoarseStructure const& structure, PotentialSearch const& search,
                                             std::function<void(int)> const& done);

/// The trial of least distance.
PotentialTrial const& best(std::vector<PotentialTrial> const& trials);

} // namespace mesobridge::workflows
