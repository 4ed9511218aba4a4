#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>

// The seal of a file that is complete: its length and checksum, appended behind it, where HDF5 does not look,
// or beside it in FILE.seal, where readers of text take no offence.

namespace mesobridge::workflows {

/// Seals a closed file; it is on the disk afterwards. Throws EnvironmentError.
void seal(std::filesystem::path const& file);

/// The length without the seal; nothing for a file without one. Reads the whole file. Throws InputError when
/// the file is not what was sealed.
std::optional<std::uint64_t> sealed_length(std::filesystem::path const& file);

/// Seals a closed file beside it; both are on the disk afterwards. Throws EnvironmentError.
void seal_beside(std::filesystem::path const& file);

/// Reads the whole file where there is a seal beside it. Throws InputError when the file is not what was
/// sealed, or the seal is none.
void check_seal_beside(std::filesystem::path const& file);

/// The file is about to change. Throws EnvironmentError.
void remove_seal_beside(std::filesystem::path const& file);

/// Where the seal beside a file is.
std::filesystem::path seal_beside_path(std::filesystem::path const& file);

} // namespace mesobridge::workflows
