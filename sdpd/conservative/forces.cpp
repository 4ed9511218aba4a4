#include "sdpd/conservative/conservative.hpp"
#include "sdpd/neighbours/block_copy.hpp"
#include "sdpd/neighbours/for_each_block.hpp"
#include <numeric>

namespace mesobridge::sdpd {
namespace {

struct Scratch {
  std::vector<Row> rows, f; // positions with push = P/rho^2; forces
};

/// Forces on the particles of a block from its pairs; returns their virial.
template <class Kernel>
double add_forces(Kernel const& kernel, std::span<LocalPair const> pairs, std::size_t particles,
                  Scratch& scratch) {
  scratch.f.assign(particles + 2, Row{});
  Row const* const rows = scratch.rows.data();
  Row* const f = scratch.f.data();
  Lanes virial{};
  for_each_group(pairs, particles, [&](LocalPair const* pair, std::size_t, std::size_t) {
    RowLanes const a = load_rows([&](std::size_t l) { return &rows[pair[l].i]; });
    RowLanes const b = load_rows([&](std::size_t l) { return &rows[pair[l].j]; });
    Lanes const x = a[0] - b[0], y = a[1] - b[1], z = a[2] - b[2], r2 = x * x + y * y + z * z;
    DistanceLanes const distance(r2);
    Lanes const strength = (a[3] + b[3]) * kernel.F(distance.r, distance.inverse_r);
    virial += strength * r2;
    auto const force = to_rows({strength * x, strength * y, strength * z, Lanes{}});
    for (std::size_t l = 0; l < lane_count; ++l) {
      f[pair[l].i] += force[l];
      f[pair[l].j] -= force[l];
    }
  });
  double sum = 0;
  for (std::size_t l = 0; l < lane_count; ++l)
    sum += virial[l];
  return sum;
}

template <class Kernel>
void find_forces(System& system, Kernel const& kernel) {
  auto& particles = system.particles;
  auto const& neighbours = system.neighbours;
  system.block_virial.resize(neighbours.grid().blocks().size());
  set_all(system, particles.f, Vec3{});
  double const in_range = 0.5 * neighbours.range();
  auto push = [&](Index i) { return particles.P[i] / (particles.rho[i] * particles.rho[i]); };
  for_each_block(neighbours.grid(), system.threads, [&](std::size_t block) {
    thread_local Scratch scratch;
    auto const members = neighbours.members(block);
    copy_rows(members, particles.q, push, in_range, scratch.rows);
    system.block_virial[block] = add_forces(kernel, neighbours.pairs(block), size(members), scratch);
    for_each_member(members, [&](std::size_t local, Index i, Vec3 const&) {
      Row const& f = scratch.f[local];
      particles.f[i] += Vec3{f[0], f[1], f[2]};
    });
  });
  system.virial = std::accumulate(system.block_virial.begin(), system.block_virial.end(), 0.0);
}

} // namespace

void find_forces(System& system) {
  std::visit([&](auto const& kernel) { find_forces(system, kernel); }, system.kernel);
}

} // namespace mesobridge::sdpd
