#pragma once
#include "sdpd/kernel/list.hpp"
#include "sdpd/neighbours.hpp"
#include "sdpd/pair/sdpd_friction.hpp"
#include "sdpd/thermodynamics.hpp"

namespace mesobridge::sdpd {

/// Everything that the sub-steps of a scheme work on: one fluid of particles of one size in a periodic box,
/// in reduced units (theory sheet, Eq. 2.20), where masses are 1 and k_B = 1/K.
struct System {
  Box box;
  std::unique_ptr<Thermodynamics const> thermodynamics;
  AnyKernel kernel;
  SdpdFriction friction;
  Neighbours neighbours;
  Particles particles;
  double boltzmann;
  std::uint64_t seed;
  int threads;
  std::uint64_t step = 0;           ///< steps done; part of the noise's counter
  double dt = 0;                    ///< time step under way, for messages
  double virial = 0;                ///< sum over pairs of f_ij . r_ij at the last evaluation of the forces
  std::uint64_t renewals = 0;       ///< of the lists, since the start
  std::vector<double> block_virial; ///< its parts, kept so that no step allocates
  std::vector<double> energy_gain;  ///< of the particles since their caloric expansions began, during a sweep

  std::size_t size() const { return particles.size(); }

  /// Throws PhysicsError that names the particle, the step and the time step, if there was a failure.
  void stop_at(Failure const& failure) const {
    if (failure.any())
      throw PhysicsError(fmt::format("particle {} at step {} (dt = {:.6g} reduced): {}", failure.id(), step,
                                     dt, failure.message()));
  }
};

/// Calls f(range) for all particles in parts, on all threads.
template <class F>
void for_each_range(System const& system, F&& f) {
  constexpr std::size_t length = 512;
#pragma omp parallel for schedule(static) num_threads(system.threads)
  for (std::size_t begin = 0; begin < system.size(); begin += length)
    f(Range{begin, std::min(begin + length, system.size())});
}

} // namespace mesobridge::sdpd
