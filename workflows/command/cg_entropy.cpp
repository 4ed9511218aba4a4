#include "md/error.hpp"
#include "workflows/command/options.hpp"
#include "workflows/star/blob_analysis.hpp"
#include "workflows/summary.hpp"
#include <CLI/CLI.hpp>

namespace mesobridge::workflows {

namespace {

struct CgEntropyOptions {
  std::optional<std::filesystem::path> melt, vacuum, microcanonical;
  std::size_t order = 3;
};

Result entropy(CgEntropyOptions const& options, Context const& context) {
  EntropyFiles files{.melt = {}, .vacuum = {}, .microcanonical = {}, .order = options.order};
  Provenance provenance{
      .command = context.command_line(), .seed = context.options.seed.value_or(0), .scene = "", .inputs = {}};
  std::string units;
  auto const load = [&](std::optional<std::filesystem::path> const& file, std::optional<BlobData>& into) {
    if (!file)
      return;
    into = read_blobs(*file);
    auto const text = units_text(into->head);
    if (!units.empty() && text != units)
      throw InputError(
          fmt::format("'{}' is in units of {}, the file before in {}", file->string(), text, units));
    units = text;
    provenance.inputs.push_back(*file);
  };
  load(options.melt, files.melt);
  load(options.vacuum, files.vacuum);
  load(options.microcanonical, files.microcanonical);
  auto const routes = entropy_routes(std::move(files));
  auto const directory = context.output_directory("out/entropy");
  Result result;
  result.json = entropy_json(routes);
  result.json["units"] = units + ", k_B = 1, per molecule";
  result.json["provenance"] = provenance_json(provenance);
  auto const file = directory / "entropy.json";
  write_summary(file, result.json);
  result.text = entropy_text(routes) + file.string();
  return result;
}

void declare(CLI::App& app, CgEntropyOptions& options) {
  app.add_option("--melt", options.melt, "What `md star-melt` wrote")->type_name("FILE.h5");
  app.add_option("--vacuum", options.vacuum, "What `md star-vacuum --T` wrote")->type_name("FILE.h5");
  app.add_option("--vacuum-nve", options.microcanonical,
                 "What `md star-vacuum --U` wrote: the thesis's estimator uses it")
      ->type_name("FILE.h5");
  app.add_option("--order", options.order, "Terms of S(ln U), 1 ... 5 (default 3)");
}

} // namespace

extern Declaration const cg_entropy_command = with_options<CgEntropyOptions, declare, entropy>;

} // namespace mesobridge::workflows
