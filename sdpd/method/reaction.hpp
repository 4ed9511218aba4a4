#pragma once
#include "fitting/eos/list.hpp"
#include "sdpd/kinetics/list.hpp"

namespace mesobridge::sdpd {

/// A reaction of an SDPD fluid, whose equation of state is the reactant's. In the units of the settings.
struct SdpdReaction {
  static constexpr NumberRange shares{.min = 0, .max = 1};

  fitting::AnyEos product;
  bool additive_volumes = true; ///< of reactant and product in a mixture; else those of the thesis's (6.7)
  double heat = 0;              ///< of reaction, per unit mass; > 0 is given to the fluid
  AnyKinetics kinetics;
  RateIntegrator integrator = RateIntegrator::midpoint;
  double progress = 0; ///< where particles begin, 0 ... 1; those of a layout where their regions say
};

} // namespace mesobridge::sdpd
