#pragma once
#include "sdpd/method/list.hpp"
#include "workflows/scene/keys.hpp"
#include <utility>

namespace mesobridge::workflows {

inline constexpr NumberRange at_least_one{.min = 1};

/// Builds one line of the table: what is not said stays at SceneKey's default.
struct Line {
  SceneKey key;
  Line(std::string section, std::string name, std::function<Slot(Scene&)> slot, std::string meaning) {
    key.section = std::move(section);
    key.name = std::move(name);
    key.slot = std::move(slot);
    key.meaning = std::move(meaning);
  }
  template <class... Methods>
  Line of() && {
    for (auto const& names : {sdpd::names_of<Methods>()...})
      key.methods.insert(key.methods.end(), names.begin(), names.end());
    return std::move(*this);
  }
  Line written_if(std::function<bool(Scene const&)> condition) && {
    return key.written = std::move(condition), std::move(*this);
  }
  Line of_any_length() && { return key.any_length = true, std::move(*this); }
  Line required() && { return key.required = true, std::move(*this); }
  Line choices(std::vector<std::string> c) && { return key.choices = std::move(c), std::move(*this); }
  Line formerly(std::string old, std::string now) && {
    return key.former.emplace_back(std::move(old), std::move(now)), std::move(*this);
  }
  Line in(NumberRange range) && { return key.range = range, std::move(*this); }
  Line quantity(Dimension dimension, NumberRange range) && {
    key.dimension = dimension;
    key.range = range;
    return std::move(*this);
  }
  operator SceneKey() && { return std::move(key); }
};

/// One table of a scene: its name, and the part of the scene that its keys fill.
template <class Part>
struct Table {
  std::string section;
  Part Scene::*part;

  template <class Member>
  Line operator()(std::string name, Member Part::*member, std::string meaning) const {
    return {section, std::move(name), [part = part, member](Scene& s) -> Slot { return &(s.*part.*member); },
            std::move(meaning)};
  }
};

} // namespace mesobridge::workflows
