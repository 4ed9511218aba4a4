#pragma once
#include <fmt/format.h>
#include <optional>
#include <string>
#include <vector>

namespace mesobridge::workflows {

/// Words of a call of this program.
struct CallWords {
  std::vector<std::string> words;

  template <class Value>
  CallWords& add(char const* option, Value const& value) {
    words.emplace_back(option);
    words.push_back(fmt::format("{}", value));
    return *this;
  }
  /// Nothing where there is no value.
  template <class Value>
  CallWords& add(char const* option, std::optional<Value> const& value) {
    return value ? add(option, *value) : *this;
  }
  /// The option once for each value.
  template <class Value>
  CallWords& add(char const* option, std::vector<Value> const& values) {
    for (auto const& value : values)
      add(option, value);
    return *this;
  }
};

} // namespace mesobridge::workflows
