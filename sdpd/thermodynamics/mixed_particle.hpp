#pragma once
#include "fitting/eos/list.hpp"
#include "sdpd/state/caloric.hpp"
#include "sdpd/state/particles.hpp"
#include "sdpd/state/units.hpp"
#include "sdpd/thermodynamics/packed_places.hpp"
#include "sdpd/thermodynamics/thermodynamics.hpp"
#include <array>
#include <memory>
#include <optional>
#include <span>

namespace mesobridge::sdpd {

/// Which models a reacting particle is made of, and how their volumes add up ("additive" or "paper").
struct ReactingModels {
  fitting::AnyEos reactant, product;
  bool additive_volumes = true; ///< else those of the thesis's (6.7), which no entropy gives
};

/// The mixture of reactant and product in particles of mass 1, at equal T and P; all in reduced units
/// (sdpd/README.md, Eq. (S60)). This is the one place of the engine that asks fitting/eos/mixture.hpp: one
/// particle at a time the careful way, or as many as fill a register from their last states. 0 < lambda < 1.
class MixedParticle {
 public:
  /// Where the parts are: what all else follows from, and what the next solution starts from.
  struct Split {
    double T;
    double log_density_ratio; ///< ln(rho_1/rho_0); a guess may take the densities for equal, 0
  };
  struct State {
    Split split;
    double eps, S;
  };
  struct Response {
    double P;
    Caloric caloric;
  };

  /// Throws InputError for models whose heat capacity is not constant.
  MixedParticle(ReactingModels const& models, ReducedUnits const& units, CentreOfMass centre_of_mass);
  ~MixedParticle();
  MixedParticle(MixedParticle&&) noexcept;

  // One at a time; they throw PhysicsError where there is no equilibrium.
  State from_energy(double lambda, double rho, double eps, Split const& guess) const;
  State from_entropy(double lambda, double rho, double S, Split const& guess) const;
  double energy_from_temperature(double lambda, double rho, double T) const;
  Response response(double lambda, double rho, Split const& split) const;
  /// The isothermal bulk moduli of both parts at the split, over the pressure. Where one of them comes to
  /// zero the balance ends.
  struct Stiffness {
    double reactant, product;
  };
  Stiffness stiffness(double lambda, double rho, Split const& split) const;
  /// Of as many particles as fill a register, or fewer, at their last states.
  using Stiffnesses = std::array<Stiffness, fitting::Pack::size>;
  Stiffnesses stiffnesses(Particles const& of, std::span<Index const> places) const;
  /// The density at which the mixture of this split has the energy and the entropy, which it has left at
  /// constant entropy for one nearby; nothing where there is none, such as after a change of the entropy.
  std::optional<double> last_density(double lambda, double eps, double S, Split const& split,
                                     double nearby) const;

  // Neighbours in memory, from their own last states; they return the lanes for which it went well and leave
  // the others as they are.
  fitting::PackMask from_energy(Particles& of, PackedPlaces const& places) const;  ///< T, ratio, S
  fitting::PackMask from_entropy(Particles& of, PackedPlaces const& places) const; ///< T, ratio, eps
  /// P and the caloric expansion, from T and the ratio: depends on a particle's own numbers alone, so that a
  /// restart finds the bits of the run that stopped.
  fitting::PackMask response(Particles& of, PackedPlaces const& places) const;

 private:
  struct Model;
  std::unique_ptr<Model const> model_;
};

} // namespace mesobridge::sdpd
