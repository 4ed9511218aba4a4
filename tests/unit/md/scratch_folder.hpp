#pragma once
#include <filesystem>
#include <fmt/format.h>
#include <unistd.h>

namespace mesobridge::md::test {

/// A folder of a test's own, removed at its end.
class ScratchFolder {
 public:
  ScratchFolder() {
    static int count = 0;
    path_ =
        std::filesystem::temp_directory_path() / fmt::format("mesobridge-stars-{}-{}", ::getpid(), count++);
    std::filesystem::create_directories(path_);
  }
  ~ScratchFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  ScratchFolder(ScratchFolder const&) = delete;
  ScratchFolder& operator=(ScratchFolder const&) = delete;
  std::filesystem::path const& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

} // namespace mesobridge::md::test
