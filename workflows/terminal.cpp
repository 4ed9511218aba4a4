#include "workflows/terminal.hpp"
#include <algorithm>
#include <clocale>
#include <cstdlib>
#include <cwchar>
#include <memory>
#include <sys/ioctl.h>

namespace mesobridge::workflows {
namespace {

/// While it lives, this thread reads texts as UTF-8, whatever the user's locale.
class Utf8 {
 public:
  Utf8() : locale_(newlocale(LC_CTYPE_MASK, "C.UTF-8", nullptr)) {
    if (locale_)
      before_ = uselocale(locale_);
  }
  ~Utf8() {
    if (locale_)
      uselocale(before_), freelocale(locale_);
  }
  Utf8(Utf8 const&) = delete;
  Utf8& operator=(Utf8 const&) = delete;

 private:
  locale_t locale_, before_ = nullptr;
};

/// Calls f(character, columns) for each character; a byte that is none takes one column.
template <class F>
void for_each_character(std::string_view text, F const& f) {
  Utf8 const utf8;
  std::mbstate_t state{};
  while (!text.empty()) {
    wchar_t character = 0;
    std::size_t bytes = std::mbrtowc(&character, text.data(), text.size(), &state);
    bool const valid = bytes > 0 && bytes <= text.size();
    if (!valid)
      bytes = 1, state = {};
    int const width = valid ? wcwidth(character) : 1;
    f(text.substr(0, bytes), width);
    text.remove_prefix(bytes);
  }
}

} // namespace

std::size_t columns_of(int descriptor) {
  winsize size{};
  if (ioctl(descriptor, TIOCGWINSZ, &size) == 0 && size.ws_col > 0)
    return size.ws_col;
  constexpr std::size_t customary = 80;
  char const* const told = std::getenv("COLUMNS");
  long const columns = told ? std::strtol(told, nullptr, 10) : 0;
  return columns > 0 ? static_cast<std::size_t>(columns) : customary;
}

std::size_t display_width(std::string_view text) {
  std::size_t width = 0;
  for_each_character(
      text, [&](std::string_view, int columns) { width += static_cast<std::size_t>(std::max(columns, 0)); });
  return width;
}

std::string fitted(std::string_view text, std::size_t columns) {
  bool const cut = display_width(text) > columns;
  std::size_t const room = cut && columns > 0 ? columns - 1 : columns;
  std::string result;
  std::size_t taken = 0;
  bool full = false;
  for_each_character(text, [&](std::string_view character, int width) {
    auto const wide = static_cast<std::size_t>(width < 0 ? 1 : width); // of a control character: a blank
    full = full || taken + wide > room;
    if (full)
      return;
    result += width < 0 ? " " : character;
    taken += wide;
  });
  return cut && columns > 0 ? result + "…" : result;
}

std::string wrapped(std::string_view text, std::size_t columns, std::size_t indent) {
  std::string result;
  std::size_t at = indent; // the caller has written that much of the first line
  bool first_word = true;
  while (!text.empty()) {
    if (text.front() == '\n') {
      result += "\n" + std::string(indent, ' ');
      at = indent, first_word = true;
      text.remove_prefix(1);
      continue;
    }
    auto const end = std::min(text.find_first_of(" \n"), text.size());
    auto const word = text.substr(0, end);
    auto const width = display_width(word);
    if (!first_word && at + 1 + width > columns) {
      result += "\n" + std::string(indent, ' ');
      at = indent, first_word = true;
    }
    result += first_word ? "" : " ";
    result += word;
    at += width + (first_word ? 0 : 1);
    first_word = false;
    text.remove_prefix(end);
    if (!text.empty() && text.front() == ' ')
      text.remove_prefix(1);
  }
  return result;
}

} // namespace mesobridge::workflows
