#pragma once
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace mesobridge::tests {

/// All numbers of the HDF5 datasets in a file, by name; none when it cannot be opened. Read by HDF5 alone, so
/// that our own reader is not its own judge.
std::vector<std::pair<std::string, std::vector<double>>> numbers_of(std::filesystem::path const& file);

/// "FILE: DATASET holds nan", of the first number in the HDF5 files of a folder that is not finite; or
/// nothing.
std::string not_finite_in(std::filesystem::path const& folder);

} // namespace mesobridge::tests
