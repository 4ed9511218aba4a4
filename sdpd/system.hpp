#pragma once
#include "sdpd/failure.hpp"
#include "sdpd/neighbours.hpp"
#include "sdpd/pair/sdpd_friction.hpp"

namespace mesobridge::sdpd {

/// What fluctuation and dissipation change of a particle, and what they need of it, in one cache line.
struct alignas(64) FluctuatingParticle {
  Vec3 p;
  double eps;
  Caloric caloric;
};
static_assert(sizeof(FluctuatingParticle) == 64);

/// What the forces need of a particle and change of it, in half a cache line: push = P/rho^2.
struct alignas(32) PushedParticle {
  Vec3 f;
  double push;
};
static_assert(sizeof(PushedParticle) == 32);

/// Working memory of the sub-steps, by particle and (virial) by cell pair, kept from step to step so that
/// none of them allocates.
struct Scratch {
  std::vector<FluctuatingParticle> fluctuating;
  std::vector<double> inverse_rho;
  std::vector<PushedParticle> pushed;
  std::vector<double> virial;
};

/// Everything that the sub-steps of a scheme work on: one fluid of particles of one size in a periodic box,
/// in reduced units (theory sheet, Eq. 2.20), where masses are 1 and k_B = 1/K.
template <class Eos, class Kernel>
struct System {
  Box box;
  ParticleEos<Eos> eos;
  Kernel kernel;
  SdpdFriction friction;
  Neighbours neighbours;
  Particles particles;
  double boltzmann;
  std::uint64_t seed;
  int threads;
  std::uint64_t step = 0;     ///< steps done; part of the noise's counter
  double dt = 0;              ///< time step under way, for messages
  double virial = 0;          ///< sum over pairs of f_ij . r_ij at the last evaluation of the forces
  std::uint64_t renewals = 0; ///< of the lists, since the start
  Scratch scratch;

  std::size_t size() const { return particles.size(); }
  double self_density() const { return kernel.W(0); }

  std::string where(std::size_t i) const {
    return fmt::format("particle {} at step {} (dt = {:.6g} reduced)", particles.id[i], step, dt);
  }
};

/// Calls f(i) for every particle on all threads. An exception in f stops the run with a message that names
/// the particle, the step and the time step.
template <class S, class F>
void for_each_particle(S& system, F&& f) {
  Failure failure;
#pragma omp parallel for schedule(static) num_threads(system.threads)
  for (std::size_t i = 0; i < system.size(); ++i) {
    try {
      f(i);
    } catch (std::exception const& error) {
      failure.report(system.particles.id[i], fmt::format("{}: {}", system.where(i), error.what()));
    }
  }
  failure.throw_if_any();
}

} // namespace mesobridge::sdpd
