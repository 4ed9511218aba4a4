#include "sdpd/observe/virials.hpp"
#include "sdpd/boundary/mirror.hpp"
#include "sdpd/system/pair_loop.hpp"

namespace mesobridge::sdpd {
namespace {

/// Half of a pair's virial f_ij . r_ij, for each of its particles.
template <class Potential>
struct HalfOfVirial {
  Potential const& potential;

  [[gnu::always_inline]] Lanes operator()(PairLanes const& at) const {
    Lanes const strength = potential(at.r, at.inverse_r).strength, zero{};
    return 0.5 * (at.r < potential.cutoff() ? strength : zero) * at.r2;
  }
};

void add_virials(System const&, NoPotential const&, std::vector<double>&) {}
template <class Potential>
void add_virials(System const& system, Potential const& potential, std::vector<double>& of_places) {
  for_each_pair(
      system, Gather{no_quantity, 2 * system.neighbours.range()}, SameToBoth{of_places}, as_they_are,
      [&](std::size_t) { return HalfOfVirial<Potential>{potential}; }, [](std::size_t, auto const&) {});
}

} // namespace

std::vector<double> virials(System const& system) {
  if (system.has_densities())
    return {};
  std::vector<double> of_places(system.size()), virial(system.size());
  std::visit([&](auto const& potential) { add_virials(system, potential, of_places); }, system.potential);
  add_wall_virials(system, of_places);
  for (std::size_t i = 0; i < virial.size(); ++i)
    virial[system.particles.id[i]] = of_places[i];
  return virial;
}

} // namespace mesobridge::sdpd
