#pragma once
#include "md/dimension.hpp"
#include <string>
#include <string_view>

namespace mesobridge::workflows {

/// Reads "500 m/s" as a value in SI. Throws InputError that says what is wrong and which units are allowed;
/// the message does not name the key, the caller does.
double parse_quantity(std::string_view text, Dimension dimension);

/// The SI unit of a dimension, "kg/m^3".
std::string_view si_unit(Dimension dimension);

/// All units that parse_quantity takes for the dimension, "kg/m^3, g/cm^3".
std::string allowed_units(Dimension dimension);

/// The quantity as parse_quantity reads it back exactly, "1150 kg/m^3".
std::string quantity_text(double value_SI, Dimension dimension);

} // namespace mesobridge::workflows
