#include "md/error.hpp"
#include "workflows/command/options.hpp"
#include "workflows/shared_options.hpp"
#include "workflows/star/blob_analysis.hpp"
#include "workflows/summary.hpp"

namespace mesobridge::workflows {

namespace {

struct CgCorrelationsOptions {
  std::filesystem::path input;
  std::optional<double> h;
  std::optional<std::size_t> pair_stride;
  cg::CorrelationSettings settings;
};

Result correlations(CgCorrelationsOptions const& options, Context const& context) {
  auto data = read_blobs(options.input);
  auto settings = options.settings;
  if (!(data.head.rho > 0))
    throw InputError(fmt::format("'{}' holds isolated molecules: correlations are those of a melt",
                                 options.input.string()));
  refuse_walls(data.head, options.input, "correlations");
  settings.h = options.h.value_or(default_h(data.head));
  auto const series = series_of(std::move(data));
  settings.pair_stride = options.pair_stride ? *options.pair_stride : default_pair_stride(series);
  auto const found = cg::correlations(series, settings);
  auto const folder = options.input.parent_path();
  auto const directory = context.output_directory(folder.empty() ? "." : folder);
  Result result;
  result.json = correlations_json(found);
  result.json["h"] = settings.h;
  result.json["pair_stride"] = settings.pair_stride;
  result.json["provenance"] = provenance_json({.command = context.command_line(),
                                               .seed = context.options.seed.value_or(0),
                                               .scene = "",
                                               .inputs = {options.input}});
  auto const file = directory / "correlations.json";
  write_summary(file, result.json);
  result.text = correlations_text(found) + file.string();
  return result;
}

void declare(CLI::App& app, CgCorrelationsOptions& options) {
  auto& s = options.settings;
  add_blob_file(app, options.input);
  app.add_option("--h", options.h, "Range of the Lucy density (default: 10 at rho = 0.3 for 6-3)");
  app.add_option("--bin-width", s.bin_width, "Of g(r) (default 0.2)");
  app.add_option("--density-bins", s.density_bins, "Of <U>^rho (default 12)");
  app.add_option("--map-bins", s.map_bins, "Of the map of P(K,U), along each axis (default 12)");
  app.add_option("--pair-stride", options.pair_stride,
                 "Frames between those whose pairs are looked at (default: an eighth of tau_U)");
}

} // namespace

extern Declaration const cg_correlations_command = with_options<CgCorrelationsOptions, declare, correlations>;

} // namespace mesobridge::workflows
