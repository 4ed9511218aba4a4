#include "workflows/store/file_lock.hpp"
#include "md/error.hpp"
#include <cerrno>
#include <chrono>
#include <cstring>
#include <fcntl.h>
#include <sys/file.h>
#include <thread>
#include <unistd.h>

namespace mesobridge::workflows {

namespace {

/// Tries once; false when another process holds the lock. Throws where locks fail for another reason than
/// that there are none.
bool locked(int descriptor, FileLock::Kind kind, std::filesystem::path const& file) {
  int const operation = kind == FileLock::Kind::shared ? LOCK_SH : LOCK_EX;
  if (flock(descriptor, operation | LOCK_NB) == 0)
    return true;
  if (errno == EWOULDBLOCK || errno == EINTR)
    return false;
  if (errno == ENOSYS || errno == EOPNOTSUPP || errno == ENOLCK)
    return true;
  throw EnvironmentError(fmt::format("cannot lock '{}': {}", file.string(), std::strerror(errno)));
}

} // namespace

// Over a network an exclusive lock takes a file that is open to be written.
FileLock::FileLock(std::filesystem::path const& file, Kind kind, double patience)
    : descriptor_(open(file.c_str(), (kind == Kind::shared ? O_RDONLY : O_RDWR) | O_CLOEXEC)) {
  if (descriptor_ < 0)
    throw EnvironmentError(fmt::format("cannot open '{}': {}", file.string(), std::strerror(errno)));
  using Clock = std::chrono::steady_clock;
  auto const end = Clock::now() + std::chrono::duration<double>(patience);
  try {
    while (!locked(descriptor_, kind, file)) {
      if (Clock::now() > end)
        throw EnvironmentError(
            fmt::format("'{}' is in use by another process: wait for it to end, or stop it", file.string()));
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
  } catch (...) {
    close(descriptor_);
    throw;
  }
}

FileLock::~FileLock() {
  close(descriptor_);
}

} // namespace mesobridge::workflows
