#include "sdpd/conservative/pair_forces.hpp"
#include "sdpd/boundary/mirror.hpp"
#include "sdpd/neighbours/select_pairs.hpp"
#include "sdpd/system/pair_loop.hpp"
#include <bit>
#include <numeric>

namespace mesobridge::sdpd {
namespace {

/// The force of a pair potential, f_ij = -u'(r_ij) r_ij/r_ij, with energy and virial.
template <class Potential>
struct PotentialForce {
  System const& system;
  Potential const& potential;
  BlockMembers members;
  Failure& failure;
  Lanes energy{}, virial{};

  [[gnu::always_inline]] Lanes operator()(PairLanes const& at) {
    double const cutoff = potential.cutoff();
    unsigned const present = at.count == lane_count ? 0xffu : (1u << at.count) - 1;
    if (unsigned const near = less(at.r, broadcast(potential.inner())) & present; near != 0) [[unlikely]]
      refuse(at, near);
    auto const [u, s] = potential(at.r, at.inverse_r);
    Lanes const zero{}, strength = at.r < cutoff ? s : zero;
    energy += at.r < cutoff ? u : zero;
    virial += strength * at.r2;
    return strength;
  }

  /// Pairs that are nearer than the potential is defined.
  [[gnu::noinline]] void refuse(PairLanes const& at, unsigned near) const {
    for (; near != 0; near &= near - 1) {
      auto const l = static_cast<std::size_t>(std::countr_zero(near));
      auto id = [&](std::size_t local) { return system.particles.id[global_index(members, local)]; };
      report_too_near(failure, id(at.pair[l].i), id(at.pair[l].j), at.r[l], potential.inner());
    }
  }
};

/// Those of the candidates that are in range become the block's pairs.
void select_in_range(Neighbours& neighbours, std::size_t block, std::vector<Row> const& rows) {
  thread_local std::vector<FloatRow> float_rows;
  thread_local SelectionScratch selection;
  round_rows(rows, float_rows);
  select_pairs(neighbours, block, float_rows, selection);
}

/// Friction and noise need the pairs all the same.
void find_pair_forces(System& system, NoPotential const&) {
  auto& neighbours = system.neighbours;
  for_each_block(neighbours.grid(), system.threads, [&](std::size_t block) {
    thread_local std::vector<Row> rows;
    copy_rows(neighbours.members(block), system.particles.q, no_quantity, 2 * neighbours.range(), rows);
    select_in_range(neighbours, block, rows);
  });
}

/// The phantom pair lies beyond the cut-off: what it holds must not count.
template <class Potential>
void find_pair_forces(System& system, Potential const& potential) {
  auto& neighbours = system.neighbours;
  Failure failure;
  for_each_pair(
      system, Gather{no_quantity, 2 * neighbours.range()}, EqualAndOpposite{system.particles.f},
      [&](std::size_t block, std::vector<Row> const& rows) { select_in_range(neighbours, block, rows); },
      [&](std::size_t block) {
        return PotentialForce<Potential>{system, potential, neighbours.members(block), failure};
      },
      [&](std::size_t block, auto const& law) {
        system.block_energy[block] = sum(law.energy), system.block_virial[block] = sum(law.virial);
      });
  system.stop_at(failure);
}

double total(std::vector<double> const& parts) {
  return std::accumulate(parts.begin(), parts.end(), 0.0);
}

} // namespace

void report_too_near(Failure& failure, std::uint32_t a, std::uint32_t b, double r, double inner) {
  failure.report(std::min(a, b),
                 fmt::format("it is {:.6g} (reduced) from particle {}, nearer than {:.6g}, where the pair "
                             "potential ends; take a shorter time step or a potential that goes further in",
                             r, std::max(a, b), inner));
}

void find_pair_forces(System& system) {
  std::size_t const blocks = system.neighbours.grid().blocks().size();
  system.block_virial.assign(blocks, 0), system.block_energy.assign(blocks, 0);
  set_all(system, system.particles.f, Vec3{});
  std::visit([&](auto const& potential) { find_pair_forces(system, potential); }, system.potential);
  system.potential_energy = total(system.block_energy), system.virial = total(system.block_virial);
  add_wall_pair_forces(system);
}

} // namespace mesobridge::sdpd
