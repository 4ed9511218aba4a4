#pragma once
#include <string_view>

namespace mesobridge::workflows {

/// A text without the blanks and tabs at its ends, a part of it.
inline std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blanks = " \t";
  auto const first = text.find_first_not_of(blanks);
  return first == text.npos ? "" : text.substr(first, text.find_last_not_of(blanks) + 1 - first);
}

} // namespace mesobridge::workflows
