#pragma once
#include <string>
#include <string_view>

namespace mesobridge::fitting {

/// Deeper nesting than any file of this program has; the parser's recursion stays far from the stack's end.
inline constexpr std::size_t deepest_toml = 64;

/// Refuses a text whose keys (a.b.c), tables ([a.b]), inline tables and arrays lie within each other deeper
/// than that, before it is parsed. Throws InputError with file and line. Strings and comments do not count.
void refuse_deep_toml(std::string_view text, std::string const& file);

} // namespace mesobridge::fitting
