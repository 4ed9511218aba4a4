#include "workflows/store/page_digest.hpp"
#include <algorithm>
#include <zlib.h>

namespace mesobridge::workflows {
namespace {

/// Odd, so that no change of a page's checksum times it vanishes.
std::uint64_t weight(std::uint64_t page) {
  return 2 * page + 1;
}

} // namespace

std::uint32_t PageDigest::crc(std::span<char const> bytes) {
  return static_cast<std::uint32_t>(
      crc32_z(0, reinterpret_cast<unsigned char const*>(bytes.data()), bytes.size()));
}

void PageDigest::set(std::uint64_t page, std::uint32_t crc) {
  auto& place = crc_.at(page);
  value_ += weight(page) * (std::uint64_t{crc} - place);
  place = crc;
}

void PageDigest::set_length(std::uint64_t length) {
  auto const pages = (length + page_size - 1) / page_size;
  for (auto page = pages; page < crc_.size(); ++page)
    set(page, 0);
  crc_.resize(pages);
  length_ = length;
}

void PageDigest::take(Descriptor const& source, std::uint64_t length, std::uint64_t first, std::uint64_t end,
                      std::filesystem::path const& file) {
  set_length(length);
  end = std::min<std::uint64_t>(end, crc_.size());
  constexpr std::uint64_t at_once = 64; // pages
  std::vector<char> buffer(std::min(at_once, end > first ? end - first : 0) * page_size);
  for (auto start = first; start < end; start += at_once) {
    auto const offset = start * page_size;
    auto const wanted = std::min(std::min(start + at_once, end) * page_size, length) - offset;
    auto const got = read_some(source, std::span(buffer).first(wanted), offset, file);
    for (std::uint64_t k = 0; start + k < std::min(start + at_once, end); ++k) {
      auto const from = std::min<std::uint64_t>(k * page_size, got),
                 to = std::min<std::uint64_t>(from + page_size, got);
      set(start + k, crc(std::span(buffer).subspan(from, to - from)));
    }
  }
}

void PageDigest::take(Descriptor const& source, std::uint64_t length, std::filesystem::path const& file) {
  take(source, length, 0, (length + page_size - 1) / page_size, file);
}

void PageDigest::take(std::uint64_t page, std::span<char const> bytes) {
  set(page, crc(bytes.first(std::min<std::uint64_t>(page_size, length_ - page * page_size))));
}

} // namespace mesobridge::workflows
