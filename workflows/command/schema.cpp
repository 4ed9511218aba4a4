#include "workflows/pages/schema.hpp"
#include "md/error.hpp"
#include "workflows/command/options.hpp"
#include "workflows/nearest.hpp"
#include "workflows/text_file.hpp"
#include <CLI/CLI.hpp>

namespace mesobridge::workflows {
namespace {

Json schema_named(std::string const& name) {
  if (name == "scene")
    return scene_schema();
  if (name == "model")
    return model_schema();
  throw InputError(fmt::format("unknown kind of file '{}'{}; known: scene, model", name,
                               did_you_mean(name, std::vector<std::string>{"scene", "model"})));
}

Result write_schema(std::string const& of, Context const& context) {
  auto const schema = schema_named(of);
  if (!context.options.output)
    return {.json = schema, .text = schema.dump(2)};
  auto const& file = *context.options.output;
  write_text_file(file, schema.dump(2) + "\n");
  return {.json = {{"schema", of}, {"file", file.string()}},
          .text = fmt::format("{}\nThe first line \"#:schema {}\" of a file lets editors take it",
                              file.string(), file.string())};
}

void declare_schema(CLI::App& app, std::string& of) {
  app.add_option("of", of, "What it describes: scene or model")->required()->type_name("scene|model");
}

} // namespace

extern Declaration const schema_command = with_options<std::string, declare_schema, write_schema>;

} // namespace mesobridge::workflows
