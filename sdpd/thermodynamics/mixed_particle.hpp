#pragma once
#include "fitting/eos/list.hpp"
#include "sdpd/state/caloric.hpp"
#include "sdpd/state/units.hpp"
#include "sdpd/thermodynamics/thermodynamics.hpp"
#include <memory>

namespace mesobridge::sdpd {

/// Which models a reacting particle is made of, and how their volumes add up ("additive" or "paper").
struct ReactingModels {
  fitting::AnyEos reactant, product;
  bool additive_volumes = true; ///< else those of the thesis's (6.7), which no entropy gives
};

/// The mixture of reactant and product in one particle of mass 1, at equal T and P; all in reduced units
/// (sdpd/README.md, Eq. (S60)). This is the one place of the engine that asks fitting/eos/mixture.hpp. All
/// functions throw PhysicsError where there is no equilibrium. 0 < lambda < 1.
class MixedParticle {
 public:
  /// Where the parts are: what all else follows from, and what the next solution starts from.
  struct Split {
    double T;
    double log_density_ratio; ///< ln(rho_1/rho_0); 0: not known yet
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

  State from_energy(double lambda, double rho, double eps, Split const& guess) const;
  State from_entropy(double lambda, double rho, double S, double eps_guess, Split const& guess) const;
  double energy_from_temperature(double lambda, double rho, double T) const;
  /// Depends on its arguments alone, so that a restart finds the bits of the run that stopped.
  Response response(double lambda, double rho, Split const& split) const;
  /// The isothermal bulk moduli of both parts at the split, over the pressure. Where one of them comes to
  /// zero the balance ends.
  struct Stiffness {
    double reactant, product;
  };
  Stiffness stiffness(double lambda, double rho, Split const& split) const;

 private:
  struct Model;
  std::unique_ptr<Model const> model_;
};

} // namespace mesobridge::sdpd
