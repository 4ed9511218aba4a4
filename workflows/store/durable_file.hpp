#pragma once
#include <cstdint>
#include <filesystem>
#include <span>
#include <utility>

// Files by the operating system's own calls, each one checked: what is written is there, or an
// EnvironmentError names the file and the cause.

namespace mesobridge::workflows {

/// A file descriptor that closes itself.
class Descriptor {
 public:
  Descriptor() = default;
  /// `flags` are those of open(2). Throws EnvironmentError.
  Descriptor(std::filesystem::path const& file, int flags);
  Descriptor(Descriptor&& other) noexcept : id_(std::exchange(other.id_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(id_, other.id_);
    return *this;
  }
  ~Descriptor();
  int get() const { return id_; }

 private:
  int id_ = -1;
};

[[noreturn]] void fail_to(char const* what, std::filesystem::path const& file); ///< says what errno says

/// Writes all of it where the descriptor stands, or at an offset.
void write_all(Descriptor const& to, std::span<char const> bytes, std::filesystem::path const& file);
void write_all(Descriptor const& to, std::span<char const> bytes, std::uint64_t offset,
               std::filesystem::path const& file);

/// Reads from an offset on; returns how many bytes there were.
std::size_t read_some(Descriptor const& from, std::span<char> bytes, std::uint64_t offset,
                      std::filesystem::path const& file);

std::uint64_t length_of(Descriptor const& descriptor, std::filesystem::path const& file);
void cut(Descriptor const& descriptor, std::uint64_t length, std::filesystem::path const& file);

/// Waits until the data lie on the disk, where power loss leaves them.
void sync(Descriptor const& descriptor, std::filesystem::path const& file);
/// The same for the names in the directory of a file.
void sync_directory_of(std::filesystem::path const& file);

/// Puts a file that lies on the disk in place of another; that, too, is on the disk afterwards.
void replace(std::filesystem::path const& fresh, std::filesystem::path const& file);

/// The bytes of a plain struct.
template <class Plain>
std::span<char const> bytes_of(Plain const& plain) {
  return {reinterpret_cast<char const*>(&plain), sizeof plain};
}
template <class Plain>
std::span<char> bytes_of(Plain& plain) {
  return {reinterpret_cast<char*>(&plain), sizeof plain};
}

} // namespace mesobridge::workflows
