#include "sdpd/conservative/pair_forces.hpp"
#include "sdpd/neighbours/block_copy.hpp"
#include "sdpd/neighbours/for_each_block.hpp"
#include "sdpd/neighbours/select_pairs.hpp"
#include <bit>
#include <numeric>

namespace mesobridge::sdpd {
namespace {

struct Scratch {
  std::vector<Row> rows, f; // positions; forces
  std::vector<FloatRow> float_rows;
  SelectionScratch selection;
};

/// Refuses pairs that are nearer than the potential is defined.
void refuse_near(System const& system, BlockMembers const& members, std::span<LocalPair const> pairs,
                 unsigned near, Lanes const& r, double inner, Failure& failure) {
  for (; near != 0; near &= near - 1) {
    auto const l = static_cast<std::size_t>(std::countr_zero(near));
    auto id = [&](std::size_t local) { return system.particles.id[global_index(members, local)]; };
    auto const a = id(pairs[l].i), b = id(pairs[l].j);
    failure.report(std::min(a, b),
                   fmt::format("it is {:.6g} (reduced) from particle {}, nearer than {:.6g}, where the pair "
                               "potential ends; take a shorter time step or a potential that goes further in",
                               r[l], std::max(a, b), inner));
  }
}

struct Sums {
  double energy = 0, virial = 0;
};

double sum(Lanes const& lanes) {
  double total = 0;
  for (std::size_t l = 0; l < lane_count; ++l)
    total += lanes[l];
  return total;
}

/// Forces on the particles of a block from its pairs.
template <class Potential>
Sums add_forces(System const& system, Potential const& potential, BlockMembers const& members,
                std::span<LocalPair const> pairs, Scratch& scratch, Failure& failure) {
  std::size_t const particles = size(members);
  scratch.f.assign(particles + 2, Row{});
  Row const* const rows = scratch.rows.data();
  Row* const f = scratch.f.data();
  Lanes energy{}, virial{};
  double const inner = potential.inner(), cutoff = potential.cutoff();
  for_each_group(pairs, particles, [&](LocalPair const* pair, std::size_t, std::size_t count) {
    RowLanes const a = load_rows([&](std::size_t l) { return &rows[pair[l].i]; });
    RowLanes const b = load_rows([&](std::size_t l) { return &rows[pair[l].j]; });
    Lanes const x = a[0] - b[0], y = a[1] - b[1], z = a[2] - b[2], r2 = x * x + y * y + z * z;
    DistanceLanes const distance(r2);
    unsigned const present = count == lane_count ? 0xffu : (1u << count) - 1;
    if (unsigned const near = less(distance.r, broadcast(inner)) & present; near != 0) [[unlikely]]
      refuse_near(system, members, {pair, lane_count}, near, distance.r, inner, failure);
    auto const [u, s] = potential(distance.r, distance.inverse_r);
    Lanes const zero{}, strength = distance.r < cutoff ? s : zero;
    energy += distance.r < cutoff ? u : zero;
    virial += strength * r2;
    auto const force = to_rows({strength * x, strength * y, strength * z, zero});
    for (std::size_t l = 0; l < lane_count; ++l) {
      f[pair[l].i] += force[l];
      f[pair[l].j] -= force[l];
    }
  });
  return {sum(energy), sum(virial)};
}

/// The phantom pair fills lanes; what they hold must not count. It is put beyond the cut-off.
double phantom_distance(System const& system) {
  return 2 * system.neighbours.range();
}

Sums find_block_forces(System&, NoPotential const&, std::size_t, BlockMembers const&, Scratch&, Failure&) {
  return {};
}
template <class Potential>
Sums find_block_forces(System& system, Potential const& potential, std::size_t block,
                       BlockMembers const& members, Scratch& scratch, Failure& failure) {
  auto const sums = add_forces(system, potential, members, system.neighbours.pairs(block), scratch, failure);
  for_each_member(members, [&](std::size_t local, Index i, Vec3 const&) {
    Row const& f = scratch.f[local];
    system.particles.f[i] += Vec3{f[0], f[1], f[2]};
  });
  return sums;
}

template <class Potential>
void find_pair_forces(System& system, Potential const& potential) {
  auto& neighbours = system.neighbours;
  std::size_t const blocks = neighbours.grid().blocks().size();
  system.block_virial.assign(blocks, 0), system.block_energy.assign(blocks, 0);
  set_all(system, system.particles.f, Vec3{});
  Failure failure;
  for_each_block(neighbours.grid(), system.threads, [&](std::size_t block) {
    thread_local Scratch scratch;
    auto const members = neighbours.members(block);
    copy_rows(
        members, system.particles.q, [](Index) { return 0.0; }, phantom_distance(system), scratch.rows);
    round_rows(scratch.rows, scratch.float_rows);
    select_pairs(neighbours, block, scratch.float_rows, scratch.selection);
    auto const sums = find_block_forces(system, potential, block, members, scratch, failure);
    system.block_energy[block] = sums.energy, system.block_virial[block] = sums.virial;
  });
  system.stop_at(failure);
  auto total = [](std::vector<double> const& parts) {
    return std::accumulate(parts.begin(), parts.end(), 0.0);
  };
  system.potential_energy = total(system.block_energy), system.virial = total(system.block_virial);
}

} // namespace

void find_pair_forces(System& system) {
  std::visit([&](auto const& potential) { find_pair_forces(system, potential); }, system.potential);
}

} // namespace mesobridge::sdpd
