#pragma once
#include "sdpd/block_copy.hpp"
#include "sdpd/random.hpp"
#include "sdpd/system.hpp"

namespace mesobridge::sdpd {

/// What fluctuation and dissipation change of a particle, p and the energy u gained since its caloric
/// expansion began, and what they need of it: one cache line.
struct alignas(64) FluctuatingParticle {
  Vec3 p;
  double u;
  Caloric caloric;
};
static_assert(sizeof(FluctuatingParticle) == sizeof(Lanes));

/// What a pair's step needs and does not depend on the pairs before it: direction e = r/|r|,
/// chi = F/(rho_i rho_j) and noise, as one array each.
struct PairInputs {
  std::vector<float> e_x, e_y, e_z, chi, G_x, G_y, G_z;
  std::vector<std::uint32_t> bits; ///< spare random bits of the noise

  void resize(std::size_t count) {
    for (auto* values : {&e_x, &e_y, &e_z, &chi, &G_x, &G_y, &G_z})
      values->resize(count);
    bits.resize(count);
  }
};

/// A block's particles in a private copy while its pairs are swept.
class FluctuatingBlock {
 public:
  void copy_in(System const& system, std::size_t block);
  /// The new momenta and energies.
  void copy_out(System& system) const;

  std::size_t size() const { return size_; }
  std::vector<FluctuatingParticle>& particles() { return particles_; }
  /// Positions with 1/rho.
  std::vector<Row> const& rows() const { return rows_; }
  std::vector<std::uint32_t> const& ids() const { return ids_; }
  BlockMembers const& members() const { return members_; }
  /// Where the particle is in memory.
  Index index(std::size_t local) const { return global_index(members_, local); }

  /// Begins a new caloric expansion at the particle's energy; false, and a report to `failure`, when that
  /// energy has no temperature.
  bool renew(System& system, std::size_t local, Failure& failure);

 private:
  BlockMembers members_;
  std::size_t size_ = 0;
  std::vector<FluctuatingParticle> particles_;
  std::vector<Row> rows_;
  std::vector<std::uint32_t> ids_;
};

/// Directions, chi and noise of some pairs of a block. The noise points from the smaller to the larger id.
/// Lanes past the last pair hold finite numbers.
void prepare_pairs(FluctuatingBlock const& block, AnyKernel const& kernel, std::span<LocalPair const> pairs,
                   NoiseSource const& source, PairInputs& inputs);

} // namespace mesobridge::sdpd
