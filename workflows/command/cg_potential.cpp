#include "md/error.hpp"
#include "workflows/coarse/potential_method.hpp"
#include "workflows/coarse/potential_output.hpp"
#include "workflows/command/options.hpp"
#include "workflows/summary.hpp"
#include "workflows/text_file.hpp"
#include <CLI/CLI.hpp>
#include <algorithm>

namespace mesobridge::workflows {
namespace {

struct CgPotentialOptions {
  PotentialWishes wishes;
  std::string method = "hnc";
  CLI::App const* parser = nullptr; ///< knows which options were given
};

PotentialMethod const& method_of(CgPotentialOptions const& options) {
  return *std::ranges::find(potential_methods(), options.method, &PotentialMethod::name);
}

/// Options that only other methods take.
void refuse_others(CgPotentialOptions const& options) {
  auto const& ours = method_of(options).options;
  for (auto const& other : potential_methods())
    for (auto const& name : other.options)
      require(
          options.parser->count(name) == 0 || std::ranges::find(ours, name) != ours.end(), name,
          options.method,
          fmt::format("has no use for it: it belongs to --method {} (--help tells the others)", other.name));
}

Result potential(CgPotentialOptions const& options, Context const& context) {
  refuse_others(options);
  auto const& wishes = options.wishes;
  auto found = method_of(options).find(wishes, options.method, context);
  auto const folder = wishes.input.parent_path();
  auto const directory = context.output_directory(folder.empty() ? "." : folder);
  Provenance provenance{.command = context.command_line(),
                        .seed = context.options.seed.value_or(1),
                        .scene = "",
                        .inputs = {wishes.input}};
  if (wishes.beside)
    provenance.inputs.push_back(*wishes.beside);
  Result result;
  result.json = std::move(found.json);
  result.json["method"] = options.method;
  result.json["units"] = units_text(found.head);
  result.json["provenance"] = provenance_json(provenance);
  write_text_file(directory / "potential.csv", potential_csv(found.potential));
  write_summary(directory / "potential.json", result.json);
  found.report.provenance = provenance;
  write_text_file(directory / "potential.html", found.report.html());
  result.text = found.text + (directory / "potential.csv").string();
  return result;
}

std::string methods_text() {
  std::string text = "What is matched, and how: ";
  for (auto const& method : potential_methods())
    text += fmt::format("{}, {}; ", method.name, method.summary);
  return text + "default hnc";
}

std::vector<std::string> method_names() {
  std::vector<std::string> names;
  for (auto const& method : potential_methods())
    names.push_back(method.name);
  return names;
}

void declare(CLI::App& app, CgPotentialOptions& options) {
  options.parser = &app;
  auto& wishes = options.wishes;
  auto& search = wishes.search;
  app.add_option("file", wishes.input,
                 "What `md star-melt` or `cg blobs` wrote; for force-matching, `md held-blobs` too")
      ->required()
      ->type_name("FILE.h5");
  app.add_option("--cutoff", wishes.cutoff,
                 "Of the potential (default: where g(r) is 1 within 0.02, 1.3 times that with --pressure)");
  app.add_option("--bin-width", wishes.width, "Of g(r) and the potential's rows (default 0.2)");
  app.add_option("--method", options.method, methods_text())->check(CLI::IsMember(method_names()));
  app.add_option("--share", search.inversion.share, "Of the full change that an iteration makes (default 1)");
  app.add_option("--iterations", search.iterations, "At most (default 20)");
  app.add_option("--enough", search.enough,
                 "Difference of the structures, and of P, at which it ends (default 1e-5)");
  app.add_option("--steps", search.sample, "Sampled by each trial (default 3000)");
  app.add_flag("--pressure", wishes.pressure, "Keep the molecules' pressure too, by a linear tail");
  app.add_option("--knots", wishes.knots,
                 "force-matching: most distance of the force's knots (default: two bins)");
  app.add_option("--beside", wishes.beside, "force-matching: another potential, with columns r,u, to compare")
      ->type_name("FILE.csv");
}

} // namespace

extern Declaration const cg_potential_command = with_options<CgPotentialOptions, declare, potential>;

} // namespace mesobridge::workflows
