#pragma once
#include "sdpd/for_each_block.hpp"
#include "sdpd/step/fluctuating_block.hpp"

namespace mesobridge::sdpd {

/// What a sweep of fluctuation and dissipation needs beside the pairs.
struct Sweep {
  SdpdFriction friction;
  double boltzmann, dt;
};

/// Calls sweep_block(block, noise, failure) for every block and then gives the energies gained, and the
/// temperatures that belong to them, to the particles.
template <class SweepBlock>
void sweep_all_blocks(System& system, SweepBlock const& sweep_block) {
  auto& particles = system.particles;
  system.energy_gain.assign(particles.size(), 0);
  NoiseSource const source(system.seed, Stream::fluctuation, system.step);
  Failure failure;
  for_each_block(system.neighbours.grid(), system.threads,
                 [&](std::size_t block) { sweep_block(block, source, failure); });
  system.stop_at(failure);
#pragma omp parallel for schedule(static) num_threads(system.threads)
  for (std::size_t i = 0; i < particles.size(); ++i) {
    particles.eps[i] += system.energy_gain[i];
    particles.T[i] = particles.caloric[i].T(system.energy_gain[i]);
  }
}

} // namespace mesobridge::sdpd
