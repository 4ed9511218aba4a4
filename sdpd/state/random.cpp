#include "sdpd/state/random.hpp"
#include <cmath>
#include <numbers>

namespace mesobridge::sdpd {

Gaussians gaussians_and_bits_reference(NoiseSource const& source, std::uint32_t id_a, std::uint32_t id_b) {
  auto const word =
      Philox4x32::generate({id_a, id_b, source.step_low, source.step_high_and_stream}, source.key);
  auto radius = [](std::uint32_t b) { return std::sqrt(-2 * std::log(((b >> 1) + 0.5) / 2147483648.0)); };
  auto angle = [](std::uint32_t b) {
    std::uint32_t const middle = (spare_of_turn + 1) / 2; // of the interval that the bits tell
    return std::numbers::pi * ((b & ~(sign_bit | spare_of_turn)) + middle) / 2147483648.0;
  };
  double const side = word[1] & sign_bit ? -1 : 1;
  return {.G = {radius(word[0]) * std::cos(angle(word[1])), side * radius(word[0]) * std::sin(angle(word[1])),
                radius(word[2]) * std::cos(angle(word[3]))},
          .bits = (word[1] & spare_of_turn) << 8 | (word[3] & spare_of_turn)};
}

std::array<double, 3> gaussians_reference(NoiseSource const& source, std::uint32_t id_a, std::uint32_t id_b) {
  return gaussians_and_bits_reference(source, id_a, id_b).G;
}

} // namespace mesobridge::sdpd
