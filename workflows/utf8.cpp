#include "workflows/utf8.hpp"
#include "md/error.hpp"

namespace mesobridge::workflows {
namespace {

/// Bytes of the character that the text begins with; 0 where it begins with none.
std::size_t length_of_first(std::string_view text) {
  auto byte = [&](std::size_t k) { return static_cast<unsigned char>(text[k]); };
  unsigned const first = byte(0);
  if (first < 0x80)
    return 1;
  std::size_t const length = first >= 0xC2 && first < 0xE0   ? 2
                             : first >= 0xE0 && first < 0xF0 ? 3
                             : first >= 0xF0 && first < 0xF5 ? 4
                                                             : 0;
  if (length == 0 || text.size() < length)
    return 0;
  for (std::size_t k = 1; k < length; ++k)
    if ((byte(k) & 0xC0) != 0x80)
      return 0;
  bool const overlong = (first == 0xE0 && byte(1) < 0xA0) || (first == 0xF0 && byte(1) < 0x90),
             surrogate = first == 0xED && byte(1) > 0x9F, beyond = first == 0xF4 && byte(1) > 0x8F;
  return overlong || surrogate || beyond ? 0 : length;
}

} // namespace

bool is_utf8(std::string_view bytes) {
  while (!bytes.empty()) {
    std::size_t const length = length_of_first(bytes);
    if (length == 0)
      return false;
    bytes.remove_prefix(length);
  }
  return true;
}

std::string escaped_to_utf8(std::string_view bytes) {
  std::string result;
  while (!bytes.empty()) {
    std::size_t const length = length_of_first(bytes);
    if (length == 0)
      result += fmt::format("\\x{:02x}", static_cast<unsigned char>(bytes.front()));
    else
      result += bytes.substr(0, length);
    bytes.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return result;
}

void require_utf8(std::vector<std::string> const& words) {
  for (auto const& word : words)
    if (!is_utf8(word))
      throw InputError(fmt::format("'{}': names must be UTF-8, as all that is written is; rename it, for "
                                   "example with convmv",
                                   escaped_to_utf8(word)));
}

} // namespace mesobridge::workflows
