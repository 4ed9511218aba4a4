#pragma once
#include "md/error.hpp"
#include "workflows/unpacked_lines.hpp"
#include <charconv>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace mesobridge::workflows {

/// The file ends where a line should be.
struct EndOfFile {};

/// The words between blanks.
std::vector<std::string_view> words_of(std::string_view text);

/// The lines of a file, packed or not, numbered. A last line without an end is none: it was cut off.
class DumpLines {
 public:
  /// Throws InputError for a file that cannot be read.
  explicit DumpLines(std::filesystem::path const& file) : file_(file), lines_(file) {}

  /// Throws EndOfFile.
  std::string const& next();
  std::int64_t number() const { return number_; }
  bool packed() const { return lines_.packed(); }
  bool cut() const { return lines_.cut(); }
  /// Throws InputError with file and line.
  [[noreturn]] void refuse(std::string const& what) const;

  template <class Number>
  Number as(std::string_view word, std::string const& what) const {
    Number value{};
    auto const start = word.starts_with('+') ? word.substr(1) : word;
    auto const [end, error] = std::from_chars(start.data(), start.data() + start.size(), value);
    bool whole = error == std::errc() && end == start.data() + start.size();
    if constexpr (std::is_floating_point_v<Number>)
      whole = whole && std::isfinite(value);
    if (!whole)
      refuse(fmt::format("{} = '{}': must be a {}", what, word,
                         std::is_floating_point_v<Number> ? "finite number" : "whole number"));
    return value;
  }

 private:
  std::filesystem::path file_;
  UnpackedLines lines_;
  std::string text_;
  std::int64_t number_ = 0;
};

} // namespace mesobridge::workflows
