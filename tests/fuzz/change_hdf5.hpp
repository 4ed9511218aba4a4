#pragma once
#include "fuzz/trial.hpp"

namespace mesobridge::fuzz {

/// Changes one thing of an HDF5 file: type, shape or values of a dataset or attribute, or whether it is
/// there, or its bytes on the disk. Says what was done.
std::string change_hdf5(Random& random, std::filesystem::path const& file);

} // namespace mesobridge::fuzz
