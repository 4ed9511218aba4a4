#pragma once
#include "fuzz/trial.hpp"
#include <string>

namespace mesobridge::fuzz {

/// What is wrong with how the commands of a trial ended; empty if nothing is.
std::string fault_of(Trial const& trial, std::vector<Outcome> const& outcomes);

/// All numbers of the HDF5 datasets in a file, by name.
std::vector<std::pair<std::string, std::vector<double>>> numbers_of(std::filesystem::path const& file);

} // namespace mesobridge::fuzz
