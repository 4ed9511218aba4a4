#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>

// The seal of a file that is complete: its length and checksum, appended behind it, where HDF5 does not look.

namespace mesobridge::workflows {

/// Seals a closed file; it is on the disk afterwards. Throws EnvironmentError.
void seal(std::filesystem::path const& file);

/// The length without the seal; nothing for a file without one. Reads the whole file. Throws InputError when
/// the file is not what was sealed.
std::optional<std::uint64_t> sealed_length(std::filesystem::path const& file);

} // namespace mesobridge::workflows
