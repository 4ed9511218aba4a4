#include "workflows/store/durable_file.hpp"
#include "md/error.hpp"
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace mesobridge::workflows {

void fail_to(char const* what, std::filesystem::path const& file) {
  throw EnvironmentError(fmt::format("cannot {} '{}': {}", what, file.string(), std::strerror(errno)));
}

Descriptor::Descriptor(std::filesystem::path const& file, int flags)
    : id_(open(file.c_str(), flags | O_CLOEXEC, 0666)) {
  if (id_ < 0)
    fail_to("open", file);
}

Descriptor::~Descriptor() {
  if (id_ >= 0)
    close(id_);
}

namespace {

/// Hands over the rest until there is none; `put` is a call like write(2).
template <class Put>
void until_all_is_there(std::span<char const> bytes, std::filesystem::path const& file, Put const& put) {
  while (!bytes.empty()) {
    auto const written = put(bytes);
    if (written < 0 && errno != EINTR)
      fail_to("write", file);
    if (written > 0)
      bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
}

/// File systems that keep nothing on a disk say so.
bool has_nothing_to_sync(int error) {
  return error == EINVAL || error == ENOSYS || error == EOPNOTSUPP;
}

} // namespace

void write_all(Descriptor const& to, std::span<char const> bytes, std::filesystem::path const& file) {
  until_all_is_there(bytes, file, [&](auto rest) { return write(to.get(), rest.data(), rest.size()); });
}

void write_all(Descriptor const& to, std::span<char const> bytes, std::uint64_t offset,
               std::filesystem::path const& file) {
  auto const end = offset + bytes.size();
  until_all_is_there(bytes, file, [&](auto rest) {
    return pwrite(to.get(), rest.data(), rest.size(), static_cast<off_t>(end - rest.size()));
  });
}

std::size_t read_some(Descriptor const& from, std::span<char> bytes, std::uint64_t offset,
                      std::filesystem::path const& file) {
  std::size_t done = 0;
  while (done < bytes.size()) {
    auto const got =
        pread(from.get(), bytes.data() + done, bytes.size() - done, static_cast<off_t>(offset + done));
    if (got < 0 && errno != EINTR)
      fail_to("read", file);
    if (got == 0)
      break;
    if (got > 0)
      done += static_cast<std::size_t>(got);
  }
  return done;
}

std::uint64_t length_of(Descriptor const& descriptor, std::filesystem::path const& file) {
  struct stat status {};
  if (fstat(descriptor.get(), &status) != 0)
    fail_to("read", file);
  return static_cast<std::uint64_t>(status.st_size);
}

void cut(Descriptor const& descriptor, std::uint64_t length, std::filesystem::path const& file) {
  if (ftruncate(descriptor.get(), static_cast<off_t>(length)) != 0)
    fail_to("shorten", file);
}

void sync(Descriptor const& descriptor, std::filesystem::path const& file) {
  if (fdatasync(descriptor.get()) != 0 && !has_nothing_to_sync(errno))
    fail_to("write", file);
}

void sync_directory_of(std::filesystem::path const& file) {
  auto const directory = file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
  int const id = open(directory.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (id < 0)
    return; // one that may be written in, but not be read
  bool const failed = fsync(id) != 0 && !has_nothing_to_sync(errno);
  int const cause = errno;
  close(id);
  errno = cause;
  if (failed)
    fail_to("write the directory of", file);
}

void replace(std::filesystem::path const& fresh, std::filesystem::path const& file) {
  if (std::rename(fresh.c_str(), file.c_str()) != 0)
    fail_to("write", file);
  sync_directory_of(file);
}

} // namespace mesobridge::workflows
