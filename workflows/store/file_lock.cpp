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

FileLock::FileLock(std::filesystem::path const& file, Kind kind, double patience)
    : descriptor_(open(file.c_str(), O_RDONLY | O_CLOEXEC)) {
  if (descriptor_ < 0)
    throw EnvironmentError(fmt::format("cannot open '{}': {}", file.string(), std::strerror(errno)));
  using Clock = std::chrono::steady_clock;
  auto const end = Clock::now() + std::chrono::duration<double>(patience);
  int const operation = (kind == Kind::shared ? LOCK_SH : LOCK_EX) | LOCK_NB;
  while (flock(descriptor_, operation) != 0 && (errno == EWOULDBLOCK || errno == EINTR)) {
    if (Clock::now() > end) {
      close(descriptor_);
      throw EnvironmentError(
          fmt::format("'{}' is in use by another process: wait for it to end, or stop it", file.string()));
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
}

FileLock::~FileLock() {
  close(descriptor_);
}

} // namespace mesobridge::workflows
