#include "workflows/command/list.hpp"
#include "workflows/command/options.hpp"
#include "workflows/pages/manual.hpp"
#include "workflows/text_file.hpp"
#include <CLI/CLI.hpp>

namespace mesobridge::workflows {
namespace {

Result write_manual(Context const& context) {
  auto const folder = context.output_directory("out/man/man1");
  auto const pages = pages_of(commands());
  Result result{.json = {{"files", Json::array()}}, .text = folder.string()};
  auto const write = [&](std::string const& name, std::string const& text) {
    write_text_file(folder / name, text);
    result.json["files"].push_back((folder / name).string());
  };
  write("mesobridge.1", manual_overview(pages));
  for (auto const& page : pages)
    write(manual_file(page), manual_page(page));
  return result;
}

} // namespace

Command::Action man_command(CLI::App&) {
  return write_manual;
}

} // namespace mesobridge::workflows
