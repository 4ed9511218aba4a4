#pragma once
#include "fitting/fit_lj_bwr.hpp"
#include "workflows/command.hpp"

namespace mesobridge::workflows {

/// The numbers that tell how good a fit is, and every state beside it.
Json fit_json(fitting::LjBwrFit const& fit);

/// The same in a few lines for people.
std::string fit_text(fitting::LjBwrFit const& fit);

} // namespace mesobridge::workflows
