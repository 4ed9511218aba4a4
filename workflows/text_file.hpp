#pragma once
#include <filesystem>
#include <string>
#include <string_view>

namespace mesobridge::workflows {

/// The content of a file. Throws InputError if it is missing or unreadable.
std::string read_text_file(std::filesystem::path const& file);

/// Writes a file so that it is there whole or not at all: a new file, flushed to the disk, then renamed.
/// Throws EnvironmentError that names the file and the cause.
void write_text_file(std::filesystem::path const& file, std::string_view text);

} // namespace mesobridge::workflows
