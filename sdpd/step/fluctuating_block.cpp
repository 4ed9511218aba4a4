#include "sdpd/step/fluctuating_block.hpp"

namespace mesobridge::sdpd {
namespace {

template <class Kernel>
void prepare_directions(std::vector<Row> const& rows, std::size_t particles, Kernel const& kernel,
                        std::span<LocalPair const> pairs, PairInputs& inputs) {
  for_each_group(pairs, particles, [&](LocalPair const* pair, std::size_t first, std::size_t) {
    RowLanes const a = load_rows([&](std::size_t l) { return &rows[pair[l].i]; });
    RowLanes const b = load_rows([&](std::size_t l) { return &rows[pair[l].j]; });
    Lanes const x = a[0] - b[0], y = a[1] - b[1], z = a[2] - b[2];
    auto const [r, inverse_r] = DistanceLanes(x * x + y * y + z * z);
    store(to_float(x * inverse_r), &inputs.e_x[first]);
    store(to_float(y * inverse_r), &inputs.e_y[first]);
    store(to_float(z * inverse_r), &inputs.e_z[first]);
    store(to_float(kernel.F(r, inverse_r) * (a[3] * b[3])), &inputs.chi[first]);
  });
}

/// The smaller and the larger id of noise_lanes pairs, and the sign that turns the noise from the former to
/// the latter.
struct PairKeys {
  alignas(64) std::array<std::uint32_t, noise_lanes> low, high;
  alignas(64) std::array<float, noise_lanes> sign;

  void set(LocalPair const* pairs, std::uint32_t const* ids) {
    for (std::size_t lane = 0; lane < noise_lanes; ++lane) {
      std::uint32_t const i = ids[pairs[lane].i], j = ids[pairs[lane].j];
      low[lane] = std::min(i, j), high[lane] = std::max(i, j);
      sign[lane] = i < j ? 1.0f : -1.0f;
    }
  }
};

void prepare_noise(std::vector<std::uint32_t> const& ids, std::span<LocalPair const> pairs,
                   NoiseSource const& source, PairInputs& inputs) {
  PairKeys keys;
  GaussianLanes noise;
  for (std::size_t first = 0; first < pairs.size(); first += noise_lanes) {
    if (first + noise_lanes <= pairs.size())
      keys.set(&pairs[first], ids.data());
    else {
      std::array<LocalPair, noise_lanes> last{};
      std::copy(pairs.begin() + static_cast<std::ptrdiff_t>(first), pairs.end(), last.begin());
      keys.set(last.data(), ids.data());
    }
    gaussians(source, keys.low.data(), keys.high.data(), noise);
    for (std::size_t lane = 0; lane < noise_lanes; ++lane) {
      inputs.G_x[first + lane] = keys.sign[lane] * noise.x[lane];
      inputs.G_y[first + lane] = keys.sign[lane] * noise.y[lane];
      inputs.G_z[first + lane] = keys.sign[lane] * noise.z[lane];
      inputs.bits[first + lane] = noise.bits[lane];
    }
  }
}

} // namespace

void FluctuatingBlock::copy_in(System const& system, std::size_t block) {
  auto const& from = system.particles;
  members_ = system.neighbours.members(block);
  size_ = sdpd::size(members_);
  copy_rows(
      members_, from.q, [&](Index i) { return 1 / from.rho[i]; }, 0.5 * system.neighbours.range(), rows_);
  particles_.resize(size_ + 2), ids_.resize(size_);
  for_each_member(members_, [&](std::size_t local, Index i, Vec3 const&) {
    particles_[local] = {from.p[i], system.energy_gain[i], from.caloric[i]};
    ids_[local] = from.id[i];
  });
  FluctuatingParticle const phantom{{}, 0, {.T_0 = 1, .inverse_C_0 = 1, .curvature = 0, .limit = 1}};
  particles_[size_] = particles_[size_ + 1] = phantom;
}

void FluctuatingBlock::copy_out(System& system) const {
  auto& to = system.particles;
  for_each_member(members_, [&](std::size_t local, Index i, Vec3 const&) {
    to.p[i] = particles_[local].p;
    system.energy_gain[i] = particles_[local].u;
  });
}

bool FluctuatingBlock::renew(System& system, std::size_t local, Failure& failure) {
  Index const i = global_index(members_, local);
  auto& [p, u, caloric] = particles_[local];
  double& eps = system.particles.eps[i];
  eps += u, u = 0;
  try {
    caloric = system.thermodynamics->caloric(eps, system.particles.rho[i], caloric.T_0);
    system.particles.caloric[i] = caloric;
    return true;
  } catch (std::exception const& error) {
    failure.report(system.particles.id[i],
                   fmt::format("fluctuation and dissipation took its internal energy to {:.6g} (in K "
                               "k_B T): {}; take a shorter time step or larger particles",
                               eps, error.what()));
    return false;
  }
}

void prepare_pairs(FluctuatingBlock const& block, AnyKernel const& kernel, std::span<LocalPair const> pairs,
                   NoiseSource const& source, PairInputs& inputs) {
  inputs.resize(pairs.size() + noise_lanes);
  std::visit([&](auto const& of) { prepare_directions(block.rows(), block.size(), of, pairs, inputs); },
             kernel);
  prepare_noise(block.ids(), pairs, source, inputs);
}

} // namespace mesobridge::sdpd
