#include "fitting/toml_depth.hpp"
#include "md/error.hpp"
#include <vector>

namespace mesobridge::fitting {

namespace {

/// Walks through a text character by character and keeps how deep it is.
class DepthScan {
 public:
  DepthScan(std::string_view text, std::string const& file) : text_(text), file_(file) {}

  void run() {
    while (at_ < text_.size()) {
      char const sign = text_[at_];
      if (sign == '"' || sign == '\'')
        skip_string(sign);
      else if (sign == '#')
        at_ = std::min(text_.find('\n', at_), text_.size());
      else
        take(sign), ++at_;
    }
  }

 private:
  void take(char sign) {
    switch (sign) {
    case '\n':
      ++line_;
      if (open_.empty())
        end_statement();
      return;
    case ' ':
    case '\t':
    case '\r':
      return;
    case '.':
      ++parts_;
      break;
    case ',':
      parts_ = 0;
      break;
    case '[':
    case '{':
      if (sign == '[' && (begins_ || heads_))
        begin_head();
      else
        open_.push_back(1 + parts_), sum_ += open_.back(), parts_ = 0;
      break;
    case ']':
    case '}':
      close();
      break;
    default:
      break;
    }
    begins_ = false;
    check();
  }

  /// [a.b] and [[a.b]]: what follows lies in it.
  void begin_head() {
    heads_ = true;
    head_ = 0;
  }

  void end_statement() {
    if (heads_)
      head_ = 1 + parts_;
    heads_ = false, begins_ = true;
    parts_ = 0;
  }

  void close() {
    if (heads_ || open_.empty())
      return;
    sum_ -= open_.back();
    open_.pop_back();
    parts_ = 0;
  }

  void check() const {
    if (head_ + sum_ + parts_ > deepest_toml)
      throw InputError(fmt::format("{}:{}: keys, tables and arrays lie more than {} deep in each other",
                                   file_, line_, deepest_toml));
  }

  /// Leaves the place behind a string; one that does not end is the parser's to refuse.
  void skip_string(char quote) {
    begins_ = false;
    std::string const three(3, quote);
    bool const many_lines = text_.substr(at_, 3) == three;
    for (at_ += many_lines ? 3 : 1; at_ < text_.size(); ++at_) {
      if (text_[at_] == '\n') {
        if (!many_lines)
          return;
        ++line_;
      } else if (text_[at_] == '\\' && quote == '"') {
        ++at_;
        line_ += at_ < text_.size() && text_[at_] == '\n' ? 1 : 0;
      } else if (many_lines ? text_.substr(at_, 3) == three : text_[at_] == quote) {
        at_ += many_lines ? 3 : 1;
        return;
      }
    }
  }

  std::string_view text_;
  std::string const& file_;
  std::size_t at_ = 0, line_ = 1;
  std::size_t head_ = 0;          ///< parts of the table's name
  std::size_t parts_ = 0;         ///< dots in the key or value at hand
  std::vector<std::size_t> open_; ///< for each open bracket, how much deeper it leads
  std::size_t sum_ = 0;           ///< of them
  bool begins_ = true;            ///< a statement begins here
  bool heads_ = false;            ///< within the name of a table
};

} // namespace

void refuse_deep_toml(std::string_view text, std::string const& file) {
  DepthScan(text, file).run();
}

} // namespace mesobridge::fitting
