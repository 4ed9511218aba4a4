#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace mesobridge::workflows {

/// Whether the bytes are UTF-8 (RFC 3629: no surrogates, nothing overlong, up to U+10FFFF).
bool is_utf8(std::string_view bytes);

/// Printable wherever UTF-8 is: bytes that are none stand as \xff.
std::string escaped_to_utf8(std::string_view bytes);

/// Throws InputError that shows the first word that is not UTF-8: all that the program writes (TOML, JSON,
/// HTML) is, so that such a name would fail at the end of the work.
void require_utf8(std::vector<std::string> const& words);

} // namespace mesobridge::workflows
