#include "md/input_lines.hpp"
#include <charconv>
#include <fmt/ranges.h>
#include <fstream>
#include <sstream>

namespace mesobridge::md {
namespace {

std::string trimmed_end(std::string text) {
  while (!text.empty() && (text.back() == ' ' || text.back() == '\t' || text.back() == '\r'))
    text.pop_back();
  return text;
}

/// Words between blanks, those in quotes as one.
std::vector<std::string> words_of(std::string const& text) {
  std::vector<std::string> words;
  bool inside = false;
  char quote = 0;
  for (char const c : text) {
    bool const blank = c == ' ' || c == '\t' || c == '\r';
    if (quote == 0 && blank) {
      inside = false;
      continue;
    }
    if (!inside)
      words.emplace_back();
    inside = true;
    if (quote == 0 && (c == '"' || c == '\''))
      quote = c;
    else if (c == quote)
      quote = 0;
    words.back() += c;
  }
  return words;
}

template <class Number>
Number parsed(InputLine const& line, std::size_t word, std::string const& what, char const* kind) {
  if (word >= line.words.size())
    refuse_line(line, fmt::format("{} is missing in '{}'", what, line.text()));
  auto const& text = line.words[word];
  Number value{};
  auto const* const begin = text.data() + (text.starts_with('+') ? 1 : 0);
  auto const [end, error] = std::from_chars(begin, text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(double(value)))
    refuse_line(line, fmt::format("{} = '{}': must be a {} number", what, text, kind));
  return value;
}

} // namespace

std::string InputLine::text() const {
  return fmt::format("{}", fmt::join(words, " "));
}

void refuse_line(InputLine const& line, std::string const& why) {
  throw InputError(fmt::format("{}: {}", line.origin, why));
}

std::vector<InputLine> read_input_lines(std::filesystem::path const& file, bool joined) {
  std::ifstream in(file);
  if (!in || std::filesystem::is_directory(file))
    throw InputError(fmt::format("cannot read '{}'", file.string()));
  std::vector<InputLine> lines;
  bool goes_on = false;
  int number = 0;
  for (std::string text; std::getline(in, text);) {
    ++number;
    auto const mark = text.find('#');
    std::string comment = mark == text.npos ? "" : trimmed_end(text.substr(mark + 1));
    comment.erase(0, comment.find_first_not_of(" \t"));
    text = trimmed_end(text.substr(0, mark));
    if (!goes_on)
      lines.push_back(
          {.origin = fmt::format("{}:{}", file.string(), number), .words = {}, .comment = comment});
    goes_on = joined && text.ends_with('&');
    if (goes_on)
      text.pop_back();
    auto const words = words_of(text);
    lines.back().words.insert(lines.back().words.end(), words.begin(), words.end());
  }
  return lines;
}

double number_in(InputLine const& line, std::size_t word, std::string const& what) {
  return parsed<double>(line, word, what, "finite");
}

std::int64_t whole_in(InputLine const& line, std::size_t word, std::string const& what) {
  return parsed<std::int64_t>(line, word, what, "whole");
}

} // namespace mesobridge::md
