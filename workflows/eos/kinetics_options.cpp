#include "workflows/eos/kinetics_options.hpp"
#include "sdpd/kernel/list.hpp"
#include "workflows/eos/named_fluid.hpp"
#include "workflows/shared_options.hpp"

namespace mesobridge::workflows {

void KineticsOptions::declare(CLI::App& app) {
  app.add_option("--Z", Z, "Prefactor of the rate in 1/s")->required();
  app.add_option("--Ea", E_a, "Activation energy of one molecule in J")->required();
  add_choice(app, "--order", order, {"second", "first"},
             "Order of the reaction: Z exp(-Ea/kT) S (1 - lambda)^2 or Z exp(-Ea/kT) (1 - lambda)");
  add_choice(app, "--sum", sum, {"density", "density-minus-self", "unit"},
             "The sum S over the neighbours, of second order: rho/rho-bar, the same less a particle's own "
             "weight (the thesis's sum over j != i), or 1");
  app.add_option("--rho-bar", rho_bar,
                 "Mean density of the particles in that sum (kg/m^3). If not given: --rho0");
  add_choice(app, "--kernel", kernel, sdpd::kernel_names(),
             "Smoothing kernel, for a particle's own weight W(0)");
  add_bounded(app, "--h-factor", h_factor, 1.0, 10.0, "Its support in mean spacings of the particles");
  app.add_option("--self", self, "Instead of these two: the weight itself (0.163: cubic, 2.5)");
}

fitting::Kinetics KineticsOptions::kinetics(double rho_at_rest) const {
  require_positive_number("--Z", Z);
  require(E_a >= 0 && std::isfinite(E_a), "--Ea", E_a, "must be >= 0 and finite");
  double const density = rho_bar.value_or(rho_at_rest);
  require_positive_number("--rho-bar", density);
  double const own = self ? *self : sdpd::self_density(sdpd::make_kernel(kernel, h_factor), {});
  require(own >= 0 && std::isfinite(own), "--self", own, "must be >= 0 and finite");
  return {.arrhenius = {.Z = Z, .E_a = E_a},
          .order = order == "first" ? fitting::Kinetics::Order::first : fitting::Kinetics::Order::second,
          .sum = sum == "unit"      ? fitting::NeighbourSum::unit
                 : sum == "density" ? fitting::NeighbourSum::density
                                    : fitting::NeighbourSum::density_minus_self,
          .rho_bar = density,
          .self_weight = own};
}

} // namespace mesobridge::workflows
