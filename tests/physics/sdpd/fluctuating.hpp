#pragma once
#include "sdpd/conservative/conservative.hpp"
#include "sdpd/fluctuation/fluctuation.hpp"
#include "sdpd/fluctuation/pair_scheme.hpp"
#include "sdpd/lammps/block_sweep.hpp"
#include "sdpd/method/settings.hpp"
#include "sdpd/system/system.hpp"

namespace mesobridge::sdpd {

/// Fluctuation and dissipation alone, at fixed places: calls record() at decorrelated instants, `between`
/// steps apart, after 20 others. One step is what sweep() does.
void at_instants(System& system, auto const& sweep, int instants, int between, auto const& record) {
  for (int k = -20; k < instants; ++k) {
    for (int s = 0; s < between; ++s, ++system.step) {
      sweep();
      thermodynamics_from_energy(system);
    }
    if (k >= 0)
      record();
  }
}
void at_instants(System& system, PairScheme scheme, double dt, int instants, int between,
                 auto const& record) {
  at_instants(
      system, [&] { fluctuate(system, scheme, dt); }, instants, between, record);
}

/// The same sweep in blocks of cells, as many ranks make it, on one that owns all particles.
class SweepInBlocks : private GhostExchange {
 public:
  SweepInBlocks(System& system, SimulationSettings const& settings)
      : system_(system), parts_(settings.as<Sdpd>().parts(settings)),
        blocks_(system.box, settings.range()), high_{system.box.edge.x, system.box.edge.y,
                                                     system.box.edge.z} {
    for (auto const id : system.particles.id)
      ids_.push_back(static_cast<std::int32_t>(id) + 1);
  }

  void operator()(PairScheme scheme, double dt) {
    auto& all = system_.particles;
    RankParticles const particles{.owned = all.size(),
                                  .all = all.size(),
                                  .q = &all.q[0].x,
                                  .v = &all.p[0].x,
                                  .f = nullptr,
                                  .ids = ids_.data(),
                                  .list = {},
                                  .low = low_.data(),
                                  .high = high_.data()};
    Failure failure;
    auto const& rows = blocks_.run(std::get<SdpdLaw>(parts_.law),
                                   {.parts = parts_,
                                    .particles = particles,
                                    .own = all,
                                    .ghosts = *this,
                                    .seed = system_.seed,
                                    .step = system_.step,
                                    .time = dt,
                                    .scheme = scheme,
                                    .counts = system_.pair_counts},
                                   failure);
    system_.stop_at(failure);
    for (std::size_t i = 0; i < all.size(); ++i) {
      all.p[i] = {rows[i][0], rows[i][1], rows[i][2]};
      all.eps[i] += rows[i][3];
      all.T[i] = all.caloric[i].T(rows[i][3]);
    }
  }

 private:
  void forward(TravellingRows const&) override {}
  void reverse(TravellingRows const&) override {}

  System& system_;
  MethodParts parts_;
  BlockSweep blocks_;
  std::array<double, 3> low_{}, high_;
  std::vector<std::int32_t> ids_;
};

} // namespace mesobridge::sdpd
