#include "md/lammps_name.hpp"
#include "md/error.hpp"
#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <string_view>
#include <unistd.h>

namespace mesobridge::md {
namespace {

bool is_plain(std::string_view text) {
  return std::ranges::all_of(text, [](char c) {
    bool const letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    return letter || std::string_view("/._-+,=@ ").find(c) != std::string_view::npos;
  });
}

int opened(std::filesystem::path const& path, int flags) {
  int const descriptor = open(path.c_str(), flags | O_CLOEXEC);
  if (descriptor < 0)
    throw EnvironmentError(fmt::format("cannot open '{}': {}", path.string(), std::strerror(errno)));
  return descriptor;
}

} // namespace

LammpsName::LammpsName(std::filesystem::path const& file) : text_(file.string()) {
  auto const name = file.filename().string();
  require(!name.empty(), "file for LAMMPS", text_, "must be the path of a file");
  if (is_plain(text_))
    return;
  if (is_plain(name)) {
    auto const folder = file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
    descriptor_ = opened(folder, O_PATH | O_DIRECTORY);
    text_ = fmt::format("/proc/self/fd/{}/{}", descriptor_, name);
    return;
  }
  require(std::filesystem::exists(file), "file for LAMMPS", text_,
          "a new file must be named in letters, digits and ._-+,=@ alone");
  descriptor_ = opened(file, O_RDONLY);
  text_ = fmt::format("/proc/self/fd/{}", descriptor_);
}

LammpsName::~LammpsName() {
  if (descriptor_ >= 0)
    close(descriptor_);
}

} // namespace mesobridge::md
