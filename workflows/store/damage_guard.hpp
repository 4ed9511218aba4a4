#pragma once
#include <filesystem>
#include <string>

namespace mesobridge::workflows {

/// While one of these lives, a crash of this thread ends the program with the message that the file is
/// damaged and the exit code of bad input. The HDF5 library believes what a file says of its own structure
/// (places in heaps, say), so that some damaged files make it read where nothing is; no check of ours comes
/// before that. It lives around calls of the library alone: elsewhere a crash stays a crash.
class DamageGuard {
 public:
  explicit DamageGuard(std::filesystem::path const& file);
  ~DamageGuard();
  DamageGuard(DamageGuard const&) = delete;
  DamageGuard& operator=(DamageGuard const&) = delete;

 private:
  std::string file_;
  char const* before_;
};

} // namespace mesobridge::workflows
