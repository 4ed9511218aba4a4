#pragma once
#include <filesystem>
#include <fmt/format.h>
#include <string>
#include <unistd.h>

namespace mesobridge::tests {

/// A log file of this process's own.
inline std::filesystem::path temporary_log(std::string const& name) {
  return std::filesystem::temp_directory_path() / fmt::format("mesobridge-{}-{}.log", name, ::getpid());
}

} // namespace mesobridge::tests
