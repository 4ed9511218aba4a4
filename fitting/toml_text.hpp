#pragma once
#include <span>
#include <string>

namespace mesobridge::fitting {

/// Shortest text that reads back to the same bits, always a TOML float.
std::string exact(double x);
/// In quotation marks, with what needs it escaped.
std::string quoted(std::string const& text);
/// An array, four numbers a line.
std::string array(std::span<double const> values);

} // namespace mesobridge::fitting
