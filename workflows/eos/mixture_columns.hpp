#pragma once
#include "fitting/eos/mixture.hpp"
#include "workflows/eos/columns.hpp"

namespace mesobridge::workflows {

/// One state of a mixture of that density, with its parts' densities.
Columns mixture_columns(double rho, fitting::MixtureState const& state);

} // namespace mesobridge::workflows
