#include "sdpd/method/dpde.hpp"
#include "sdpd/method/settings.hpp"
#include <algorithm>

namespace mesobridge::sdpd {

double Dpde::range(SimulationSettings const& at) const {
  double const cutoff = conduction ? std::visit([](auto const& of) { return of.cutoff(); }, *conduction) : 0;
  return std::max(PairFluid::range(at), cutoff / units(at).length());
}

MethodParts Dpde::parts(SimulationSettings const& at) const {
  auto const reduced = units(at);
  auto parts = parts_with<DpdeLaw>(at);
  auto const of = [&](auto const& any) { return make_thermodynamics(any.internal_energy, reduced); };
  parts.thermodynamics = species.empty() ? of(*this) : mixture_of(species, of);
  if (conduction) {
    double const coefficient = reduced.energy() * reduced.temperature / reduced.time();
    parts.conduction = DpdeConduction{in_units(*conduction, reduced.length(), coefficient), parts.boltzmann};
  }
  return parts;
}

} // namespace mesobridge::sdpd
