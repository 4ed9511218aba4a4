#include "workflows/command/star_commands.hpp"
#include "workflows/lj/preset.hpp"
#include "workflows/star/chapter.hpp"
#include "workflows/summary.hpp"
#include "workflows/text_file.hpp"
#include <CLI/CLI.hpp>

namespace mesobridge::workflows {

namespace {

Result star_polymers(std::string const& preset, Context const& context) {
  auto const directory = context.output_directory("out/star-polymers");
  std::uint64_t const seed = context.options.seed.value_or(1);
  auto const chapter = run_chapter(chapter_plan(preset_of(preset), seed), directory, context);
  auto report = chapter_report(chapter);
  report.provenance = {context.command_line(), seed, "", {}};
  Result result;
  result.json = chapter_summary(chapter);
  result.json["preset"] = preset;
  write_summary(directory / "summary.json", result.json);
  write_text_file(directory / "report.html", report.html());
  result.json["report"] = (directory / "report.html").string();
  result.text = (directory / "report.html").string();
  return result;
}

} // namespace

Command workflow_star_polymers_command() {
  return {.name = "workflow star-polymers",
          .summary = "Chapter 3 of the thesis: melts and isolated stars, key approximation, entropy, report",
          .example = "mesobridge workflow star-polymers --preset quick -o out/star-polymers",
          .declare = [](CLI::App& app) -> Command::Action {
            auto preset = std::make_shared<std::string>("quick");
            app.add_option("--preset", *preset,
                           "quick (minutes), standard (hours; goes on when run again) or paper")
                ->capture_default_str()
                ->check(CLI::IsMember({"quick", "standard", "paper"}));
            return [preset](Context& context) { return star_polymers(*preset, context); };
          }};
}

} // namespace mesobridge::workflows
