#include "workflows/quantity.hpp"
#include "md/error.hpp"
#include "md/units.hpp"
#include "workflows/nearest.hpp"
#include "workflows/trimmed.hpp"
#include <charconv>
#include <vector>

namespace mesobridge::workflows {

namespace {

struct Unit {
  Dimension dimension;
  std::string_view name;
  double factor; ///< SI = value * factor
};

/// All units; the first of each dimension is SI.
constexpr Unit units[] = {
    {Dimension::number, "", 1},
    {Dimension::mass, "kg", 1},
    {Dimension::mass, "g", 1e-3},
    {Dimension::mass, "u", atomic_mass},
    {Dimension::mass, "amu", atomic_mass},
    {Dimension::length, "m", 1},
    {Dimension::length, "um", 1e-6},
    {Dimension::length, "nm", 1e-9},
    {Dimension::length, "angstrom", 1e-10},
    {Dimension::time, "s", 1},
    {Dimension::time, "us", 1e-6},
    {Dimension::time, "ns", 1e-9},
    {Dimension::time, "ps", 1e-12},
    {Dimension::time, "fs", 1e-15},
    {Dimension::rate, "1/s", 1},
    {Dimension::rate, "1/ns", 1e9},
    {Dimension::rate, "1/ps", 1e12},
    {Dimension::temperature, "K", 1},
    {Dimension::density, "kg/m^3", 1},
    {Dimension::density, "g/cm^3", 1e3},
    {Dimension::velocity, "m/s", 1},
    {Dimension::velocity, "km/s", 1e3},
    {Dimension::acceleration, "m/s^2", 1},
    {Dimension::acceleration, "nm/ps^2", 1e15},
    {Dimension::momentum, "kg*m/s", 1},
    {Dimension::pressure, "Pa", 1},
    {Dimension::pressure, "MPa", 1e6},
    {Dimension::pressure, "GPa", 1e9},
    {Dimension::pressure, "bar", 1e5},
    {Dimension::energy, "J", 1},
    {Dimension::energy, "eV", 1.602176634e-19},
    {Dimension::specific_energy, "J/kg", 1},
    {Dimension::specific_energy, "MJ/kg", 1e6},
    {Dimension::entropy, "J/K", 1},
    {Dimension::viscosity, "Pa*s", 1},
    {Dimension::viscosity, "mPa*s", 1e-3},
    {Dimension::friction, "kg/s", 1},
    {Dimension::force, "N", 1},
    {Dimension::force, "pN", 1e-12},
    {Dimension::conductivity, "W/(m*K)", 1},
    {Dimension::conduction, "W*K", 1},
};

std::vector<std::string> names_of(Dimension dimension) {
  std::vector<std::string> names;
  for (auto const& unit : units)
    if (unit.dimension == dimension)
      names.emplace_back(unit.name);
  return names;
}

double factor_of(std::string_view name, Dimension dimension) {
  for (auto const& unit : units)
    if (unit.dimension == dimension && unit.name == name)
      return unit.factor;
  if (name.empty())
    throw InputError("the unit is missing; allowed: " + allowed_units(dimension));
  throw InputError(fmt::format("wrong unit '{}'; allowed: {}{}", name, allowed_units(dimension),
                               did_you_mean(name, names_of(dimension))));
}

} // namespace

double parse_quantity(std::string_view text, Dimension dimension) {
  text = trimmed(text);
  double value = 0;
  auto const [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || !std::isfinite(value))
    throw InputError(fmt::format("not a finite number with a unit, like \"1.5 {}\"", si_unit(dimension)));
  double const si =
      value * factor_of(trimmed(text.substr(static_cast<std::size_t>(end - text.data()))), dimension);
  if (!std::isfinite(si))
    throw InputError("too large");
  return si;
}

std::string_view si_unit(Dimension dimension) {
  for (auto const& unit : units)
    if (unit.dimension == dimension)
      return unit.name;
  throw std::logic_error("a dimension without units");
}

std::string allowed_units(Dimension dimension) {
  return fmt::format("{}", fmt::join(names_of(dimension), ", "));
}

std::string quantity_text(double value_SI, Dimension dimension) {
  return fmt::format("{} {}", value_SI, si_unit(dimension)); // the shortest digits that read back exactly
}

} // namespace mesobridge::workflows
