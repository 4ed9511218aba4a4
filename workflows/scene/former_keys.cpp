#include "workflows/scene/former_keys.hpp"
#include "md/error.hpp"

namespace mesobridge::workflows {
namespace {

/// scheme.noise = "off" of method.name = "sdpd" is the method "sph".
std::string read_noise(toml::table& scene, toml::table& scheme, Places& places) {
  std::string const path = "scheme.noise";
  places.note(path, scheme.get("noise")->source().begin.line);
  auto const value = scheme["noise"].value_or(std::string());
  require_together(
      value == "on" || value == "off", places, path, value,
      "is a former key, whose values were \"on\" and \"off\": leave it out, or say method.name = "
      "\"sph\" for particles without noise");
  scheme.erase("noise");
  auto const method = scene["method"]["name"].value_or(std::string("sdpd"));
  std::string const expected = value == "on" ? "sdpd" : "sph";
  require_together(method == expected || method == "sdpd", places, path, value,
                   "contradicts method.name = \"" + method + "\"");
  if (method != expected) {
    if (!scene.contains("method"))
      scene.insert("method", toml::table{});
    if (auto* const table =
            scene["method"].as_table()) // else it is refused like any value in a table's place
      table->insert_or_assign("name", expected);
  }
  return places.of(path) + ": " + path + " = \"" + value +
         "\": " + (value == "on" ? "need not be said any more" : "is method.name = \"sph\" now");
}

} // namespace

std::vector<std::string> read_former_keys(toml::table& scene, Places& places) {
  std::vector<std::string> notes;
  if (auto* const scheme = scene["scheme"].as_table(); scheme && scheme->contains("noise"))
    notes.push_back(read_noise(scene, *scheme, places));
  return notes;
}

} // namespace mesobridge::workflows
