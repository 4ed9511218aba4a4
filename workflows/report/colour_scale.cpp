#include "workflows/report/colour_scale.hpp"
#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>

namespace mesobridge::workflows {
namespace {

struct Colour {
  int red, green, blue;
};
constexpr std::array<Colour, 5> stops{
    {{0x44, 0x01, 0x54}, {0x3b, 0x52, 0x8b}, {0x21, 0x91, 0x8c}, {0x5e, 0xc9, 0x62}, {0xfd, 0xe7, 0x25}}};

} // namespace

std::string scale_colour(double share) {
  double const at = std::clamp(share, 0.0, 1.0) * (stops.size() - 1);
  auto const k = std::min(static_cast<std::size_t>(at), stops.size() - 2);
  double const part = at - static_cast<double>(k);
  auto const mix = [&](int Colour::*of) {
    return std::lround(std::lerp(stops[k].*of, stops[k + 1].*of, part));
  };
  return fmt::format("#{:02x}{:02x}{:02x}", mix(&Colour::red), mix(&Colour::green), mix(&Colour::blue));
}

std::string gnuplot_scale() {
  std::string text;
  for (std::size_t k = 0; k < stops.size(); ++k)
    text += fmt::format("{}{} '{}'", k > 0 ? ", " : "", k,
                        scale_colour(static_cast<double>(k) / (stops.size() - 1)));
  return "defined (" + text + ")";
}

} // namespace mesobridge::workflows
