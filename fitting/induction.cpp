#include "fitting/induction.hpp"
#include "fitting/quadrature.hpp"

namespace mesobridge::fitting {

ThermalExplosion thermal_explosion(ReactiveFluid const& fluid, double rho, double e,
                                   Kinetics const& kinetics) {
  kinetics.validate();
  auto const beginning = fluid.exploded(rho, e, 0);
  double const T_a = kinetics.arrhenius.activation_temperature();
  double const e_fold = beginning.c_v * beginning.T * beginning.T / (fluid.q * T_a); // of the rate, in lambda
  auto here = beginning;
  auto const duration = [&](double lambda) {
    here = fluid.exploded(rho, e, lambda, here.split);
    return 1 / kinetics.positive_rate(lambda, rho, here.T);
  };
  return {.time = integral(duration, 0, ThermalExplosion::exploded),
          .frank_kamenetskii = e_fold / kinetics.positive_rate(0, rho, beginning.T),
          .end = fluid.exploded(rho, e, 1)};
}

ShockToDetonation shock_to_detonation(ReactiveFluid const& fluid, double v_P, Kinetics const& kinetics) {
  auto const shock = fluid.hugoniot().from_piston(v_P);
  auto const explosion = thermal_explosion(fluid, shock.behind.rho, shock.behind.e, kinetics);
  Hugoniot const into_shocked(shock.behind, Fluid(fluid.mixture.product().eos()), fluid.q);
  double const D = v_P + into_shocked.chapman_jouguet().v_S;
  // The detonation begins at the piston, which has moved by then.
  double const time = explosion.time * (D - v_P) / (D - shock.v_S);
  return {
      .shock = shock, .explosion = explosion, .super_detonation = D, .time = time, .place = shock.v_S * time};
}

} // namespace mesobridge::fitting
