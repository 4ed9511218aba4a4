#pragma once
#include "fitting/eos/list.hpp"
#include "fitting/internal_energy.hpp"
#include "sdpd/state/failure.hpp"
#include "sdpd/state/particles.hpp"
#include "sdpd/state/units.hpp"
#include <algorithm>
#include <memory>
#include <optional>
#include <span>

namespace mesobridge::sdpd {

/// Particles begin ... end-1 in memory.
struct Range {
  std::size_t begin, end;
};

/// One particle's temperature, entropy and inverse heat capacity at its energy and density.
struct ThermalState {
  double T, S, inverse_C;
};

/// What becomes of a mixture whose parts come to the end of their balance (sdpd/README.md, Eqs. (S66),
/// (S67)).
enum class MixtureFate {
  goes_on,
  burns_up,           ///< what is left of its reactant burns at once
  counts_as_reactant, ///< the trace of product in it does not count for the time being
  mixes_again         ///< it counts again
};

class HeatedStates;

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
  /// T and S alone, where no pressure is asked for: P and the caloric expansion may stay as they are.
  virtual void temperature_from_energy(Particles& particles, Range range, Failure& failure) const {
    from_energy(particles, range, failure);
  }
  /// P and the caloric expansion from the temperature and the density, energies and entropies untouched: what
  /// a restart needs to find the very numbers that the stopped run held.
  virtual void response(Particles& particles, Range range, Failure& failure) const = 0;
  /// eps from the temperature and the density.
  virtual void energy_from_temperature(Particles& particles, Range range, Failure& failure) const = 0;

  /// For particle i at the energy eps instead of its own. They throw PhysicsError.
  virtual ThermalState state(Particles const& particles, Index i, double eps) const = 0;
  /// The expansion that begins at this energy, whose temperature is near T_guess.
  virtual Caloric caloric(Particles const& particles, Index i, double eps, double T_guess) const = 0;

  /// The heat capacity of every particle at every state, where that is one number.
  virtual std::optional<double> constant_heat_capacity() const = 0;
  /// Of particle i at its temperature.
  virtual double heat_capacity(Particles const& particles, Index i) const = 0;
  /// What it offers beside; null where it does not.
  virtual HeatedStates const* heated_states() const { return nullptr; }

  /// What has to become of particle i, which reacts, so that it has a state next time, too; and of each of a
  /// range.
  virtual MixtureFate fate(Particles const&, Index) const { return MixtureFate::goes_on; }
  virtual void fates(Particles const&, Range, std::span<MixtureFate> of_each) const {
    std::ranges::fill(of_each, MixtureFate::goes_on);
  }
};

/// What a particle's equation of state says of its centre of mass, whose kinetic energy (3/2) k_B T and
/// pressure k_B T/V the moving particles have anyway.
enum class CentreOfMass {
  free, ///< S = m s less the centre of mass's part (sdpd/README.md, Eq. (S8)): totals do not depend on K
  bulk  ///< S = m s: the kinetic energy and the pressure of the particles come on top of the bulk's
};

/// The size of particles in atoms or molecules, and their mass in reduced units.
struct ParticleSize {
  double K, mass;
};

/// For particles of the size in `units`, or another. Throws InputError when the heat capacity of a particle
/// is not above that of its centre of mass.
std::unique_ptr<Thermodynamics const> make_thermodynamics(fitting::AnyEos const& eos,
                                                          ReducedUnits const& units,
                                                          CentreOfMass centre_of_mass = CentreOfMass::free);
std::unique_ptr<Thermodynamics const> make_thermodynamics(fitting::AnyEos const& eos,
                                                          ReducedUnits const& units,
                                                          CentreOfMass centre_of_mass, ParticleSize size);

/// For particles without densities (DPDE); k_B is 1.
std::unique_ptr<Thermodynamics const> make_thermodynamics(fitting::AnyInternalEnergy const& internal_energy,
                                                          ReducedUnits const& units);

} // namespace mesobridge::sdpd
