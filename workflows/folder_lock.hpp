#pragma once
#include <filesystem>
#include <string>

namespace mesobridge::workflows {

/// Holds a folder for one process: two that write into it would mix their results. A process that dies gives
/// it up, whatever is left of the lock's file. On a file system without locks there is nothing to hold.
class FolderLock {
 public:
  /// Tries once; `who` is what others are told: the command. Throws EnvironmentError that names the holder,
  /// or says why the folder cannot be written.
  FolderLock(std::filesystem::path const& folder, std::string const& who);
  FolderLock(FolderLock const&) = delete;
  FolderLock& operator=(FolderLock const&) = delete;
  ~FolderLock();

  static constexpr char const* file_name = ".mesobridge-lock";

 private:
  std::filesystem::path file_;
  int descriptor_ = -1;
};

} // namespace mesobridge::workflows
