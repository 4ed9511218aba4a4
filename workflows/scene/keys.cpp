#include "workflows/scene/keys.hpp"
#include "sdpd/method/list.hpp"
#include "workflows/scene/keys/tables.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/ranges.h>

namespace mesobridge::workflows {

namespace {

std::string type_name(SceneKey const& key) {
  struct Namer {
    std::string operator()(std::string*) const { return "a text"; }
    std::string operator()(std::optional<std::string>*) const { return "a text"; }
    std::string operator()(std::int64_t*) const { return "an integer"; }
    std::string operator()(double*) const { return "a number"; }
    std::string operator()(std::optional<double>*) const { return "a number"; }
    std::string operator()(std::vector<std::string>*) const { return "a list of texts"; }
    std::string operator()(std::vector<std::int64_t>*) const { return "a list of integers"; }
    std::string operator()(std::vector<double>*) const { return "a list of numbers"; }
    std::string operator()(std::vector<Coordinate>*) const { return "a place along each axis"; }
    std::string operator()(TimeStep*) const { return "a number"; }
    std::string operator()(UnitSystem*) const { return "a text"; }
  };
  Scene scene;
  return std::visit(Namer{}, key.slot(scene));
}

} // namespace

sdpd::Features Scene::features() const {
  auto features = sdpd::method_named(method.name).features;
  features.reacts = features.densities && reaction.product.has_value();
  features.walls = box.x == "walls" || box.y == "walls" || box.z == "walls";
  features.rough_walls = features.walls && box.slip == "none";
  features.body_force = box.body_force.value_or(0) != 0;
  return features;
}

bool Scene::noise() const {
  return sdpd::method_named(method.name).noise;
}

bool SceneKey::belongs_to(std::string const& method) const {
  return methods.empty() || std::ranges::find(methods, method) != methods.end();
}

bool SceneKey::is_list() const {
  Scene scene;
  return std::holds_alternative<std::vector<std::string>*>(slot(scene));
}

std::string SceneKey::allowed(UnitSystem units) const {
  if (!choices.empty()) {
    std::vector<std::string> words;
    for (auto const& choice : choices)
      words.push_back("\"" + choice + "\"");
    return fmt::format("{} {}", is_list() ? "a list of some of" : "one of", fmt::join(words, ", "));
  }
  Scene scene;
  bool const time_step = std::holds_alternative<TimeStep*>(slot(scene));
  auto text = type_name(*this);
  if (auto const limits = range.text(); !limits.empty())
    text += " " + limits;
  if (!dimension || (units == UnitSystem::lj && !time_step))
    return text;
  auto const with_unit = fmt::format("text with a unit ({})",
                                     units == UnitSystem::lj ? "\"0.05 tau\"" : allowed_units(*dimension));
  bool const place = std::holds_alternative<std::vector<Coordinate>*>(slot(scene));
  return time_step ? text + ", or such a number as " + with_unit + ", or \"auto\""
                   : text + " as " + with_unit + (place ? ", or a share of the edge such as \"50 %\"" : "");
}

std::vector<SceneKey> const& scene_keys() {
  static auto const keys = [] {
    std::vector<SceneKey> all;
    for (auto const& table :
         {title_and_method_keys(), fluid_keys(), particle_keys(), box_keys(), pair_fluid_keys(),
          transport_keys(), reaction_keys(), scheme_keys(), run_keys(), observe_keys(), output_keys()})
      all.insert(all.end(), table.begin(), table.end());
    return all;
  }();
  return keys;
}

} // namespace mesobridge::workflows
