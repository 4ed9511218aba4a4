#include "workflows/pages/schema.hpp"
#include "workflows/scene/keys.hpp"
#include <fmt/ranges.h>

namespace mesobridge::workflows {
namespace {

Json type_of(bool quantity, Json plain) {
  return quantity ? Json::array({"string", plain}) : plain;
}

/// One number or text, or what a list holds.
Json element(SceneKey const& key, Json type) {
  Json schema{{"type", std::move(type)}};
  if (!key.choices.empty())
    schema["enum"] = key.choices;
  else if (!key.dimension)
    put_bounds(schema, key.range);
  return schema;
}

Json list_of(SceneKey const& key, Json const& type) {
  Json schema{{"type", "array"}, {"items", element(key, type)}};
  bool const numbers = type != "string";
  if (numbers && !key.any_length)
    schema["maxItems"] = 3;
  return schema;
}

/// What the kind of slot says of a key's value.
struct SchemaOfSlot {
  SceneKey const& key;
  Json number() const { return type_of(key.dimension.has_value(), "number"); }

  Json operator()(std::string*) const { return element(key, "string"); }
  Json operator()(std::optional<std::string>*) const { return element(key, "string"); }
  Json operator()(std::int64_t*) const { return element(key, "integer"); }
  Json operator()(double*) const { return element(key, number()); }
  Json operator()(std::optional<double>*) const { return element(key, number()); }
  Json operator()(std::vector<std::string>*) const { return list_of(key, "string"); }
  Json operator()(std::vector<std::int64_t>*) const { return list_of(key, "integer"); }
  Json operator()(std::vector<double>*) const { return list_of(key, number()); }
  /// One place is one along the region's axis.
  Json operator()(std::vector<Coordinate>*) const {
    auto const place = Json::array({"string", "number"});
    return {{"anyOf", {element(key, place), list_of(key, place)}}};
  }
  Json operator()(TimeStep*) const { return element(key, Json::array({"string", "number"})); }
  Json operator()(UnitSystem*) const { return element(key, "string"); }
};

Json schema_of(SceneKey const& key) {
  Scene scene;
  auto schema = std::visit(SchemaOfSlot{key}, key.slot(scene));
  auto text = key.meaning;
  if (!key.methods.empty())
    text += fmt::format(" (of {})", fmt::join(key.methods, ", "));
  schema["description"] = text + "; " + key.allowed(UnitSystem::SI);
  return schema;
}

Json table() {
  return {{"type", "object"}, {"properties", Json::object()}, {"additionalProperties", false}};
}

void add(Json& into, SceneKey const& key) {
  into["properties"][key.name] = schema_of(key);
  if (key.required && key.methods.empty())
    into["required"].push_back(key.name);
}

} // namespace

Json scene_schema() {
  Json schema{{"$schema", "http://json-schema.org/draft-07/schema#"},
              {"title", "A scene of mesobridge"},
              {"description", "What `mesobridge run` takes; `mesobridge check` refuses what keys do to each "
                              "other, which stands not here"}};
  schema.update(table());
  for (auto const& key : scene_keys()) {
    auto& tables = schema["properties"];
    if (!key.section.empty() && !tables.contains(key.section))
      tables[key.section] = table();
    add(key.section.empty() ? schema : tables[key.section], key);
  }
  Json region = table();
  for (auto const& key : region_keys(0))
    add(region, key);
  schema["properties"]["region"] = {{"type", "array"}, {"items", region}};
  return schema;
}

} // namespace mesobridge::workflows
