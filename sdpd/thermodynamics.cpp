#include "sdpd/thermodynamics.hpp"
#include "fitting/eos/centre_of_mass_free.hpp"
#include "sdpd/particle_eos.hpp"

namespace mesobridge::sdpd {
namespace {

template <fitting::EquationOfState Eos>
class ThermodynamicsOf final : public Thermodynamics {
 public:
  explicit ThermodynamicsOf(ParticleEos<Eos> eos) : eos_(std::move(eos)) {}

  void from_entropy(Particles& particles, Range range, Failure& failure) const override {
    for_each(particles, range, failure, [&](std::size_t i, auto const& at) {
      double const T = at.temperature_from_entropy(particles.S[i], particles.T[i]);
      particles.T[i] = T;
      particles.eps[i] = at.energy(T);
      set_response(particles, i, at);
    });
  }
  void from_energy(Particles& particles, Range range, Failure& failure) const override {
    for_each(particles, range, failure, [&](std::size_t i, auto const& at) {
      particles.T[i] = at.temperature_from_energy(particles.eps[i], particles.T[i]);
      particles.S[i] = at.entropy(particles.T[i]);
      set_response(particles, i, at);
    });
  }
  void response(Particles& particles, Range range, Failure& failure) const override {
    for_each(particles, range, failure,
             [&](std::size_t i, auto const& at) { set_response(particles, i, at); });
  }
  void energy_from_temperature(Particles& particles, Range range, Failure& failure) const override {
    for_each(particles, range, failure,
             [&](std::size_t i, auto const& at) { particles.eps[i] = at.energy(particles.T[i]); });
  }
  ThermalState state(Particles const& particles, Index i, double eps) const override {
    auto const at = eos_.at(particles.rho[i]);
    double const T = at.temperature_from_energy(eps, particles.T[i]);
    return {T, at.entropy(T), 1 / at.heat_capacity(T)};
  }
  Caloric caloric(Particles const& particles, Index i, double eps, double T_guess) const override {
    auto const at = eos_.at(particles.rho[i]);
    return at.caloric(at.temperature_from_energy(eps, T_guess));
  }
  double heat_capacity(Particles const& particles, Index i) const override {
    return eos_.at(particles.rho[i]).heat_capacity(particles.T[i]);
  }

 private:
  template <class F>
  void for_each(Particles const& particles, Range range, Failure& failure, F const& f) const {
    for (std::size_t i = range.begin; i < range.end; ++i) {
      try {
        f(i, eos_.at(particles.rho[i]));
      } catch (std::exception const& error) {
        failure.report(particles.id[i], error.what());
      }
    }
  }
  /// Not inlined: a restart must find the bits of the stopped run, and only the same machine code rounds
  /// alike.
  [[gnu::noinline]] static void set_response(Particles& particles, std::size_t i, auto const& at) {
    particles.P[i] = at.pressure(particles.T[i]);
    particles.caloric[i] = at.caloric(particles.T[i]);
  }

  ParticleEos<Eos> eos_;
};

template <class Eos>
std::unique_ptr<Thermodynamics const> of(Eos const& eos, ReducedUnits const& units) {
  return std::make_unique<ThermodynamicsOf<Eos>>(ParticleEos<Eos>(eos, units));
}

} // namespace

std::unique_ptr<Thermodynamics const>
make_thermodynamics(fitting::AnyEos const& any, ReducedUnits const& units, CentreOfMass centre_of_mass) {
  return std::visit(
      [&](auto const& bulk) {
        return centre_of_mass == CentreOfMass::free ? of(fitting::CentreOfMassFree(bulk, units.K), units)
                                                    : of(bulk, units);
      },
      any);
}

} // namespace mesobridge::sdpd
