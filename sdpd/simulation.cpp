#include "sdpd/simulation.hpp"
#include "sdpd/make_system.hpp"
#include "sdpd/observe/bond_order.hpp"
#include "sdpd/observe/compression.hpp"
#include "sdpd/observe/pairing.hpp"
#include "sdpd/observe/structure_factor.hpp"
#include "sdpd/scheme/scheme.hpp"
#include "sdpd/state/pair_counts.hpp"
#include "sdpd/system/system.hpp"
#include <algorithm>

namespace mesobridge::sdpd {
Simulation::Simulation(SimulationSettings const& settings)
    : has_noise_(settings.noise), bath_rate_(settings.bath_rate), units_(settings.units()), dt_(settings.dt),
      system_(make_system(settings)), sub_steps_(sdpd::sub_steps(settings.scheme, *system_, settings.dt)) {}

Simulation::~Simulation() = default;
Simulation::Simulation(Simulation&&) noexcept = default;
Simulation& Simulation::operator=(Simulation&&) noexcept = default;

void Simulation::advance(std::uint64_t steps) {
  for (std::uint64_t k = 0; k < steps; ++k)
    sdpd::step(*system_, sub_steps_);
}
std::uint64_t Simulation::step() const {
  return system_->step;
}
Observation Simulation::observe() const {
  return sdpd::observe(*system_);
}
std::vector<double> Simulation::measure(Measurement const& measurement) const {
  if (auto const* const of_system = std::get_if<Measurement::FromSystem>(&measurement.values))
    return (*of_system)(*system_);
  return std::get<Measurement::FromSums>(measurement.values)(observe());
}
bool Simulation::has_thermostat() const {
  return !system_->has_energies();
}
Box const& Simulation::box() const {
  return system_->box;
}
std::size_t Simulation::size() const {
  return system_->particles.size();
}
std::vector<Wall> const& Simulation::walls() const {
  return system_->walls;
}
double Simulation::wall_time() const {
  return system_->wall_time;
}
void Simulation::hold_walls(bool hold) {
  system_->walls_held = hold;
}
PairCounts Simulation::pair_counts() const {
  return system_->pair_counts;
}
PairCounts Simulation::conduction_counts() const {
  return system_->conduction_counts;
}
std::uint64_t Simulation::list_renewals() const {
  return system_->renewals;
}

double Simulation::neighbours() const {
  return 2.0 * static_cast<double>(system_->neighbours.pair_count()) / static_cast<double>(size());
}

double Simulation::compression_response() const {
  return sdpd::compression_response(*system_);
}

double Simulation::pairing_fraction() const {
  return sdpd::pairing_fraction(*system_);
}

double Simulation::crystal_fraction() const {
  return std::max(bond_order(*system_).crystal, lattice_order(system_->particles.q, system_->box));
}

} // namespace mesobridge::sdpd
