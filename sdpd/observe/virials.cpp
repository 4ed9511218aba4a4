#include "sdpd/observe/virials.hpp"
#include "sdpd/neighbours/block_copy.hpp"
#include "sdpd/neighbours/for_each_block.hpp"

namespace mesobridge::sdpd {
namespace {

struct Scratch {
  std::vector<Row> rows;
  std::vector<double> virial;
};

template <class Potential>
void add_pairs(Potential const& potential, std::span<LocalPair const> pairs, std::size_t particles,
               Scratch& scratch) {
  scratch.virial.assign(particles + 2, 0); // room for the phantom pair
  double const cutoff = potential.cutoff();
  for_each_group(pairs, particles, [&](LocalPair const* pair, std::size_t, std::size_t) {
    RowLanes const a = load_rows([&](std::size_t l) { return &scratch.rows[pair[l].i]; });
    RowLanes const b = load_rows([&](std::size_t l) { return &scratch.rows[pair[l].j]; });
    Lanes const x = a[0] - b[0], y = a[1] - b[1], z = a[2] - b[2], r2 = x * x + y * y + z * z, zero{};
    DistanceLanes const distance(r2);
    Lanes const strength = potential(distance.r, distance.inverse_r).strength;
    Lanes const half = 0.5 * (distance.r < cutoff ? strength : zero) * r2;
    for (std::size_t l = 0; l < lane_count; ++l) {
      scratch.virial[pair[l].i] += half[l];
      scratch.virial[pair[l].j] += half[l];
    }
  });
}

void add_virials(System const&, NoPotential const&, std::vector<double>&) {}
template <class Potential>
void add_virials(System const& system, Potential const& potential, std::vector<double>& virial) {
  auto const& neighbours = system.neighbours;
  for_each_block(neighbours.grid(), system.threads, [&](std::size_t block) {
    thread_local Scratch scratch;
    auto const members = neighbours.members(block);
    copy_rows(
        members, system.particles.q, [](Index) { return 0.0; }, 2 * neighbours.range(), scratch.rows);
    add_pairs(potential, neighbours.pairs(block), size(members), scratch);
    for_each_member(members, [&](std::size_t local, Index i, Vec3 const&) {
      virial[system.particles.id[i]] += scratch.virial[local];
    });
  });
}

} // namespace

std::vector<double> virials(System const& system) {
  if (system.has_densities())
    return {};
  std::vector<double> virial(system.size());
  std::visit([&](auto const& potential) { add_virials(system, potential, virial); }, system.potential);
  return virial;
}

} // namespace mesobridge::sdpd
