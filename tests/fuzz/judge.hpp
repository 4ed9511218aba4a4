#pragma once
#include "fuzz/trial.hpp"
#include <string>

namespace mesobridge::fuzz {

/// What is wrong with how the commands of a trial ended; empty if nothing is.
std::string fault_of(Trial const& trial, std::vector<Outcome> const& outcomes);

} // namespace mesobridge::fuzz
