#include "sdpd/fluctuation/fluctuating_block.hpp"
#include "sdpd/fluctuation/scaled_velocity.hpp"
#include "sdpd/state/random_lanes.hpp"
#include <algorithm>
#include <bit>
#include <optional>

namespace mesobridge::sdpd {
namespace {

template <Transverse across, PairNoise noise, class Weights>
void prepare_directions(std::vector<FloatRow> const& rows, std::size_t particles, Weights const& weights,
                        std::span<LocalPair const> pairs, PairInputs& inputs) {
  // A distance beside the range may round past it, where some kernels are below zero. Pairs with one weight
  // for both directions keep some, because the Metropolis test asks for a density of their noise.
  auto const least = constant<WideFloats>(across == Transverse::common ? 1e-30 : 0);
  for_each_group<wide_count>(pairs, particles, [&](LocalPair const* pair, std::size_t first, std::size_t) {
    auto const a = load_wide_rows([&](std::size_t l) { return &rows[pair[l].i]; });
    auto const b = load_wide_rows([&](std::size_t l) { return &rows[pair[l].j]; });
    WideFloats const x = a[0] - b[0], y = a[1] - b[1], z = a[2] - b[2];
    auto const [r, inverse_r] = WideDistances(x * x + y * y + z * z);
    if constexpr (noise != PairNoise::flow) {
      store(x * inverse_r, &inputs.e_x[first]);
      store(y * inverse_r, &inputs.e_y[first]);
      store(z * inverse_r, &inputs.e_z[first]);
    }
    auto const weight = weights(r, inverse_r, a[3], b[3]);
    store(weight.par < least ? least : weight.par, &inputs.weight[first]);
    if constexpr (across == Transverse::own)
      store(weight.perp < least ? least : weight.perp, &inputs.weight_across[first]);
  });
}

/// The random bits of sixteen pairs.
struct PairBits {
  NoiseLanes::Word word;
  WideFloats sign; ///< +1 where the pair's first particle has the smaller id, else -1

  [[gnu::always_inline]] PairBits(std::uint32_t const* ids, LocalPair const* pairs, NoiseLanes const& source)
      : PairBits(load<WideBits>(pairs), ids, source) {}

 private:
  /// i in the lower half of each word, j in the upper one
  [[gnu::always_inline]] PairBits(WideBits const& places, std::uint32_t const* ids, NoiseLanes const& source)
      : PairBits(gather(ids, places & 0xffffu), gather(ids, places >> 16), source) {}
  [[gnu::always_inline]] PairBits(WideBits const& a, WideBits const& b, NoiseLanes const& source)
      : word(source.generate(a < b ? a : b, a < b ? b : a)) {
    auto const plus = constant<WideFloats>(1);
    sign = a < b ? plus : -plus;
  }
};
static_assert(sizeof(WideBits) == wide_count * sizeof(LocalPair) &&
              std::endian::native == std::endian::little);

template <PairNoise noise>
[[gnu::always_inline]] inline void store_noise(PairBits const& bits, PairInputs& inputs, std::size_t first) {
  std::conditional_t<noise == PairNoise::vector, GaussianLanes, OneGaussianLanes> const G(bits.word);
  store(G.bits, &inputs.bits[first]);
  if constexpr (noise == PairNoise::along) {
    store(G.x, &inputs.G_x[first]);
  } else {
    store(bits.sign * G.x, &inputs.G_x[first]);
  }
  if constexpr (noise == PairNoise::vector) {
    store(bits.sign * G.y, &inputs.G_y[first]);
    store(bits.sign * G.z, &inputs.G_z[first]);
  }
}

/// Bits first and Gaussian numbers from them afterwards, for some groups at a time: two short loops, of which
/// the processor works on several turns at once, in place of a long one.
template <PairNoise noise>
void prepare_noise(std::vector<std::uint32_t> const& ids, std::span<LocalPair const> pairs,
                   NoiseLanes const& source, PairInputs& inputs) {
  thread_local std::vector<PairBits> bits;
  bits.clear();
  std::size_t k = 0;
  for (; k + wide_count <= pairs.size(); k += wide_count)
    bits.emplace_back(ids.data(), &pairs[k], source);
  if (k < pairs.size()) {
    std::array<LocalPair, wide_count> last{};
    std::copy(pairs.begin() + static_cast<std::ptrdiff_t>(k), pairs.end(), last.begin());
    bits.emplace_back(ids.data(), last.data(), source);
  }
  for (std::size_t group = 0; group < bits.size(); ++group)
    store_noise<noise>(bits[group], inputs, group * wide_count);
}

/// The weights of unit masses become those of the pairs' masses.
template <class Law>
void scale_weights(Law const& law, OwnMasses const& mass, std::span<LocalPair const> pairs,
                   PairInputs& inputs) {
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    auto const factor =
        static_cast<float>(weight_factor(law, PairMasses<double>{mass[pairs[k].i], mass[pairs[k].j]}));
    inputs.weight[k] *= factor;
    if constexpr (Law::across == Transverse::own)
      inputs.weight_across[k] *= factor;
  }
}

/// The noise of a law without any, which is not generated: that would take half of the sweep's time.
void prepare_silence(PairInputs& inputs) {
  for (auto* values : {&inputs.G_x, &inputs.G_y, &inputs.G_z})
    std::ranges::fill(*values, 0.0f);
  std::ranges::fill(inputs.bits, 0u);
}

} // namespace

void BlockGeometry::copy_geometry(System const& system, std::size_t block) {
  auto const& from = system.particles;
  members_ = system.neighbours.members(block);
  size_ = sdpd::size(members_);
  double const in_range = 0.5 * system.neighbours.range();
  if (from.rho.empty())
    copy_rows(
        members_, from.q, [](Index) { return 0.0; }, in_range, rows_);
  else
    copy_rows(
        members_, from.q, [&](Index i) { return 1 / from.rho[i]; }, in_range, rows_);
  ids_.resize(size_);
  for_each_member(members_, [&](std::size_t local, Index i, Vec3 const&) { ids_[local] = from.id[i]; });
  has_masses_ = !from.mass.empty();
  if (has_masses_)
    std::get<OwnMasses>(masses_).copy_in(system, members_);
}

void FluctuatingBlock::copy_in(System const& system, std::size_t block) {
  auto const& from = system.particles;
  copy_geometry(system, block);
  particles_.resize(size() + 2);
  for_each_member(members(), [&](std::size_t local, Index i, Vec3 const&) {
    particles_[local] = {from.p[i], system.energy_gain[i], from.caloric[i]};
  });
  FluctuatingParticle const phantom{{}, 0, {.T_0 = 1, .inverse_C_0 = 1, .curvature = 0, .limit = 1}};
  particles_[size()] = particles_[size() + 1] = phantom;
}

void FluctuatingBlock::copy_out(System& system) const {
  auto& to = system.particles;
  for_each_member(members(), [&](std::size_t local, Index i, Vec3 const&) {
    to.p[i] = particles_[local].p;
    system.energy_gain[i] = particles_[local].u;
  });
}

namespace {

/// The caloric expansion at the energy eps; none, and a report to `failure`, when it has no temperature.
std::optional<Caloric> expansion(System const& system, Index i, double eps, double T_guess,
                                 Failure& failure) {
  try {
    return system.thermodynamics->caloric(system.particles, i, eps, T_guess);
  } catch (std::exception const& error) {
    failure.report(
        system.particles.id[i],
        fmt::format("what it exchanged with its neighbours took its internal energy to {:.6g} (in K "
                    "k_B T): {}; take a shorter time step or larger particles",
                    eps, error.what()));
    return std::nullopt;
  }
}

} // namespace

bool FluctuatingBlock::renew(System& system, std::size_t local, bool extrapolate, Failure& failure) {
  Index const i = index(local);
  auto& [p, u, caloric] = particles_[local];
  double const T_guess = extrapolate ? caloric.T(u) : caloric.T_0;
  double& eps = system.particles.eps[i];
  eps += u, u = 0;
  auto const renewed = expansion(system, i, eps, T_guess, failure);
  if (renewed)
    system.particles.caloric[i] = caloric = *renewed;
  return renewed.has_value();
}

void ConstantCapacityBlock::copy_in(System const& system, std::size_t block) {
  auto const& from = system.particles;
  copy_geometry(system, block);
  C_ = system.thermodynamics->constant_heat_capacity().value();
  rows_.resize(size() + 2);
  for_each_member(members(), [&](std::size_t local, Index i, Vec3 const&) {
    Vec3 const& p = from.p[i];
    rows_[local] = Row{p.x, p.y, p.z, C_ * from.caloric[i].T_0 + system.energy_gain[i]};
  });
  rows_[size()] = rows_[size() + 1] = Row{0, 0, 0, C_};
}

void ConstantCapacityBlock::copy_out(System& system) const {
  auto& to = system.particles;
  for_each_member(members(), [&](std::size_t local, Index i, Vec3 const&) {
    Row const& row = rows_[local];
    to.p[i] = {row[0], row[1], row[2]};
    system.energy_gain[i] = row[3] - C_ * to.caloric[i].T_0;
  });
}

FluctuatingParticle ConstantCapacityBlock::particle(System const& system, std::size_t local) const {
  Row const& row = rows_[local];
  Caloric const& caloric = system.particles.caloric[index(local)];
  return {{row[0], row[1], row[2]}, row[3] - C_ * caloric.T_0, caloric};
}

void ConstantCapacityBlock::set_particle(System const& system, std::size_t local,
                                         FluctuatingParticle const& particle) {
  auto const& [p, u, caloric] = particle;
  rows_[local] = Row{p.x, p.y, p.z, C_ * system.particles.caloric[index(local)].T_0 + u};
}

bool ConstantCapacityBlock::renew(System& system, std::size_t local, bool, Failure& failure) {
  auto const [p, u, caloric] = particle(system, local);
  Index const i = index(local);
  return expansion(system, i, system.particles.eps[i] + u, caloric.T_0, failure).has_value();
}

void MomentumBlock::copy_in(System const& system, std::size_t block) {
  copy_geometry(system, block);
  momenta_.assign(size() + 2, Row{});
  for_each_member(members(), [&](std::size_t local, Index i, Vec3 const&) {
    Vec3 const& p = system.particles.p[i];
    momenta_[local] = Row{p.x, p.y, p.z, 0};
  });
}

void MomentumBlock::copy_out(System& system) const {
  for_each_member(members(), [&](std::size_t local, Index i, Vec3 const&) {
    Row const& p = momenta_[local];
    system.particles.p[i] = {p[0], p[1], p[2]};
  });
}

template <class Law>
void prepare_pairs(System const& system, Law const& law, BlockGeometry const& block,
                   std::span<LocalPair const> pairs, NoiseSource const& source, PairInputs& inputs) {
  inputs.resize(pairs.size() + wide_count, Law::across, Law::noise);
  with_weights(system.kernel, law, [&](auto const& weights) {
    prepare_directions<Law::across, Law::noise>(block.rows(), block.size(), weights, pairs, inputs);
  });
  if (!system.particles.mass.empty())
    scale_weights(law, block.masses(), pairs, inputs);
  if (law.boltzmann == 0)
    prepare_silence(inputs);
  else
    prepare_noise<Law::noise>(block.ids(), pairs, NoiseLanes(source), inputs);
}

template void prepare_pairs(System const&, SdpdLaw const&, BlockGeometry const&, std::span<LocalPair const>,
                            NoiseSource const&, PairInputs&);
template void prepare_pairs(System const&, SdpdConduction const&, BlockGeometry const&,
                            std::span<LocalPair const>, NoiseSource const&, PairInputs&);
template void prepare_pairs(System const&, DpdeConduction const&, BlockGeometry const&,
                            std::span<LocalPair const>, NoiseSource const&, PairInputs&);
template void prepare_pairs(System const&, DpdeLaw<Transverse::none> const&, BlockGeometry const&,
                            std::span<LocalPair const>, NoiseSource const&, PairInputs&);
template void prepare_pairs(System const&, DpdeLaw<Transverse::own> const&, BlockGeometry const&,
                            std::span<LocalPair const>, NoiseSource const&, PairInputs&);
template void prepare_pairs(System const&, DpdLaw<Transverse::none> const&, BlockGeometry const&,
                            std::span<LocalPair const>, NoiseSource const&, PairInputs&);
template void prepare_pairs(System const&, DpdLaw<Transverse::own> const&, BlockGeometry const&,
                            std::span<LocalPair const>, NoiseSource const&, PairInputs&);

} // namespace mesobridge::sdpd
