#include "workflows/pages/schema.hpp"
#include "workflows/command/options.hpp"
#include "workflows/nearest.hpp"
#include "workflows/shared_options.hpp"
#include "workflows/text_file.hpp"

namespace mesobridge::workflows {
namespace {

std::vector<std::string> const kinds_of_files{"scene", "model"};

Json schema_named(std::string const& name) {
  if (name == "scene")
    return scene_schema();
  if (name == "model")
    return model_schema();
  refuse_unknown("kind of file", name, kinds_of_files);
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
  add_word(app, "kind", of, kinds_of_files);
}

} // namespace

extern Declaration const schema_command = with_options<std::string, declare_schema, write_schema>;

} // namespace mesobridge::workflows
