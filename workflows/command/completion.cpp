#include "workflows/pages/completion.hpp"
#include "workflows/command/list.hpp"
#include "workflows/command/options.hpp"
#include "workflows/shared_options.hpp"
#include "workflows/text_file.hpp"

namespace mesobridge::workflows {
namespace {

Result complete(std::string const& shell, Context const& context) {
  auto const script = completion_script(shell, pages_of(commands()));
  if (!context.options.output)
    return {.json = {{"shell", shell}, {"script", script}}, .text = script};
  write_text_file(*context.options.output, script);
  return {.json = {{"shell", shell}, {"file", context.options.output->string()}},
          .text = context.options.output->string()};
}

void declare_completion(CLI::App& app, std::string& shell) {
  add_word(app, "shell", shell, known_shells());
}

} // namespace

extern Declaration const completion_command = with_options<std::string, declare_completion, complete>;

} // namespace mesobridge::workflows
