#pragma once
#include "sdpd/scheme/ssa.hpp"
#include "sdpd/simulation.hpp"

namespace mesobridge::sdpd {

/// What Simulation needs of an engine, one virtual call for many steps.
class Simulation::Engine {
 public:
  virtual ~Engine() = default;
  virtual void advance(std::uint64_t steps, double dt) = 0;
  virtual Particles& particles() = 0;
  virtual Neighbours& neighbours() = 0;
  virtual std::uint64_t& step() = 0;
  virtual std::uint64_t renewals() const = 0;
  virtual Box const& box() const = 0;
  virtual Observation observe() const = 0;
  /// Energies of all particles at the temperatures `T` of the particles and their densities.
  virtual void set_energies_from_temperatures() = 0;
  virtual std::vector<double> heat_capacities() const = 0;
  /// Densities, thermodynamics and forces from positions and energies.
  virtual void refresh() = 0;
  /// The same when the temperatures are known already, to the bit.
  virtual void refresh_at_known_temperatures() = 0;
};

/// The engine for one equation of state and one kernel, chosen once, outside all loops.
template <class Eos, class Kernel>
class EngineFor final : public Simulation::Engine {
 public:
  explicit EngineFor(System<Eos, Kernel> system) : system_(std::move(system)) {}

  void advance(std::uint64_t steps, double dt) override {
    for (std::uint64_t k = 0; k < steps; ++k)
      step_ssa(system_, dt);
  }
  Particles& particles() override { return system_.particles; }
  Neighbours& neighbours() override { return system_.neighbours; }
  std::uint64_t& step() override { return system_.step; }
  std::uint64_t renewals() const override { return system_.renewals; }
  Box const& box() const override { return system_.box; }
  Observation observe() const override {
    return sdpd::observe(system_.particles, system_.box, system_.virial, system_.boltzmann, system_.step);
  }
  void set_energies_from_temperatures() override {
    refresh_lists(system_);
    find_pairs_and_densities(system_);
    auto& particles = system_.particles;
    for_each_particle(system_, [&](std::size_t i) {
      particles.eps[i] = system_.eos.at(particles.rho[i]).energy(particles.T[i]);
    });
  }
  std::vector<double> heat_capacities() const override {
    auto const& particles = system_.particles;
    std::vector<double> C(particles.size());
    for (std::size_t i = 0; i < C.size(); ++i)
      C[i] = system_.eos.at(particles.rho[i]).heat_capacity(particles.T[i]);
    return C;
  }
  void refresh() override {
    refresh_lists(system_);
    find_pairs_and_densities(system_);
    thermodynamics_from_energy(system_);
    find_forces(system_);
  }
  void refresh_at_known_temperatures() override {
    find_pairs_and_densities(system_);
    thermodynamics_from_temperature(system_);
    find_forces(system_);
  }

 private:
  System<Eos, Kernel> system_;
};

} // namespace mesobridge::sdpd
