#include "workflows/store/undo_journal.hpp"
#include "md/error.hpp"
#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

namespace mesobridge::workflows {
namespace {

constexpr std::size_t page_size = 4096;

/// What a journal begins with.
struct Header {
  std::array<char, 8> name{'u', 'n', 'd', 'o', ' ', 'v', '1', '\n'};
  std::uint64_t length = 0; ///< of the file
};

/// A page as it was. A record that is not complete belongs to a page that was not touched yet.
struct Record {
  std::uint64_t page = 0;
  std::array<char, page_size> bytes{};
};

std::filesystem::path journal_of(std::filesystem::path const& file) {
  return std::filesystem::path(file).concat(".undo");
}

[[noreturn]] void fail(char const* what, std::filesystem::path const& file) {
  throw EnvironmentError(fmt::format("cannot {} '{}': {}", what, file.string(), std::strerror(errno)));
}

/// A file descriptor that closes itself.
class Descriptor {
 public:
  Descriptor(std::filesystem::path const& file, int flags)
      : id_(open(file.c_str(), flags | O_CLOEXEC, 0666)) {
    if (id_ < 0)
      fail("open", file);
  }
  Descriptor(Descriptor const&) = delete;
  Descriptor& operator=(Descriptor const&) = delete;
  ~Descriptor() {
    if (id_ >= 0)
      close(id_);
  }
  int get() const { return id_; }
  int release() { return std::exchange(id_, -1); }

 private:
  int id_;
};

void write_all(int descriptor, void const* data, std::size_t size, std::filesystem::path const& file) {
  auto const* bytes = static_cast<char const*>(data);
  while (size > 0) {
    auto const written = write(descriptor, bytes, size);
    if (written < 0 && errno != EINTR)
      fail("write", file);
    if (written > 0)
      bytes += written, size -= static_cast<std::size_t>(written);
  }
}

/// False at the end of the file, and where only a part is there.
bool read_whole(int descriptor, void* data, std::size_t size, std::filesystem::path const& file) {
  auto* bytes = static_cast<char*>(data);
  while (size > 0) {
    auto const got = read(descriptor, bytes, size);
    if (got < 0 && errno != EINTR)
      fail("read", file);
    if (got == 0)
      return false;
    if (got > 0)
      bytes += got, size -= static_cast<std::size_t>(got);
  }
  return true;
}

void write_at(int descriptor, char const* bytes, std::size_t size, std::uint64_t offset,
              std::filesystem::path const& file) {
  while (size > 0) {
    auto const written = pwrite(descriptor, bytes, size, static_cast<off_t>(offset));
    if (written < 0 && errno != EINTR)
      fail("write", file);
    if (written > 0)
      bytes += written, size -= static_cast<std::size_t>(written),
          offset += static_cast<std::uint64_t>(written);
  }
}

} // namespace

UndoJournal::UndoJournal(std::filesystem::path file) : file_(std::move(file)) {
  Descriptor source(file_, O_RDONLY);
  struct stat status {};
  if (fstat(source.get(), &status) != 0)
    fail("read", file_);
  length_ = static_cast<std::uint64_t>(status.st_size);
  auto const fresh = journal_of(file_).concat(".new");
  Descriptor journal(fresh, O_WRONLY | O_CREAT | O_TRUNC | O_APPEND);
  Header const header{.length = length_};
  write_all(journal.get(), &header, sizeof header, fresh);
  std::error_code error;
  std::filesystem::rename(fresh, journal_of(file_),
                          error); // from here on the new state is the one to go back to
  if (error)
    throw EnvironmentError(fmt::format("cannot write '{}': {}", journal_of(file_).string(), error.message()));
  source_ = source.release(), journal_ = journal.release();
}

UndoJournal::~UndoJournal() {
  close(source_);
  close(journal_);
}

void UndoJournal::protect(std::uint64_t offset, std::uint64_t size) {
  std::uint64_t const end = std::min(offset + size, length_);
  for (std::uint64_t page = offset / page_size; page * page_size < end; ++page) {
    if (!saved_.insert(page).second)
      continue;
    Record record{.page = page};
    auto const got = pread(source_, record.bytes.data(), page_size,
                           static_cast<off_t>(page * page_size)); // short at the end
    if (got < 0)
      fail("read", file_);
    write_all(journal_, &record, sizeof record, journal_of(file_));
  }
}

void UndoJournal::protect_beyond(std::uint64_t length) {
  if (length < length_)
    protect(length, length_ - length);
}

bool UndoJournal::exists(std::filesystem::path const& file) {
  return std::filesystem::exists(journal_of(file));
}

void UndoJournal::roll_back(std::filesystem::path const& file) {
  if (!exists(file))
    return;
  auto const path = journal_of(file);
  Descriptor const journal(path, O_RDONLY), target(file, O_WRONLY);
  Header header;
  if (!read_whole(journal.get(), &header, sizeof header, path) || header.name != Header().name)
    throw EnvironmentError(fmt::format("'{}' is no journal of this program", path.string()));
  for (Record record; read_whole(journal.get(), &record, sizeof record, path);) {
    std::uint64_t const offset = record.page * page_size;
    write_at(target.get(), record.bytes.data(), std::min<std::uint64_t>(page_size, header.length - offset),
             offset, file);
  }
  if (ftruncate(target.get(), static_cast<off_t>(header.length)) != 0)
    fail("shorten", file);
}

void UndoJournal::discard(std::filesystem::path const& file) {
  std::error_code error;
  std::filesystem::remove(journal_of(file), error);
  if (error)
    throw EnvironmentError(fmt::format("cannot remove '{}': {}", journal_of(file).string(), error.message()));
}

} // namespace mesobridge::workflows
