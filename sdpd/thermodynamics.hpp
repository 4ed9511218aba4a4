#pragma once
#include "fitting/eos/list.hpp"
#include "sdpd/failure.hpp"
#include "sdpd/particles.hpp"
#include "sdpd/units.hpp"
#include <memory>

namespace mesobridge::sdpd {

/// Particles begin ... end-1 in memory.
struct Range {
  std::size_t begin, end;
};

/// One particle's temperature, entropy and inverse heat capacity at its energy and density.
struct ThermalState {
  double T, S, inverse_C;
};

/// What the engine asks of the particles' equation of state, for a range of particles with one virtual call.
/// Everything in reduced units. A state that the model does not have is reported to `failure` under the
/// particle's id; the others go on.
class Thermodynamics {
 public:
  virtual ~Thermodynamics() = default;

  /// T, eps, P and the caloric expansion from the entropy and the density.
  virtual void from_entropy(Particles& particles, Range range, Failure& failure) const = 0;
  /// T, S, P and the caloric expansion from the energy and the density.
  virtual void from_energy(Particles& particles, Range range, Failure& failure) const = 0;
  /// S, P and the caloric expansion from the temperature and the density, energies untouched: what a restart
  /// needs to find the very numbers that the stopped run held.
  virtual void from_temperature(Particles& particles, Range range, Failure& failure) const = 0;
  /// eps from the temperature and the density.
  virtual void energy_from_temperature(Particles& particles, Range range, Failure& failure) const = 0;

  /// For one particle. They throw PhysicsError.
  virtual double temperature(double eps, double rho, double T_guess) const = 0;
  virtual double heat_capacity(double T, double rho) const = 0;
  /// The expansion that begins at this energy.
  virtual Caloric caloric(double eps, double rho, double T_guess) const = 0;
  virtual ThermalState state(double eps, double rho, double T_guess) const = 0;
};

/// For particles of the size in `units`.
std::unique_ptr<Thermodynamics const> make_thermodynamics(fitting::AnyEos const& eos,
                                                          ReducedUnits const& units);

} // namespace mesobridge::sdpd
