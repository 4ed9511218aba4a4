#pragma once
#include <filesystem>

namespace mesobridge::workflows {

/// Holds the lock that HDF5 puts on a file that it has open (flock). Waits some seconds for another process to
/// give it up: ranks of a program that was killed end a moment after it. On a file system without locks there
/// is nothing to hold.
class FileLock {
 public:
  enum class Kind { shared, exclusive };

  /// Throws EnvironmentError when the file cannot be opened, or is still locked after `patience` seconds.
  FileLock(std::filesystem::path const& file, Kind kind, double patience = 15);
  FileLock(FileLock const&) = delete;
  FileLock& operator=(FileLock const&) = delete;
  ~FileLock();

 private:
  int descriptor_;
};

} // namespace mesobridge::workflows
