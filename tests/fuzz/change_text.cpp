#include "fuzz/change_text.hpp"
#include "workflows/text_file.hpp"
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <regex>

namespace mesobridge::fuzz {
namespace {

using workflows::read_text_file, workflows::write_text_file;

std::vector<std::string> lines_of(std::string const& text) {
  std::vector<std::string> lines;
  for (std::size_t begin = 0; begin < text.size();) {
    auto const end = std::min(text.find('\n', begin), text.size());
    lines.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return lines;
}

std::string joined(std::vector<std::string> const& lines, char const* between) {
  std::string text;
  for (auto const& line : lines)
    text += line + between;
  return text;
}

/// Another number of the same kind: what a slip of the finger or of a unit makes.
std::string scaled(Random& random, std::string const& number) {
  static std::vector<double> const factors{1.01, 1.5, 2, 0.5, 10, 0.1, 1000, 0.001, 1e6, 1e-6, -1};
  double const value = std::strtod(number.c_str(), nullptr) * random.of(factors);
  bool const whole = number.find_first_of(".eE") == std::string::npos && std::abs(value) < 1e15;
  return whole && random.chance(0.8) ? fmt::format("{}", std::llround(value)) : fmt::format("{:.9g}", value);
}

/// Replaces one of the numbers in the text.
std::string change_number(Random& random, std::string& text) {
  static std::regex const number(R"([-+]?\d+(\.\d*)?([eE][-+]?\d+)?)");
  std::vector<std::pair<std::size_t, std::size_t>> places;
  for (auto it = std::sregex_iterator(text.begin(), text.end(), number); it != std::sregex_iterator(); ++it)
    places.emplace_back(it->position(), it->length());
  if (places.empty())
    return "nothing";
  auto const [at, length] = random.of(places);
  auto const old = text.substr(at, length);
  auto const fresh = random.chance(0.6) ? scaled(random, old) : odd_number(random);
  text.replace(at, length, fresh);
  return fmt::format("{} -> {}", old, fresh);
}

std::string change_line(Random& random, std::string& text) {
  auto lines = lines_of(text);
  if (lines.empty())
    return "nothing";
  std::size_t const at = random.below(lines.size()), other = random.below(lines.size());
  auto const place = lines.begin() + static_cast<std::ptrdiff_t>(at);
  std::string done;
  switch (random.below(5)) {
  case 0:
    lines.erase(place), done = "without";
    break;
  case 1:
    lines.insert(place, lines[other]), done = fmt::format("line {} again before", other + 1);
    break;
  case 2:
    std::swap(lines[at], lines[other]), done = fmt::format("line {} for", other + 1);
    break;
  case 3:
    lines[at] = lines[at].substr(0, random.below(lines[at].size() + 1)), done = "cut";
    break;
  default:
    lines.insert(place, ""), done = "blank before";
    break;
  }
  text = joined(lines, "\n");
  return fmt::format("{} line {}", done, at + 1);
}

/// What programs on other systems make of the whole file.
std::string change_form(Random& random, std::string& text) {
  switch (random.below(8)) {
  case 0:
    text = "\xef\xbb\xbf" + text;
    return "byte-order mark";
  case 1:
    text = joined(lines_of(text), "\r\n");
    return "CRLF";
  case 2:
    text = joined(lines_of(text), "\r");
    return "CR";
  case 3:
    std::ranges::replace(text, ',', ';');
    return "semicolons";
  case 4:
    std::ranges::replace(text, ' ', '\t');
    return "tabs";
  case 5:
    std::ranges::replace(text, '.', ',');
    return "decimal commas";
  case 6:
    text.resize(random.below(text.size() + 1));
    return fmt::format("cut at byte {}", text.size());
  default:
    text.clear();
    return "empty";
  }
}

std::string change_character(Random& random, std::string& text) {
  static std::vector<std::string> const odd{"",     "\"",       "'", "[",  "]",
                                            "{",    "=",        "#", ",",  ".",
                                            "-",    "\n",       " ", "\\", std::string(1, '\0'),
                                            "\xff", "\xc3\xa4", "e", "_",  "999999999999999999999"};
  std::size_t const at = random.below(text.size() + 1);
  auto const fresh = random.of(odd);
  text.replace(at, random.below(3), fresh);
  return fmt::format("'{}' at byte {}", fresh, at);
}

std::string change_word(Random& random, std::string& text) {
  static std::regex const word(R"([A-Za-z_][A-Za-z_0-9]*)");
  std::vector<std::pair<std::size_t, std::size_t>> places;
  for (auto it = std::sregex_iterator(text.begin(), text.end(), word); it != std::sregex_iterator(); ++it)
    places.emplace_back(it->position(), it->length());
  if (places.size() < 2)
    return "nothing";
  auto const [from, length] = random.of(places);
  auto const fresh = text.substr(from, length);
  auto const [at, old] = random.of(places);
  text.replace(at, old, fresh);
  return fmt::format("word '{}' at byte {}", fresh, at);
}

} // namespace

std::string odd_number(Random& random) {
  static std::vector<std::string> const odd{"nan",
                                            "inf",
                                            "-inf",
                                            "0",
                                            "-0",
                                            "-1",
                                            "1",
                                            "2",
                                            "1e308",
                                            "-1e308",
                                            "1e-308",
                                            "5e-324",
                                            "1e400",
                                            "1e9",
                                            "1e18",
                                            "9223372036854775807",
                                            "-9223372036854775808",
                                            "18446744073709551616",
                                            "4294967296",
                                            "2147483648",
                                            "0.5",
                                            "1e-9",
                                            "1.0",
                                            "1e6",
                                            "1,5",
                                            "0x10",
                                            "1e",
                                            "--1",
                                            "",
                                            "abc",
                                            "true",
                                            "\"1\"",
                                            "[1]",
                                            "1_000",
                                            "+1",
                                            ".5",
                                            "3."};
  return random.of(odd);
}

std::string change_text(Random& random, std::filesystem::path const& file) {
  auto text = read_text_file(file);
  std::vector<std::string> done;
  for (std::size_t left = 1 + random.below(3); left > 0; --left) {
    std::size_t const what = random.below(10);
    done.push_back(what < 4   ? change_number(random, text)
                   : what < 6 ? change_line(random, text)
                   : what < 7 ? change_form(random, text)
                   : what < 8 ? change_word(random, text)
                              : change_character(random, text));
  }
  write_text_file(file, text);
  return fmt::format("{}: {}", file.filename().string(), fmt::join(done, "; "));
}

std::string change_bytes(Random& random, std::filesystem::path const& file) {
  auto bytes = read_text_file(file);
  if (bytes.empty())
    return "nothing";
  std::size_t const at = random.below(bytes.size());
  std::string done;
  switch (random.below(5)) {
  case 0:
    bytes[at] = static_cast<char>(bytes[at] ^ (1 << random.below(8))), done = "a bit flipped";
    break;
  case 1:
    for (std::size_t k = 0; k < 16; ++k)
      bytes[random.below(bytes.size())] = static_cast<char>(random.bits());
    done = "sixteen bytes changed, not";
    break;
  case 2:
    std::fill_n(bytes.begin() + static_cast<std::ptrdiff_t>(at),
                std::min<std::size_t>(4096, bytes.size() - at), '\0'),
        done = "zeros";
    break;
  case 3:
    bytes.resize(at), done = "cut";
    break;
  default:
    bytes.append(1 + random.below(9000), static_cast<char>(random.bits())), done = "a tail, not";
    break;
  }
  write_text_file(file, bytes);
  return fmt::format("{}: {} at byte {}", file.filename().string(), done, at);
}

} // namespace mesobridge::fuzz
