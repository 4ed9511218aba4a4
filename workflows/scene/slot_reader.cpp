#include "workflows/scene/slot_reader.hpp"
#include "md/error.hpp"
#include "workflows/nearest.hpp"
#include <algorithm>
#include <charconv>
#include <cmath>

namespace mesobridge::workflows {

std::optional<std::string> name_of_today(SceneKey const& key, std::string const& text) {
  auto const found = std::ranges::find(key.former, text, &std::pair<std::string, std::string>::first);
  return found == key.former.end() ? std::nullopt : std::optional(found->second);
}

namespace {

/// Of one node and its key.
struct SlotReader {
  toml::node const& node;
  SceneKey const& key;
  UnitSystem units;

  [[noreturn]] void refuse() const { throw InputError("must be " + key.allowed(units)); }

  std::string text() const { return text(node); }

  std::string text(toml::node const& of) const {
    auto value = of.value_exact<std::string>();
    if (!value)
      refuse();
    if (auto const now = name_of_today(key, *value))
      value = *now;
    if (!key.choices.empty() &&
        std::find(key.choices.begin(), key.choices.end(), *value) == key.choices.end())
      throw InputError("must be " + key.allowed(units) + did_you_mean(*value, key.choices));
    return *value;
  }

  double number(toml::node const& of) const {
    auto const whole = of.value_exact<std::int64_t>(); // value<double>() is empty for those above 2^53
    auto const value = whole ? static_cast<double>(*whole) : of.value_exact<double>();
    if (!value || !key.range.contains(*value))
      refuse();
    return *value;
  }

  std::int64_t integer(toml::node const& of) const {
    auto const value = of.value_exact<std::int64_t>();
    if (!value || !key.range.contains(static_cast<double>(*value)))
      refuse();
    return *value;
  }

  /// read(element) of every element of a list.
  template <class Value, class Read>
  void fill(std::vector<Value>& values, Read const& read) const {
    auto const* list = node.as_array();
    if (!list)
      refuse();
    values.clear();
    for (auto const& element : *list)
      values.push_back(read(element));
  }

  double quantity(toml::node const& of) const {
    if (!key.dimension || units == UnitSystem::lj)
      return number(of);
    if (!of.is_string())
      throw InputError(fmt::format("a unit is missing; must be {}", key.allowed(units)));
    double const value = parse_quantity(*of.value_exact<std::string>(), *key.dimension);
    if (!key.range.contains(value))
      refuse();
    return value;
  }

  /// A length, or "50 %".
  Coordinate coordinate(toml::node const& of) const {
    auto const text = of.value_exact<std::string>().value_or("");
    if (!text.ends_with('%'))
      return {quantity(of)};
    double share = 0;
    auto const [end, error] = std::from_chars(text.data(), text.data() + text.size(), share);
    std::string_view const rest(end, text.data() + text.size());
    if (error != std::errc() || !std::isfinite(share) || (rest != " %" && rest != "%"))
      refuse();
    return {share, true};
  }

  void operator()(std::string* slot) const { *slot = text(); }
  void operator()(std::optional<std::string>* slot) const { *slot = text(); }
  void operator()(UnitSystem* slot) const { *slot = text() == "SI" ? UnitSystem::SI : UnitSystem::lj; }
  void operator()(double* slot) const { *slot = quantity(node); }
  void operator()(std::optional<double>* slot) const { *slot = quantity(node); }
  void operator()(std::int64_t* slot) const { *slot = integer(node); }
  void operator()(std::vector<std::string>* slot) const {
    fill(*slot, [&](auto const& element) {
      auto word = text(element);
      require(std::find(slot->begin(), slot->end(), word) == slot->end(), "a text of the list", word,
              "must stand there once");
      return word;
    });
  }
  void operator()(std::vector<std::int64_t>* slot) const {
    fill(*slot, [&](auto const& element) { return integer(element); });
  }
  void operator()(std::vector<double>* slot) const {
    auto const* list = node.as_array();
    if (!list && key.any_length)
      throw InputError("must be a list, each " + key.allowed(units));
    if (!list || (list->size() != 3 && !key.any_length))
      throw InputError("must be three, along x, y and z, each " + key.allowed(units));
    slot->clear();
    for (auto const& element : *list)
      slot->push_back(quantity(element));
  }
  void operator()(std::vector<Coordinate>* slot) const {
    slot->clear();
    if (auto const* list = node.as_array())
      for (auto const& element : *list)
        slot->push_back(coordinate(element));
    else
      slot->push_back(coordinate(node));
    if (slot->size() != 1 && slot->size() != 3)
      throw InputError("must be one place, or three, along x, y and z");
  }
  void operator()(TimeStep* slot) const {
    if (node.value_exact<std::string>() == "auto") {
      *slot = {.automatic = true};
      return;
    }
    *slot = node.is_number()          ? TimeStep{number(node), true}
            : units == UnitSystem::SI ? TimeStep{quantity(node), false}
                                      : TimeStep{lj_time(), false};
  }

  /// "0.05 tau"
  double lj_time() const {
    auto const written = text();
    double value = 0;
    auto const [end, error] = std::from_chars(written.data(), written.data() + written.size(), value);
    std::string_view const rest(end, written.data() + written.size());
    if (error != std::errc() || !key.range.contains(value) || (rest != " tau" && rest != "tau"))
      refuse();
    return value;
  }
};

} // namespace

void read_slot(toml::node const& node, SceneKey const& key, UnitSystem units, Slot const& slot) {
  std::visit(SlotReader{node, key, units}, slot);
}

} // namespace mesobridge::workflows
