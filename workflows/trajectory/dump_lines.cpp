#include "workflows/trajectory/dump_lines.hpp"
#include <algorithm>

namespace mesobridge::workflows {

std::vector<std::string_view> words_of(std::string_view text) {
  constexpr std::string_view blanks = " \t\r";
  std::vector<std::string_view> words;
  for (auto begin = text.find_first_not_of(blanks); begin != text.npos;) {
    auto const end = std::min(text.find_first_of(blanks, begin), text.size());
    words.push_back(text.substr(begin, end - begin));
    begin = text.find_first_not_of(blanks, end);
  }
  return words;
}

std::string const& DumpLines::next() {
  if (!lines_.next(text_))
    throw EndOfFile();
  ++number_;
  if (text_.ends_with('\r'))
    text_.pop_back();
  return text_;
}

void DumpLines::refuse(std::string const& what) const {
  throw InputError(fmt::format("{}:{}: {}", file_.string(), number_, what));
}

} // namespace mesobridge::workflows
