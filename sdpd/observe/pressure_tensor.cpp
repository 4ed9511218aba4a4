#include "sdpd/observe/measurement.hpp"
#include "sdpd/system/masses.hpp"
#include "sdpd/system/pair_loop.hpp"

namespace mesobridge::sdpd {
namespace {

/// In the order of symmetric_tensor_components.
using Tensor = std::array<double, 6>;

/// Sums over pairs of strength * r_ij r_ij, the force being f_ij = strength * r_ij.
template <class Strength>
struct TensorOfPairs {
  Strength strength;
  std::array<Lanes, 6> sums{};

  [[gnu::always_inline]] Lanes operator()(PairLanes const& at) {
    Lanes const s = strength(at), sx = s * at.x, sy = s * at.y;
    sums[0] += sx * at.x, sums[1] += sy * at.y, sums[2] += s * at.z * at.z;
    sums[3] += sx * at.y, sums[4] += sx * at.z, sums[5] += sy * at.z;
    return s;
  }
};

/// The virial's tensor, sum over pairs of f_ij r_ij, by the law that make_strength(block) gives. Adds the
/// blocks' parts in their order.
template <class Quantity, class MakeStrength>
Tensor sum_over(System const& system, Gather<Quantity> const& gather, MakeStrength const& make_strength) {
  std::vector<Tensor> of_blocks(system.neighbours.grid().blocks().size());
  for_each_pair(
      system, gather, ToNobody{}, as_they_are,
      [&](std::size_t block) { return TensorOfPairs{make_strength(block)}; },
      [&](std::size_t block, auto const& law) {
        for (std::size_t c = 0; c < law.sums.size(); ++c)
          of_blocks[block][c] = sum(law.sums[c]);
      });
  Tensor total{};
  for (auto const& part : of_blocks)
    for (std::size_t c = 0; c < total.size(); ++c)
      total[c] += part[c];
  return total;
}

/// m_i m_j (P_i/rho_i^2 + P_j/rho_j^2) F_ij, Eq. (S9) of sdpd/README.md, or that of Eq. (S44).
template <class Kernel, class Masses>
struct StrengthOfPressures {
  Kernel const& kernel;
  Masses const& masses;

  [[gnu::always_inline]] Lanes operator()(PairLanes const& at) const {
    Lanes const strength = (at.of_i + at.of_j) * kernel.F(at.r, at.inverse_r);
    if constexpr (Masses::are_one)
      return strength;
    else
      return strength * masses_of(masses, at.pair).product();
  }
};

template <class Kernel, class Masses>
Tensor virial_of_pressures(System const& system, Kernel const& kernel, Masses) {
  auto const push = [&](Index i) { return push_of_pressure(system, i); };
  return sum_over(system, Gather{push, 0.5 * system.neighbours.range()}, [&](std::size_t block) {
    thread_local Masses masses;
    masses.copy_in(system, system.neighbours.members(block));
    return StrengthOfPressures<Kernel, Masses>{kernel, masses};
  });
}

Tensor virial_of_potential(System const&, NoPotential const&) {
  return {};
}
template <class Potential>
Tensor virial_of_potential(System const& system, Potential const& potential) {
  auto const strength = [&potential](PairLanes const& at) [[gnu::always_inline]] {
    Lanes const zero{}; // the phantom pair lies beyond the cut-off
    return at.r < potential.cutoff() ? potential(at.r, at.inverse_r).strength : zero;
  };
  return sum_over(system, Gather{no_quantity, 2 * system.neighbours.range()},
                  [&](std::size_t) { return strength; });
}

Tensor virial(System const& system) {
  Tensor sum{};
  if (system.has_densities())
    with_density_weights(system, [&](auto masses) {
      sum = std::visit([&](auto const& kernel) { return virial_of_pressures(system, kernel, masses); },
                       system.kernel);
    });
  else
    sum = std::visit([&](auto const& potential) { return virial_of_potential(system, potential); },
                     system.potential);
  return sum;
}

/// sum m u u of the velocities u about that of the whole, N/(N-1) times, as T_kin counts: in the order of the
/// ids.
Tensor motion(Particles const& particles) {
  std::size_t const n = particles.size();
  std::vector<Index> place(n);
  for (std::size_t i = 0; i < n; ++i)
    place[particles.id[i]] = static_cast<Index>(i);
  Vec3 momentum;
  double mass = 0;
  for (Index const i : place)
    momentum += particles.p[i], mass += particles.mass_of(i);
  Tensor sum{};
  for (Index const i : place) {
    double const m = particles.mass_of(i);
    Vec3 const u = particles.p[i] / m - momentum / mass;
    sum[0] += m * u.x * u.x, sum[1] += m * u.y * u.y, sum[2] += m * u.z * u.z;
    sum[3] += m * u.x * u.y, sum[4] += m * u.x * u.z, sum[5] += m * u.y * u.z;
  }
  for (double& of_one : sum)
    of_one *= static_cast<double>(n) / static_cast<double>(n - 1);
  return sum;
}

std::vector<double> values(System const& system) {
  auto const of_motion = motion(system.particles), of_forces = virial(system);
  std::vector<double> P(of_motion.size());
  for (std::size_t c = 0; c < P.size(); ++c)
    P[c] = (of_motion[c] + of_forces[c]) / system.box.volume();
  return P;
}

/// A fluid at rest pushes alike in all directions.
std::vector<std::optional<double>> at_equilibrium(SetState const& set) {
  return {set.P, set.P, set.P, 0, 0, 0};
}

} // namespace

/// Eq. (S34) of sdpd/README.md, at the positions at which the forces were found last.
Measurement pressure_tensor() {
  return {.name = "pressure_tensor",
          .meaning = "minus the stress: sum p p/mV of the motion and sum f r/V of the conservative forces of "
                     "pairs, compression > 0; a third of its trace is P. Friction and noise are not in it",
          .components = symmetric_tensor_components,
          .dimension = Dimension::pressure,
          .exists = without_walls,
          .values = values,
          .pair_passes = 1,
          .expected = at_equilibrium};
}

} // namespace mesobridge::sdpd
