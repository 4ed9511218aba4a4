#include "sdpd/observe/canonical_energy.hpp"
#include "fitting/eos/centre_of_mass_free.hpp"
#include "sdpd/method/settings.hpp"
#include "sdpd/thermodynamics/particle_eos.hpp"

namespace mesobridge::sdpd {
namespace {

/// By the trapezoidal rule in ln T, whose error is beyond all powers of the step for an integrand that
/// vanishes at both ends; T = 1.
template <class AtDensity>
double mean_energy(AtDensity const& at, double k_B, double T_min, double T_max) {
  constexpr double widths = 16, step = 0.5; // in standard deviations of ln T
  double const width = std::sqrt(k_B / at.heat_capacity(1)), most = at.entropy(1) - at.energy(1);
  double weights = 0, energies = 0;
  for (double x = -widths; x <= widths; x += step) {
    double const T = std::exp(x * width);
    if (T <= T_min || T >= T_max)
      continue;
    double const eps = at.energy(T); // deps/T = C dlnT
    double const weight = at.heat_capacity(T) * std::exp((at.entropy(T) - eps - most) / k_B);
    weights += weight, energies += weight * eps;
  }
  return energies / weights;
}

template <class Eos>
std::function<double(double)> mean_of(Eos const& eos, SimulationSettings const& settings) {
  return [particle = ParticleEos<Eos>(eos, settings.units()), k_B = 1 / settings.K(),
          T_min = eos.domain().T_min / settings.T, T_max = eos.domain().T_max / settings.T](double rho) {
    return mean_energy(particle.at(rho), k_B, T_min, T_max);
  };
}

} // namespace

CanonicalEnergy::CanonicalEnergy(SimulationSettings const& settings)
    : mean_(std::visit(
          [&](auto const& bulk) {
            return settings.as<Sdpd>().centre_of_mass == CentreOfMass::free
                       ? mean_of(fitting::CentreOfMassFree(bulk, settings.K()), settings)
                       : mean_of(bulk, settings);
          },
          settings.as<Sdpd>().eos)) {
  require_one_species(settings, "canonical energy");
}

} // namespace mesobridge::sdpd
