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

Seal seal_of(Descriptor const& source, std::filesystem::path const& file) {
  auto const length = length_of(source, file);
  PageDigest digest;
  digest.take(source, length, file);
  Seal seal{.length = length, .digest = digest.value()};
  seal.crc = seal.own_crc();
  return seal;
}

bool is_whole(Seal const& seal) {
  return seal.name == Seal().name && seal.crc == seal.own_crc();
}

[[noreturn]] void refuse_damaged(std::filesystem::path const& file) {
  throw InputError(fmt::format("'{}' is damaged: its content is not the one that its checksum was made of",
                               file.string()));
}

} // namespace

void seal(std::filesystem::path const& file) {
  Descriptor const target(file, O_RDWR);
  auto const seal = seal_of(target, file);
  write_all(target, bytes_of(seal), seal.length, file);
  sync(target, file);
}

std::optional<std::uint64_t> sealed_length(std::filesystem::path const& file) {
  Descriptor const source(file, O_RDONLY);
  auto const all = length_of(source, file);
  Seal seal;
  if (all < sizeof seal)
    return std::nullopt;
  read_some(source, bytes_of(seal), all - sizeof seal, file);
  if (!is_whole(seal))
    return std::nullopt;
  PageDigest digest;
  if (seal.length == all - sizeof seal)
    digest.take(source, seal.length, file);
  if (seal.length != all - sizeof seal || digest.value() != seal.digest)
    refuse_damaged(file);
  return seal.length;
}

std::filesystem::path seal_beside_path(std::filesystem::path const& file) {
  return std::filesystem::path(file).concat(".seal");
}

void seal_beside(std::filesystem::path const& file) {
  Descriptor const source(file, O_RDONLY);
  sync(source, file);
  auto const seal = seal_of(source, file);
  auto const path = seal_beside_path(file), fresh = std::filesystem::path(path).concat(".new");
  {
    Descriptor const target(fresh, O_WRONLY | O_CREAT | O_TRUNC);
    write_all(target, bytes_of(seal), fresh);
    sync(target, fresh);
  }
  replace(fresh, path);
}

void check_seal_beside(std::filesystem::path const& file) {
  auto const path = seal_beside_path(file);
  if (!std::filesystem::exists(path))
    return;
  Descriptor const stored(path, O_RDONLY), source(file, O_RDONLY);
  Seal seal;
  if (length_of(stored, path) != sizeof seal || read_some(stored, bytes_of(seal), 0, path) != sizeof seal ||
      !is_whole(seal))
    throw InputError(
        fmt::format("'{}' is damaged, or no seal of this version of the program: whether '{}' is "
                    "whole cannot be told",
                    path.string(), file.string()));
  auto const now = seal_of(source, file);
  if (now.length != seal.length || now.digest != seal.digest)
    refuse_damaged(file);
}

void remove_seal_beside(std::filesystem::path const& file) {
  std::error_code error;
  if (!std::filesystem::remove(seal_beside_path(file), error) && !error)
    return;
  if (error)
    throw EnvironmentError(
        fmt::format("cannot remove '{}': {}", seal_beside_path(file).string(), error.message()));
  sync_directory_of(file);
}

} // namespace mesobridge::workflows
