#include "workflows/folder_lock.hpp"
#include "md/error.hpp"
#include <array>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace mesobridge::workflows {
namespace {

/// Whether the open file is still the one of that name: the holder before may have removed it in between.
bool is_still_there(int descriptor, std::filesystem::path const& file) {
  struct stat open_one {
  }, named_one{};
  return fstat(descriptor, &open_one) == 0 && stat(file.c_str(), &named_one) == 0 &&
         open_one.st_ino == named_one.st_ino && open_one.st_dev == named_one.st_dev;
}

std::string content_of(int descriptor) {
  std::array<char, 400> text{};
  auto const length = pread(descriptor, text.data(), text.size(), 0);
  return {text.data(), static_cast<std::size_t>(std::max<ssize_t>(length, 0))};
}

/// Whether the lock is ours now; there is none on file systems that have no locks.
bool locked(int descriptor, std::filesystem::path const& file) {
  if (flock(descriptor, LOCK_EX | LOCK_NB) == 0 || errno == ENOSYS || errno == EOPNOTSUPP || errno == ENOLCK)
    return true;
  if (errno == EWOULDBLOCK)
    return false;
  throw EnvironmentError(fmt::format("cannot lock '{}': {}", file.string(), std::strerror(errno)));
}

} // namespace

FolderLock::FolderLock(std::filesystem::path const& folder, std::string const& who)
    : file_(folder / file_name) {
  do {
    if (descriptor_ >= 0)
      close(descriptor_);
    descriptor_ = open(file_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (descriptor_ < 0)
      throw EnvironmentError(
          fmt::format("cannot write into '{}': {}", folder.string(), std::strerror(errno)));
    if (!locked(descriptor_, file_)) {
      auto const holder = content_of(descriptor_);
      close(descriptor_);
      throw EnvironmentError(
          fmt::format("'{}' is in use by another process: {}; wait for it to end, stop it, "
                      "or write into another folder with -o",
                      folder.string(), holder));
    }
  } while (!is_still_there(descriptor_, file_));
  auto const text = fmt::format("process {}, {}", getpid(), who);
  // Only for the message of others, who are refused without it, too.
  [[maybe_unused]] bool const told =
      ftruncate(descriptor_, 0) == 0 && pwrite(descriptor_, text.data(), text.size(), 0) > 0;
}

FolderLock::~FolderLock() {
  unlink(file_.c_str()); // before another may take it
  close(descriptor_);
}

} // namespace mesobridge::workflows
