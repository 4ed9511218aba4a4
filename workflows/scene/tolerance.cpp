#include "workflows/scene/tolerance.hpp"
#include "md/error.hpp"
#include "workflows/quantity.hpp"
#include <charconv>
#include <fmt/ranges.h>
#include <utility>

namespace mesobridge::workflows {
namespace {

/// The number that a text begins with, and what follows it; nothing if there is none that is finite.
std::optional<std::pair<double, std::string>> leading_number(std::string const& text) {
  double value = 0;
  auto const [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || !std::isfinite(value))
    return std::nullopt;
  return std::pair{value, std::string(end, text.data() + text.size())};
}

} // namespace

double parse_rate(std::string const& text, UnitSystem units) {
  bool const si = units == UnitSystem::SI;
  std::string const allowed = si ? "must be a number > 0 per unit of time, such as \"1e-6/ps\""
                                 : "must be a number > 0, per Lennard-Jones unit of time";
  auto const number = leading_number(text);
  if (!number || !(number->first > 0) || number->second.empty() == si)
    throw InputError(allowed);
  if (!si)
    return number->first;
  auto const slash = number->second.find('/');
  if (slash == std::string::npos || number->second.find_first_not_of(' ') != slash)
    throw InputError(allowed);
  return number->first / parse_quantity("1 " + number->second.substr(slash + 1), Dimension::time);
}

double parse_share(std::string const& text) {
  auto const number = leading_number(text);
  bool const percent = number && (number->second == "%" || number->second == " %");
  double const share = number ? number->first * (percent ? 0.01 : 1) : 0;
  if (!number || !(percent || number->second.empty()) || !(share > 0 && share < 1))
    throw InputError("must be a share > 0 and < 1, such as \"0.5%\" or 0.005");
  return share;
}

std::optional<double> balance_tolerance(Scene::Scheme const& scheme) {
  if (!scheme.drift || !scheme.drift->ends_with('%'))
    return std::nullopt;
  return parse_share(*scheme.drift);
}

std::string tolerance_text(Scene::Scheme const& scheme) {
  std::vector<std::string> parts;
  if (scheme.drift)
    parts.push_back("drift " + *scheme.drift);
  if (scheme.bias)
    parts.push_back("bias " + *scheme.bias);
  if (scheme.dynamics)
    parts.push_back("dynamics " + *scheme.dynamics);
  return fmt::format("{}", fmt::join(parts, ", "));
}

} // namespace mesobridge::workflows
