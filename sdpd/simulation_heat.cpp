#include "sdpd/conservative/refresh.hpp"
#include "sdpd/fluctuation/langevin.hpp"
#include "sdpd/simulation.hpp"
#include "sdpd/state/random.hpp"
#include "sdpd/system/system.hpp"
#include "sdpd/system/total_energy.hpp"
#include <algorithm>

// What gives a simulation's particles other temperatures, momenta or densities.

namespace mesobridge::sdpd {
namespace {

std::vector<double> heat_capacities(System const& system) {
  std::vector<double> C(system.particles.eps.size());
  for (std::size_t i = 0; i < C.size(); ++i)
    C[i] = system.thermodynamics->heat_capacity(system.particles, static_cast<Index>(i));
  return C;
}

} // namespace

void Simulation::heat(double rise) {
  auto const C = heat_capacities(*system_);
  auto& eps = system_->particles.eps;
  auto const& T = system_->particles.T;
  double sum_C = 0, sum_CT = 0;
  for (std::size_t i = 0; i < eps.size(); ++i)
    sum_C += C[i], sum_CT += C[i] * T[i];
  double const factor = rise * sum_C / sum_CT; // one for all: small cold particles stay above zero
  for (std::size_t i = 0; i < eps.size(); ++i)
    eps[i] += C[i] * T[i] * factor;
  refresh(*system_);
}

void Simulation::couple_to_bath() {
  sdpd::couple_to_bath(*system_, bath_rate_, dt_);
  refresh(*system_);
}

void Simulation::scale_momenta(double factor) {
  for (auto& p : system_->particles.p)
    p *= factor;
  system_->kept_energy = total_energy(*system_) - system_->energy_given();
}

void Simulation::draw_temperatures() {
  auto& particles = system_->particles;
  std::fill(particles.T.begin(), particles.T.end(), 1.0);
  auto const C = heat_capacities(*system_);
  NoiseSource const source(system_->seed, Stream::initial_energies, system_->step);
  for (std::size_t i = 0; i < particles.size(); ++i) { // C counts in K k_B
    bool const small = system_->has_densities() ? units_.K * particles.mass_of(i) < 50 : C[i] < 50;
    if (!small)
      particles.T[i] += std::sqrt(1 / (units_.K * C[i])) * gaussians_reference(source, particles.id[i], 0)[0];
  }
  set_energies_from_temperatures(*system_);
  refresh(*system_);
}

double Simulation::heat_capacity() const {
  double sum = 0;
  for (double const C : heat_capacities(*system_))
    sum += C * units_.K; // reduced C counts in K k_B
  return sum + 1.5 * (static_cast<double>(size()) - 1);
}

void Simulation::set_density_correction(DensityCorrection const& correction) {
  auto& kernel = system_->kernel;
  std::string_view const name = std::visit([](auto const& of) { return of.name; }, kernel);
  kernel = make_kernel(name, system_->neighbours.range(), correction.scale);
  system_->self_density = self_density(kernel, correction);
  set_energies_from_temperatures(*system_);
  refresh(*system_);
}

} // namespace mesobridge::sdpd
