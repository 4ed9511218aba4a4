#pragma once
#include "fitting/model_file.hpp"

namespace mesobridge::fitting {

/// What is to be said of a state at rho > 0, T > 0 (the model's units) outside the range of the model's data,
/// or in which a built-in material is usable; nothing inside it, and where no range is known.
std::optional<std::string> extrapolation(EosModel const& model, double rho, double T);

} // namespace mesobridge::fitting
