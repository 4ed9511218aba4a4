#include "sdpd/boundary/mirror.hpp"
#include "sdpd/conservative/conservative.hpp"
#include "sdpd/neighbours/for_each_block.hpp"
#include "sdpd/neighbours/select_pairs.hpp"
#include "sdpd/system/masses.hpp"

namespace mesobridge::sdpd {
namespace {

struct Scratch {
  std::vector<Row> rows;
  SelectionScratch selection;
  std::vector<double> W, rho;
};

template <class Kernel, class Masses>
void add_densities(Kernel const& kernel, Masses const& mass, std::span<LocalPair const> pairs,
                   std::size_t particles, Scratch& scratch) {
  std::size_t const count = pairs.size();
  scratch.W.resize(count + lane_count);
  for (std::size_t k = 0; k < count; k += lane_count)
    store(kernel.W(DistanceLanes(load<Lanes>(&scratch.selection.r2[k])).r), &scratch.W[k]);
  scratch.rho.assign(particles, 0);
  double* const rho = scratch.rho.data();
  for (std::size_t k = 0; k < count; ++k) {
    rho[pairs[k].i] += mass[pairs[k].j] * scratch.W[k];
    rho[pairs[k].j] += mass[pairs[k].i] * scratch.W[k];
  }
}

void set_self_densities(System& system, UnitMasses) {
  set_all(system, system.particles.rho, system.self_density);
}
void set_self_densities(System& system, OwnMasses) {
  auto& particles = system.particles;
  for_each_index(particles.size(), system.threads,
                 [&](std::size_t i) { particles.rho[i] = particles.mass[i] * system.self_density; });
}

template <class Kernel, class Masses>
void find_pairs_and_densities(System& system, Kernel const& kernel, Masses) {
  auto& particles = system.particles;
  auto& neighbours = system.neighbours;
  double const out_of_range = 2 * neighbours.range();
  set_self_densities(system, Masses{});
  for_each_block(neighbours.grid(), system.threads, [&](std::size_t block) {
    thread_local Scratch scratch;
    thread_local Masses masses;
    auto const members = neighbours.members(block);
    std::size_t const n = size(members);
    copy_rows(
        members, particles.q, [](Index) { return 0.0; }, out_of_range, scratch.rows);
    select_pairs_and_distances(neighbours, block, scratch.rows, scratch.selection);
    masses.copy_in(system, members);
    add_densities(kernel, masses, neighbours.pairs(block), n, scratch);
    for_each_member(members,
                    [&](std::size_t local, Index i, Vec3 const&) { particles.rho[i] += scratch.rho[local]; });
  });
}

} // namespace

void find_pairs_and_densities(System& system) {
  with_density_weights(system, [&](auto masses) {
    std::visit([&](auto const& kernel) { find_pairs_and_densities(system, kernel, masses); }, system.kernel);
  });
  add_wall_densities(system);
  auto& particles = system.particles;
  if (!particles.mass.empty() && system.density_sum == DensitySum::number)
    for_each_index(system.size(), system.threads,
                   [&](std::size_t i) { particles.rho[i] *= particles.mass[i]; });
}

} // namespace mesobridge::sdpd
