#include "sdpd/thermodynamics/thermodynamics.hpp"
#include "fitting/eos/centre_of_mass_free.hpp"
#include "sdpd/thermodynamics/heated_states.hpp"
#include "sdpd/thermodynamics/packed_places.hpp"
#include "sdpd/thermodynamics/particle_eos.hpp"

namespace mesobridge::sdpd {
namespace {

using fitting::Pack, fitting::PackMask;

/// The given quantity of a particle determines its temperature, and that the other one.
struct FromEntropy {
  static constexpr auto given = &Particles::S, other = &Particles::eps;
  static auto temperature(auto const& at, auto S, auto T_guess) {
    return at.temperature_from_entropy(S, T_guess);
  }
  static auto find(auto const& at, auto T) { return at.energy(T); }
};
struct FromEnergy {
  static constexpr auto given = &Particles::eps, other = &Particles::S;
  static auto temperature(auto const& at, auto eps, auto T_guess) {
    return at.temperature_from_energy(eps, T_guess);
  }
  static auto find(auto const& at, auto T) { return at.entropy(T); }
};
/// Nothing has to be found.
struct FromTemperature {};

template <class From>
void solve(Particles& particles, std::size_t i, auto const& at) {
  if constexpr (!std::is_same_v<From, FromTemperature>) {
    double const T = From::temperature(at, (particles.*From::given)[i], particles.T[i]);
    particles.T[i] = T, (particles.*From::other)[i] = From::find(at, T);
  }
}
/// Returns the lanes that it solved.
template <class From>
PackMask solve(Particles& particles, PackedPlaces const& places, auto const& at) {
  if constexpr (std::is_same_v<From, FromTemperature>) {
    return ~PackMask{};
  } else {
    Pack const T = From::temperature(at, places.load(particles.*From::given), places.load(particles.T));
    PackMask const fine = at.covered(T);
    places.store(T, fine, particles.T);
    places.store(From::find(at, T), fine, particles.*From::other);
    return fine;
  }
}

/// What is found of a particle beside T and its other given quantity: P and the caloric expansion, or
/// nothing.
enum class Renewed { state, state_and_response };

template <fitting::EquationOfState Eos>
class ThermodynamicsOf final : public Thermodynamics, public HeatedStates {
 public:
  explicit ThermodynamicsOf(ParticleEos<Eos> eos) : eos_(std::move(eos)) {}

  void from_entropy(Particles& particles, Range range, Failure& failure) const override {
    renew<FromEntropy>(particles, range, failure);
  }
  void from_energy(Particles& particles, Range range, Failure& failure) const override {
    renew<FromEnergy>(particles, range, failure);
  }
  void temperature_from_energy(Particles& particles, Range range, Failure& failure) const override {
    renew<FromEnergy, Renewed::state>(particles, range, failure);
  }
  void response(Particles& particles, Range range, Failure& failure) const override {
    renew<FromTemperature>(particles, range, failure);
  }
  void energy_from_temperature(Particles& particles, Range range, Failure& failure) const override {
    for (std::size_t i = range.begin; i < range.end; ++i)
      reported(particles, i, failure, [&](auto const& at) { particles.eps[i] = at.energy(particles.T[i]); });
  }
  ThermalState state(Particles const& particles, Index i, double eps) const override {
    auto const at = eos_.at(particles.rho[i]);
    double const T = at.temperature_from_energy(eps, particles.T[i]);
    return {T, at.entropy(T), 1 / at.heat_capacity(T)};
  }
  ThermalState heated(Particles const& particles, Index i, HeatOrigin const& from, double heat,
                      double T_guess) const override {
    auto const at = eos_.at(particles.rho[i]);
    double const T = at.temperature_from_energy(from.eps + heat, T_guess);
    double const missed = (from.eps - at.energy(from.T)) / from.T; // of the origin's entropy, to second order
    return {T, at.entropy(T) - at.entropy(from.T) - missed, 1 / at.heat_capacity(T)};
  }
  Caloric caloric(Particles const& particles, Index i, double eps, double T_guess) const override {
    auto const at = eos_.at(particles.rho[i]);
    return at.caloric(at.temperature_from_energy(eps, T_guess));
  }
  HeatedStates const* heated_states() const override { return this; }
  std::optional<double> constant_heat_capacity() const override { return eos_.constant_heat_capacity(); }
  double heat_capacity(Particles const& particles, Index i) const override {
    return eos_.at(particles.rho[i]).heat_capacity(particles.T[i]);
  }

 private:
  template <class F>
  void reported(Particles const& particles, std::size_t i, Failure& failure, F const& f) const {
    try {
      f(eos_.at(particles.rho[i]));
    } catch (std::exception const& error) {
      failure.report(particles.id[i], error.what());
    }
  }
  template <class From, Renewed renewed = Renewed::state_and_response>
  void renew(Particles& particles, Range range, Failure& failure) const {
    if constexpr (fitting::PackedModel<Eos>) {
      for (std::size_t first = range.begin; first < range.end; first += Pack::size)
        renew<From, renewed>(particles, PackedPlaces(first, range.end), failure);
    } else {
      for (std::size_t i = range.begin; i < range.end; ++i)
        reported(particles, i, failure, [&](auto const& at) {
          solve<From>(particles, i, at);
          if constexpr (renewed == Renewed::state_and_response)
            set_response(particles, i, at);
        });
    }
  }
  /// Lanes that fail go the careful way, one by one, so that what becomes of a particle does not depend on
  /// its neighbours in memory.
  template <class From, Renewed renewed>
  void renew(Particles& particles, PackedPlaces const& places, Failure& failure) const {
    auto const at = eos_.at(places.load(particles.rho));
    places.for_each_outside(solve<From>(particles, places, at), [&](std::size_t i) {
      reported(particles, i, failure, [&](auto const& alone) { solve<From>(particles, i, alone); });
    });
    if constexpr (renewed == Renewed::state_and_response)
      places.for_each_outside(set_responses(particles, places, at), [&](std::size_t i) {
        reported(particles, i, failure, [&](auto const& alone) { set_response(particles, i, alone); });
      });
  }
  /// Not inlined, both: a restart must find the bits of the stopped run, and only the same machine code
  /// rounds alike.
  [[gnu::noinline]] static void set_response(Particles& particles, std::size_t i, auto const& at) {
    particles.P[i] = at.pressure(particles.T[i]);
    particles.caloric[i] = at.caloric(particles.T[i]);
  }
  [[gnu::noinline]] static PackMask set_responses(Particles& particles, PackedPlaces const& places,
                                                  auto const& at) {
    Pack const T = places.load(particles.T);
    PackMask const fine = at.covered(T);
    places.store(at.pressure(T), fine, particles.P);
    at.store_calorics(T, fine, places.count, &particles.caloric[places.first]);
    return fine;
  }

  ParticleEos<Eos> eos_;
};

template <class Eos>
std::unique_ptr<Thermodynamics const> of(Eos const& eos, ReducedUnits const& units, double mass) {
  return std::make_unique<ThermodynamicsOf<Eos>>(ParticleEos<Eos>(eos, units, mass));
}

} // namespace

std::unique_ptr<Thermodynamics const>
make_thermodynamics(fitting::AnyEos const& any, ReducedUnits const& units, CentreOfMass centre_of_mass) {
  return make_thermodynamics(any, units, centre_of_mass, {.K = units.K, .mass = 1});
}

std::unique_ptr<Thermodynamics const> make_thermodynamics(fitting::AnyEos const& any,
                                                          ReducedUnits const& units,
                                                          CentreOfMass centre_of_mass, ParticleSize size) {
  return std::visit(
      [&](auto const& bulk) {
        return centre_of_mass == CentreOfMass::free
                   ? of(fitting::CentreOfMassFree(bulk, size.K), units, size.mass)
                   : of(bulk, units, size.mass);
      },
      any);
}

} // namespace mesobridge::sdpd
