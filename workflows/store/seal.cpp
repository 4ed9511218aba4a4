#include "workflows/store/seal.hpp"
#include "md/error.hpp"
#include "workflows/store/page_digest.hpp"
#include <array>
#include <cstddef>
#include <fcntl.h>

namespace mesobridge::workflows {
namespace {

/// What stands behind a sealed file.
struct Seal {
  std::array<char, 8> name{'s', 'e', 'a', 'l', ' ', 'v', '1', '\n'};
  std::uint64_t length = 0, digest = 0;
  std::uint64_t crc = 0; ///< of what stands above
  std::uint64_t own_crc() const { return PageDigest::crc(bytes_of(*this).first(offsetof(Seal, crc))); }
};

} // namespace

void seal(std::filesystem::path const& file) {
  Descriptor const target(file, O_RDWR);
  auto const length = length_of(target, file);
  PageDigest digest;
  digest.take(target, length, file);
  Seal seal{.length = length, .digest = digest.value()};
  seal.crc = seal.own_crc();
  write_all(target, bytes_of(seal), length, file);
  sync(target, file);
}

std::optional<std::uint64_t> sealed_length(std::filesystem::path const& file) {
  Descriptor const source(file, O_RDONLY);
  auto const all = length_of(source, file);
  Seal seal;
  if (all < sizeof seal)
    return std::nullopt;
  read_some(source, bytes_of(seal), all - sizeof seal, file);
  if (seal.name != Seal().name || seal.crc != seal.own_crc())
    return std::nullopt;
  PageDigest digest;
  if (seal.length == all - sizeof seal)
    digest.take(source, seal.length, file);
  if (seal.length != all - sizeof seal || digest.value() != seal.digest)
    throw InputError(fmt::format("'{}' is damaged: its content is not the one that its checksum was made of",
                                 file.string()));
  return seal.length;
}

} // namespace mesobridge::workflows
