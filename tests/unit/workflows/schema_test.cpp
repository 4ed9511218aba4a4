#include "fitting/model_file.hpp"
#include "workflows/pages/schema.hpp"
#include "workflows/scene/keys.hpp"
#include "workflows/text_file.hpp"
#include <filesystem>
#include <gtest/gtest.h>
#include <sstream>
#include <toml++/toml.h>

namespace mesobridge::workflows {
namespace {

Json json_of(toml::table const& table) {
  std::ostringstream text;
  text << toml::json_formatter(table);
  return Json::parse(text.str());
}

Json json_of(std::filesystem::path const& file) {
  return json_of(toml::parse(read_text_file(file)));
}

bool has_type(Json const& value, std::string const& type) {
  return (type == "object" && value.is_object()) || (type == "array" && value.is_array()) ||
         (type == "string" && value.is_string()) || (type == "number" && value.is_number()) ||
         (type == "integer" && value.is_number_integer());
}

std::string fault(Json const& schema, Json const& value, std::string const& at);

std::string fault_of_members(Json const& schema, Json const& value, std::string const& at) {
  for (auto const& key : schema.value("required", Json::array()))
    if (!value.contains(key.get<std::string>()))
      return at + " lacks " + key.get<std::string>();
  for (auto const& [key, member] : value.items()) {
    auto const& known = schema["properties"];
    if (!known.contains(key))
      return at + " knows no " + key;
    if (known[key].is_object())
      if (auto const found = fault(known[key], member, at + "." + key); !found.empty())
        return found;
  }
  return {};
}

/// What is wrong with a value by the part of JSON Schema that ours are written in; empty: nothing.
std::string fault(Json const& schema, Json const& value, std::string const& at) {
  for (char const* several : {"anyOf", "oneOf"})
    if (schema.contains(several)) {
      std::string all;
      int good = 0;
      for (auto const& one : schema[several]) {
        auto const found = fault(one, value, at);
        good += found.empty(), all += found + "; ";
      }
      if (good < 1 || (good > 1 && std::string(several) == "oneOf"))
        return all;
    }
  if (schema.contains("type")) {
    auto const types = schema["type"].is_array() ? schema["type"] : Json::array({schema["type"]});
    if (std::ranges::none_of(types, [&](auto const& type) { return has_type(value, type); }))
      return at + " is no " + types.dump();
  }
  if (schema.contains("const") && schema["const"] != value)
    return at + " is not " + schema["const"].dump();
  if (schema.contains("enum") && std::ranges::find(schema["enum"], value) == schema["enum"].end())
    return at + " is none of " + schema["enum"].dump();
  if (value.is_number()) {
    double const x = value;
    if (x < schema.value("minimum", x) || x > schema.value("maximum", x) ||
        (schema.contains("exclusiveMinimum") && x <= schema["exclusiveMinimum"].get<double>()))
      return at + " is out of bounds";
  }
  if (value.is_array() && schema.contains("items"))
    for (auto const& item : value)
      if (auto const found = fault(schema["items"], item, at + "[]"); !found.empty())
        return found;
  return value.is_object() && schema.contains("properties") ? fault_of_members(schema, value, at) : "";
}

std::vector<std::filesystem::path> files_in(char const* folder) {
  std::vector<std::filesystem::path> files;
  for (auto const& entry :
       std::filesystem::directory_iterator(std::filesystem::path(MESOBRIDGE_SOURCE_DIR) / folder))
    if (entry.path().extension() == ".toml")
      files.push_back(entry.path());
  return files;
}

TEST(SceneSchema, TakesEveryExampleScene) {
  auto const schema = scene_schema();
  auto const scenes = files_in("workflows/scenes");
  EXPECT_GT(scenes.size(), 8u);
  for (auto const& file : scenes)
    EXPECT_EQ(fault(schema, json_of(file), ""), "") << file;
}

TEST(SceneSchema, ExplainsEveryKey) {
  auto const schema = scene_schema();
  for (auto const& key : scene_keys()) {
    auto const& table = key.section.empty() ? schema : schema["properties"][key.section];
    EXPECT_TRUE(table["properties"][key.name].contains("description")) << key.path();
  }
}

TEST(SceneSchema, MarksWhatIsWrong) {
  auto const good =
      json_of(std::filesystem::path(MESOBRIDGE_SOURCE_DIR) / "workflows/scenes/argon-1000K.toml");
  struct Wrong {
    char const *pointer, *value, *says;
  };
  for (auto const& [pointer, value, says] :
       {Wrong{"/units", "\"metric\"", "units is none of"}, Wrong{"/particles/Kay", "3", "knows no Kay"},
        Wrong{"/run/steps", "0.5", "steps is no"}, Wrong{"/particles/h_factor", "-1", "out of bounds"},
        Wrong{"/scheme/name", "\"sas\"", "none of"}, Wrong{"/fluid/rho", "true", "rho is no"}}) {
    auto scene = good;
    scene[Json::json_pointer(pointer)] = Json::parse(value);
    EXPECT_NE(fault(scene_schema(), scene, "").find(says), std::string::npos)
        << pointer << ": " << fault(scene_schema(), scene, "");
  }
}

TEST(ModelSchema, TakesEveryModelThatIsWritten) {
  auto const schema = model_schema();
  for (auto const& file : files_in("workflows/scenes/models"))
    EXPECT_EQ(fault(schema, json_of(file), ""), "") << file;
  for (auto const& material : fitting::materials()) {
    auto const text = fitting::to_toml({.eos = material.eos});
    EXPECT_EQ(fault(schema, json_of(toml::parse(text)), ""), "") << material.name;
  }
}

TEST(ModelSchema, MarksWhatIsWrong) {
  auto const file = files_in("workflows/scenes/models").front();
  auto model = json_of(file);
  model["kind"] = "jlw";
  EXPECT_NE(fault(model_schema(), model, ""), "");
  model = json_of(file);
  model[model["kind"] == "jwl" ? "jwl" : "mie_gruneisen"].erase("rho_0_kg_m3");
  EXPECT_NE(fault(model_schema(), model, "").find("lacks rho_0_kg_m3"), std::string::npos);
}

} // namespace
} // namespace mesobridge::workflows
