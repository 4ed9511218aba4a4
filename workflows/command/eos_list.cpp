#include "fitting/eos/list.hpp"
#include "md/error.hpp"
#include "workflows/command/list.hpp"

namespace mesobridge::workflows {

namespace {

Result list(Context&) {
  Result result;
  result.json["models"] = Json::array();
  for (auto const& material : fitting::materials()) {
    result.json["models"].push_back({{"name", material.name}, {"description", material.description}});
    result.text += fmt::format("{:<22} {}\n", material.name, material.description);
  }
  return result;
}

} // namespace

Command eos_list_command() {
  return {.name = "eos list",
          .summary = "The equations of state that need no file",
          .example = "mesobridge eos list",
          .declare = [](CLI::App&) -> Command::Action { return list; }};
}

} // namespace mesobridge::workflows
