#pragma once
#include "workflows/store/durable_file.hpp"
#include <vector>

namespace mesobridge::workflows {

/// A checksum of a whole file that costs, when a part changes, as much as that part: the CRC-32 of each page
/// (by zlib), and their sum, each times an odd number of its own, modulo 2^64. One damaged page always
/// changes it, and so do two that are exchanged; damage in several pages stays unseen once in 2^32 times. It
/// is no protection from those who mean it.
class PageDigest {
 public:
  static constexpr std::size_t page_size = 4096;

  std::uint64_t value() const { return value_; }
  std::uint64_t length() const { return length_; }

  /// Takes the pages from `first` to before `end` anew from a file that is `length` bytes long, or will be.
  void take(Descriptor const& source, std::uint64_t length, std::uint64_t first, std::uint64_t end,
            std::filesystem::path const& file);
  /// Takes the first `length` bytes.
  void take(Descriptor const& source, std::uint64_t length, std::filesystem::path const& file);
  /// Takes one page from memory, `page_size` bytes; of the last one, those within the length count.
  void take(std::uint64_t page, std::span<char const> bytes);

  static std::uint32_t crc(std::span<char const> bytes);

 private:
  void set_length(std::uint64_t length);
  void set(std::uint64_t page, std::uint32_t crc);

  std::vector<std::uint32_t> crc_; ///< of each page
  std::uint64_t length_ = 0, value_ = 0;
};

} // namespace mesobridge::workflows
