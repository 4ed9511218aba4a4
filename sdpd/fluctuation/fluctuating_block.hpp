#pragma once
#include "sdpd/neighbours/block_copy.hpp"
#include "sdpd/state/random.hpp"
#include "sdpd/system/masses.hpp"
#include "sdpd/system/system.hpp"

namespace mesobridge::sdpd {

/// What fluctuation and dissipation change of a particle, p and the energy u gained since its caloric
/// expansion began, and what they need of it: one cache line.
struct alignas(64) FluctuatingParticle {
  Vec3 p;
  double u;
  Caloric caloric;
};
static_assert(sizeof(FluctuatingParticle) == sizeof(Lanes));

/// What a pair's step needs and does not depend on the pairs before it: direction e = r/|r|, the weight of
/// its friction (SDPD: chi = F/(rho_i rho_j)) and noise, as one array each.
struct PairInputs {
  std::vector<float> e_x, e_y, e_z, weight; ///< directions not where heat alone flows
  std::vector<float> G_x, G_y, G_z;         ///< the first alone where the noise is one number
  std::vector<float> weight_across;         ///< for laws with Transverse::own
  std::vector<std::uint32_t> bits;          ///< spare random bits of the noise

  void resize(std::size_t count, Transverse across, PairNoise noise) {
    for (auto* values : {&e_x, &e_y, &e_z, &weight, &G_x})
      values->resize(count);
    if (noise == PairNoise::vector)
      G_y.resize(count), G_z.resize(count);
    if (across == Transverse::own)
      weight_across.resize(count);
    bits.resize(count);
  }
};

/// Who is in a block, and where, while its pairs are swept.
class BlockGeometry {
 public:
  std::size_t size() const { return size_; }
  /// Positions relative to the first particle, with 1/rho, where there are densities. Single precision is
  /// enough for directions, which friction and noise share, and weights.
  std::vector<FloatRow> const& rows() const { return rows_; }
  std::vector<std::uint32_t> const& ids() const { return ids_; }
  BlockMembers const& members() const { return members_; }
  /// The masses, of the kind that the fluid's particles have.
  template <class Masses = OwnMasses>
  Masses const& masses() const {
    return std::get<Masses>(masses_);
  }
  PairMasses<double> masses_of_pair(LocalPair pair) const {
    auto mass = [&](std::size_t local) { return has_masses_ ? masses()[local] : 1; };
    return {mass(pair.i), mass(pair.j)};
  }
  /// Where the particle is in memory.
  Index index(std::size_t local) const { return global_index(members_, local); }

 protected:
  void copy_geometry(System const& system, std::size_t block);

 private:
  BlockMembers members_;
  std::size_t size_ = 0;
  std::vector<FloatRow> rows_;
  std::vector<std::uint32_t> ids_;
  std::tuple<UnitMasses, OwnMasses> masses_;
  bool has_masses_ = false;
};

/// A block's particles with energies in a private copy.
class FluctuatingBlock : public BlockGeometry {
 public:
  void copy_in(System const& system, std::size_t block);
  /// The new momenta and energies.
  void copy_out(System& system) const;

  std::vector<FluctuatingParticle>& particles() { return particles_; }

  FluctuatingParticle const& particle(System const&, std::size_t local) const { return particles_[local]; }
  void set_particle(System const&, std::size_t local, FluctuatingParticle const& particle) {
    particles_[local] = particle;
  }

  /// Whether the particle's expansion reaches its energy, and makes it a temperature > 0.
  bool has_temperature(std::size_t local) const {
    auto const& [p, u, caloric] = particles_[local];
    return caloric.in_reach(u) && caloric.T(u) > 0;
  }
  /// Begins a new caloric expansion at the particle's energy; false, and a report to `failure`, when that
  /// energy has no temperature. That is looked for from where the old expansion extrapolates to, or from
  /// where it began (whose bits runs by SSA keep).
  bool renew(System& system, std::size_t local, bool extrapolate, Failure& failure);

 private:
  std::vector<FluctuatingParticle> particles_;
};

/// The same of particles that have masses of their own.
class OwnMassBlock : public FluctuatingBlock {};

/// A block's particles of one constant heat capacity C in a private copy: rows of p and C T, half of what
/// particles with expansions of their own take.
class ConstantCapacityBlock : public BlockGeometry {
 public:
  void copy_in(System const& system, std::size_t block);
  void copy_out(System& system) const;

  std::vector<Row>& particles() { return rows_; }
  double heat_capacity() const { return C_; }

  /// The particle as one with an expansion of its own.
  FluctuatingParticle particle(System const& system, std::size_t local) const;
  void set_particle(System const& system, std::size_t local, FluctuatingParticle const& particle);

  bool has_temperature(std::size_t local) const { return rows_[local][3] > 0; }
  /// Reports why it has none.
  bool renew(System& system, std::size_t local, bool extrapolate, Failure& failure);

 private:
  std::vector<Row> rows_;
  double C_ = 0;
};

/// A block's particles without energies in a private copy: momenta as rows.
class MomentumBlock : public BlockGeometry {
 public:
  void copy_in(System const& system, std::size_t block);
  void copy_out(System& system) const;

  std::vector<Row>& particles() { return momenta_; }

 private:
  std::vector<Row> momenta_;
};

/// The block that a law's sweeps work in.
template <class Law>
using BlockOf = std::conditional_t<Law::has_energies, FluctuatingBlock, MomentumBlock>;

/// Calls f(weights) once, where weights(r, 1/r, a, b) are the PairWeights at distance r of two particles with
/// the last quantities a and b of their rows; for lanes and for numbers.
template <class Law, class F>
requires std::is_same_v<Law, SdpdLaw> || std::is_same_v<Law, SdpdConduction>
void with_weights(AnyKernel const& any, Law const&, F const& f) {
  std::visit(
      [&](auto const& kernel) {
        f([&]<class X>(X const& r, X const& inverse_r, X const& a, X const& b) [[gnu::always_inline]] {
          X const chi = kernel.F(r, inverse_r) * (a * b);
          return PairWeights<X>{chi, chi};
        });
      },
      any);
}
template <class Law, class F>
void with_weights(AnyKernel const&, Law const& law, F const& f) {
  std::visit(
      [&](auto const& shape) {
        f([&]<class X>(X const& r, X const&, X const&, X const&) [[gnu::always_inline]] { return shape(r); });
      },
      law.shape);
}

/// Directions, weights and noise of some pairs of a block. Where the particles have masses of their own, the
/// weights are those of the pairs' scaled velocities (scaled_velocity.hpp). Lanes past the last pair hold
/// finite numbers.
template <class Law>
void prepare_pairs(System const& system, Law const& law, BlockGeometry const& block,
                   std::span<LocalPair const> pairs, NoiseSource const& source, PairInputs& inputs);

} // namespace mesobridge::sdpd
