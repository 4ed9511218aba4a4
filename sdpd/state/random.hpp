#pragma once
#include <array>
#include <cstdint>

namespace mesobridge::sdpd {

/// Philox4x32, the counter-based generator of Salmon, Moraes, Dror and Shaw (SC'11): 128 random bits as a
/// pure function of a 128-bit counter and a 64-bit key. Seven rounds are the fewest that its authors found to
/// pass all of TestU01's BigCrush; three more, the usual margin, would make a step 2 % longer.
struct Philox4x32 {
  using Counter = std::array<std::uint32_t, 4>;
  using Key = std::array<std::uint32_t, 2>;

  static constexpr std::uint32_t multiplier_0 = 0xD2511F53, multiplier_1 = 0xCD9E8D57;
  static constexpr std::uint32_t weyl_0 = 0x9E3779B9, weyl_1 = 0xBB67AE85;
  static constexpr int rounds = 7;

  template <int count = rounds>
  static constexpr Counter generate(Counter c, Key k) {
    for (int round = 0; round < count; ++round) {
      std::uint64_t const a = std::uint64_t{multiplier_0} * c[0];
      std::uint64_t const b = std::uint64_t{multiplier_1} * c[2];
      c = {static_cast<std::uint32_t>(b >> 32) ^ c[1] ^ k[0], static_cast<std::uint32_t>(b),
           static_cast<std::uint32_t>(a >> 32) ^ c[3] ^ k[1], static_cast<std::uint32_t>(a)};
      k[0] += weyl_0, k[1] += weyl_1;
    }
    return c;
  }
};

/// What a random number is for: streams never share a counter.
enum class Stream : std::uint32_t {
  fluctuation = 0,
  initial_velocities = 1,
  initial_positions = 2,
  initial_energies = 3,
  second_fluctuation = 4, ///< of a step that has two sweeps
  acceptance = 5,
  second_acceptance = 6,
  conduction = 7,
  second_conduction = 8,
  conduction_acceptance = 9,
  second_conduction_acceptance = 10,
  bath = 11,
  off_diagonal = 12, ///< of the matrix noise of the entropy form
  second_off_diagonal = 13,
  species = 14,       ///< which particles are of which
  initial_sites = 15, ///< of particles that start anywhere
  wall_friction = 20, ///< of the fluid with walls
  second_wall_friction = 21,
  wall_heat = 22,
  second_wall_heat = 23
};

/// The streams of one noise: of the first sweep of a step and of the second, if there is one.
struct SweepStream {
  Stream first, second;

  constexpr Stream of(bool second_sweep) const { return second_sweep ? second : first; }
};
inline constexpr SweepStream fluctuation_noise{Stream::fluctuation, Stream::second_fluctuation},
    acceptance_noise{Stream::acceptance, Stream::second_acceptance},
    conduction_noise{Stream::conduction, Stream::second_conduction},
    conduction_acceptance_noise{Stream::conduction_acceptance, Stream::second_conduction_acceptance},
    off_diagonal_noise{Stream::off_diagonal, Stream::second_off_diagonal},
    wall_friction_noise{Stream::wall_friction, Stream::second_wall_friction},
    wall_heat_noise{Stream::wall_heat, Stream::second_wall_heat};

/// Counter and key of the noise of one step: (seed, stream, step) are fixed, the two ids vary.
struct NoiseSource {
  Philox4x32::Key key;
  std::uint32_t step_low, step_high_and_stream;

  /// step < 2^56
  NoiseSource(std::uint64_t seed, Stream stream, std::uint64_t step)
      : key{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32)},
        step_low(static_cast<std::uint32_t>(step)),
        step_high_and_stream(static_cast<std::uint32_t>(step >> 32) << 8 |
                             static_cast<std::uint32_t>(stream)) {}
};

/// How many random bits come with the Gaussian numbers of a pair.
inline constexpr int spare_bits = 16;

/// Of the word that makes an angle, the first bit is the sign of its sine; the last eight are below single
/// precision's reach and serve elsewhere.
inline constexpr std::uint32_t sign_bit = 0x80000000, spare_of_turn = 0xff;

/// Three standard Gaussian numbers for a pair of ids (Box and Muller's method on Philox4x32), and random
/// bits that are independent of them, by the plain library functions: the reference for GaussianLanes.
struct Gaussians {
  std::array<double, 3> G;
  std::uint32_t bits;
};
Gaussians gaussians_and_bits_reference(NoiseSource const& source, std::uint32_t id_a, std::uint32_t id_b);
std::array<double, 3> gaussians_reference(NoiseSource const& source, std::uint32_t id_a, std::uint32_t id_b);

} // namespace mesobridge::sdpd
