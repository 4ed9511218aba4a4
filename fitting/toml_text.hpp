#pragma once
#include <map>
#include <span>
#include <string>

namespace mesobridge::fitting {

/// Shortest text that reads back to the same bits, always a TOML float.
std::string exact(double x);
/// In quotation marks, with what needs it escaped.
std::string quoted(std::string const& text);
/// An array, four numbers a line.
std::string array(std::span<double const> values);
/// The key `data_hash`; nothing for an empty one.
std::string data_hash_text(std::string const& hash);
/// The table [provenance]; nothing for an empty one.
std::string provenance_text(std::map<std::string, std::string> const& provenance);

} // namespace mesobridge::fitting
