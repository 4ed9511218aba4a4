#include "sdpd/boundary/mirror.hpp"
#include "sdpd/conservative/conservative.hpp"
#include "sdpd/system/masses.hpp"
#include "sdpd/system/pair_loop.hpp"
#include <numeric>

namespace mesobridge::sdpd {
namespace {

/// The force of pressure, f_ij = m_i m_j (P_i/rho_i^2 + P_j/rho_j^2) F(r_ij) r_ij with F = -W'/r, or that of
/// densities that count neighbours (sdpd/README.md, Eq. (S44)), and its virial.
template <class Kernel, class Masses>
struct PressureForce {
  Kernel const& kernel;
  Masses const& masses;
  Lanes virial{};

  [[gnu::always_inline]] Lanes operator()(PairLanes const& at) {
    Lanes strength = (at.of_i + at.of_j) * kernel.F(at.r, at.inverse_r);
    if constexpr (!Masses::are_one)
      strength *= masses_of(masses, at.pair).product();
    virial += strength * at.r2;
    return strength;
  }
};

template <class Kernel, class Masses>
void find_forces(System& system, Kernel const& kernel, Masses) {
  auto& particles = system.particles;
  system.block_virial.resize(system.neighbours.grid().blocks().size());
  set_all(system, particles.f, Vec3{});
  auto const push = [&](Index i) { return push_of_pressure(system, i); };
  for_each_pair(
      system, Gather{push, 0.5 * system.neighbours.range()}, EqualAndOpposite{particles.f}, as_they_are,
      [&](std::size_t block) {
        thread_local Masses masses;
        masses.copy_in(system, system.neighbours.members(block));
        return PressureForce<Kernel, Masses>{kernel, masses};
      },
      [&](std::size_t block, auto const& law) { system.block_virial[block] = sum(law.virial); });
  system.virial = std::accumulate(system.block_virial.begin(), system.block_virial.end(), 0.0);
}

} // namespace

void find_forces(System& system) {
  with_density_weights(system, [&](auto masses) {
    std::visit([&](auto const& kernel) { find_forces(system, kernel, masses); }, system.kernel);
  });
  add_wall_forces(system);
}

} // namespace mesobridge::sdpd
