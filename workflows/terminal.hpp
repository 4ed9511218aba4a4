#pragma once
#include <cstddef>
#include <string>
#include <string_view>

namespace mesobridge::workflows {

/// How many characters a line of the terminal holds that a descriptor (1: stdout, 2: stderr) reaches, or else
/// what the variable COLUMNS says; 80 where neither tells.
std::size_t columns_of(int descriptor);

/// Columns that a text (UTF-8) takes on a terminal.
std::size_t display_width(std::string_view text);

/// The text in at most so many columns: one that is too long ends in "…". Control characters, which would
/// break a line that is redrawn, become blanks.
std::string fitted(std::string_view text, std::size_t columns);

/// The text in lines of at most so many columns, broken at blanks (words that are longer stay whole); every
/// line but the first begins with `indent` blanks. Line ends of the text stay.
std::string wrapped(std::string_view text, std::size_t columns, std::size_t indent);

} // namespace mesobridge::workflows
