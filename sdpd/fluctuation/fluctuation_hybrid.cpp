#include "sdpd/fluctuation/fluctuation_hybrid.hpp"
#include "sdpd/conservative/conservative.hpp"
#include "sdpd/fluctuation/fluctuation.hpp"
#include "sdpd/fluctuation/pair_integrator.hpp"
#include "sdpd/fluctuation/pair_scheme.hpp"
#include "sdpd/system/selected_pairs.hpp"

namespace mesobridge::sdpd {
namespace {

std::vector<std::uint32_t> domains(System const& system) {
  std::vector<std::uint32_t> of(system.size());
  Vec3 const edge = system.box.edge;
  for (std::size_t i = 0; i < of.size(); ++i) {
    Vec3 const q = system.box.wrap(system.particles.q[i]);
    auto const part = [](double at, double length) {
      return static_cast<std::uint32_t>(std::clamp(at / length * hybrid_domains, 0.0, hybrid_domains - 1.0));
    };
    of[i] = (part(q.z, edge.z) * hybrid_domains + part(q.y, edge.y)) * hybrid_domains + part(q.x, edge.x);
  }
  return of;
}

} // namespace

void fluctuate_hybrid(System& system, double dt, bool second) {
  auto const domain = domains(system);
  {
    SelectedPairs const within(system, [&](Index i, Index j) { return domain[i] == domain[j]; });
    fluctuate(system, PairScheme::ssa, dt, second);
  }
  if (system.thermodynamics) // not for laws without energies
    thermodynamics_from_energy(system);
  SelectedPairs const shared(system, [&](Index i, Index j) { return domain[i] != domain[j]; });
  fluctuate_ser(system, dt, second);
}

PairIntegrator hybrid_integrator() {
  return {.name = "hybrid",
          .summary = "ssa within eight domains and ser between them",
          .sweep = fluctuate_hybrid,
          .short_steps_only = true};
}

} // namespace mesobridge::sdpd
