#include "sdpd/random.hpp"
#include <bit>
#include <cmath>
#include <numbers>

namespace mesobridge::sdpd {
namespace {

/// ln(u) for 0 < u <= 1, relative error 1e-7: split u = m 2^e with m in [sqrt(1/2), sqrt(2)), then the
/// polynomial of the Cephes library (S. Moshier) in m - 1.
inline float log_unit(float u) {
  std::uint32_t const bits = std::bit_cast<std::uint32_t>(u);
  // Adding the gap between 1 and sqrt(1/2) moves the exponent's boundary to sqrt(1/2).
  std::uint32_t const shifted = bits + (0x3f800000u - 0x3f3504f3u);
  float const exponent = static_cast<float>(static_cast<std::int32_t>(shifted >> 23) - 127);
  float const x = std::bit_cast<float>((shifted & 0x007fffffu) + 0x3f3504f3u) - 1.0f;
  float const z = x * x;
  float p = 7.0376836292e-2f;
  p = p * x - 1.1514610310e-1f;
  p = p * x + 1.1676998740e-1f;
  p = p * x - 1.2420140846e-1f;
  p = p * x + 1.4249322787e-1f;
  p = p * x - 1.6668057665e-1f;
  p = p * x + 2.0000714765e-1f;
  p = p * x - 2.4999993993e-1f;
  p = p * x + 3.3333331174e-1f;
  float const y = x * z * p - 2.12194440e-4f * exponent - 0.5f * z;
  return x + y + 0.693359375f * exponent;
}

struct SineCosine {
  float sine, cosine;
};

/// sin and cos of pi * angle / 2^31 for a signed 32-bit angle: the nearest quarter turn is taken off exactly
/// in integers, the rest by the Cephes polynomials on [-pi/4, pi/4].
inline SineCosine sine_cosine(std::uint32_t angle) {
  std::uint32_t const quadrant = (angle + 0x20000000u) >> 30;
  std::int32_t const rest = static_cast<std::int32_t>(angle - (quadrant << 30));
  float const x = static_cast<float>(rest) * static_cast<float>(std::numbers::pi / 2147483648.0);
  float const z = x * x;
  float const s = x + x * z * (-1.6666654611e-1f + z * (8.3321608736e-3f - z * 1.9515295891e-4f));
  float const c = 1.0f - 0.5f * z +
                  z * z * (4.166664568298827e-2f + z * (-1.388731625493765e-3f + z * 2.443315711809948e-5f));
  bool const odd = quadrant & 1u;
  float const sine = odd ? c : s, cosine = odd ? s : c;
  std::uint32_t const sine_sign = (quadrant & 2u) << 30, cosine_sign = ((quadrant + 1u) & 2u) << 30;
  return {std::bit_cast<float>(std::bit_cast<std::uint32_t>(sine) ^ sine_sign),
          std::bit_cast<float>(std::bit_cast<std::uint32_t>(cosine) ^ cosine_sign)};
}

/// A uniform number in (0, 1] from the upper 31 of 32 random bits; a signed conversion vectorises everywhere.
inline float unit_interval(std::uint32_t bits) {
  return (static_cast<float>(static_cast<std::int32_t>(bits >> 1)) + 0.5f) * 4.656612873077393e-10f;
}

/// The last eight bits of an angle are below single precision's reach: they serve elsewhere.
constexpr std::uint32_t spare = 0xff;

} // namespace

void gaussians(NoiseSource const& source, std::uint32_t const* id_a, std::uint32_t const* id_b,
               GaussianLanes& out) {
  for (int lane = 0; lane < noise_lanes; ++lane) {
    // 64-bit words that hold 32-bit numbers: the products then need no shuffling between lanes.
    constexpr std::uint64_t low = 0xffffffffu;
    std::uint64_t x0 = id_a[lane], x1 = id_b[lane], x2 = source.step_low, x3 = source.step_high_and_stream;
    std::uint32_t k0 = source.key[0], k1 = source.key[1];
#pragma GCC unroll 10 // else the lanes do not vectorise
    for (int round = 0; round < Philox4x32::rounds; ++round) {
      std::uint64_t const a = Philox4x32::multiplier_0 * x0, b = Philox4x32::multiplier_1 * x2;
      x0 = (b >> 32) ^ x1 ^ k0;
      x2 = (a >> 32) ^ x3 ^ k1;
      x1 = b & low;
      x3 = a & low;
      k0 += Philox4x32::weyl_0, k1 += Philox4x32::weyl_1;
    }
    auto const c0 = static_cast<std::uint32_t>(x0), c1 = static_cast<std::uint32_t>(x1);
    auto const c2 = static_cast<std::uint32_t>(x2), c3 = static_cast<std::uint32_t>(x3);
    float const radius_1 = std::sqrt(-2.0f * log_unit(unit_interval(c0)));
    float const radius_2 = std::sqrt(-2.0f * log_unit(unit_interval(c2)));
    SineCosine const first = sine_cosine(c1 & ~spare), second = sine_cosine(c3 & ~spare);
    out.bits[lane] = (c1 & spare) << 8 | (c3 & spare);
    out.x[lane] = radius_1 * first.cosine;
    out.y[lane] = radius_1 * first.sine;
    out.z[lane] = radius_2 * second.cosine;
  }
}

Gaussians gaussians_and_bits_reference(NoiseSource const& source, std::uint32_t id_a, std::uint32_t id_b) {
  auto const word =
      Philox4x32::generate({id_a, id_b, source.step_low, source.step_high_and_stream}, source.key);
  auto radius = [](std::uint32_t b) { return std::sqrt(-2 * std::log(((b >> 1) + 0.5) / 2147483648.0)); };
  auto angle = [](std::uint32_t b) {
    return std::numbers::pi * static_cast<std::int32_t>(b & ~spare) / 2147483648.0;
  };
  return {.G = {radius(word[0]) * std::cos(angle(word[1])), radius(word[0]) * std::sin(angle(word[1])),
                radius(word[2]) * std::cos(angle(word[3]))},
          .bits = (word[1] & spare) << 8 | (word[3] & spare)};
}

std::array<double, 3> gaussians_reference(NoiseSource const& source, std::uint32_t id_a, std::uint32_t id_b) {
  return gaussians_and_bits_reference(source, id_a, id_b).G;
}

} // namespace mesobridge::sdpd
