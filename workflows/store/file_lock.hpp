#pragma once
#include <filesystem>

namespace mesobridge::workflows {

/// Holds the lock that HDF5 puts on a file that it has open (flock). Waits for another process to give it up:
/// ranks of a program that was killed end some seconds after it. A file that this process has open counts as
/// that of another. On a file system without locks there is nothing to hold.
class FileLock {
 public:
  enum class Kind { shared, exclusive };

  /// Who writes waits for the dying; who reads meets the living, and soon says so. In seconds.
  static constexpr double usual_patience(Kind kind) { return kind == Kind::exclusive ? 15 : 2; }

  /// Throws EnvironmentError when the file cannot be opened (to write, for an exclusive lock) or locked, or
  /// is still locked by another after `patience` seconds.
  FileLock(std::filesystem::path const& file, Kind kind, double patience);
  FileLock(std::filesystem::path const& file, Kind kind) : FileLock(file, kind, usual_patience(kind)) {}
  FileLock(FileLock const&) = delete;
  FileLock& operator=(FileLock const&) = delete;
  ~FileLock();

 private:
  int descriptor_;
};

} // namespace mesobridge::workflows
