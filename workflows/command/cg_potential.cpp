#include "md/error.hpp"
#include "workflows/coarse/potential_output.hpp"
#include "workflows/coarse/structure_of_blobs.hpp"
#include "workflows/command/options.hpp"
#include "workflows/sdpd/settings.hpp"
#include "workflows/shared_options.hpp"
#include "workflows/summary.hpp"
#include "workflows/text_file.hpp"
#include <cmath>

namespace mesobridge::workflows {
namespace {

struct CgPotentialOptions {
  std::filesystem::path input;
  double width = 0.2;
  std::optional<double> cutoff;
  std::string method = "hnc";
  bool pressure = false;
  PotentialSearch search = {.inversion = {.share = 1}};
};

/// The user's wishes, and what follows from the molecules.
PotentialSearch search_of(CgPotentialOptions const& options, CoarseStructure const& structure,
                          Context const& context) {
  auto search = options.search;
  auto& inversion = search.inversion;
  inversion.kT = structure.kT;
  inversion.cutoff = options.cutoff.value_or(usual_cutoff(structure.g, options.pressure));
  inversion.knots = std::max(inversion.knots, 2 * structure.g.width);
  if (options.method == "hnc")
    inversion.density = structure.density;
  double const reach = structure.g.width * double(structure.g.g.size());
  search.lattice =
      std::max(search.lattice, std::uint32_t(std::ceil(2 * reach * std::cbrt(structure.density))) + 1);
  search.seed = context.options.seed.value_or(1),
  search.threads = context.options.threads.value_or(available_threads());
  return search;
}

Result potential(CgPotentialOptions const& options, Context const& context) {
  auto const data = read_blobs(options.input);
  refuse_walls(data.head, options.input, "a potential");
  check_search(options.search); // before any work
  auto structure = structure_of(data, options.width);
  auto const search = search_of(options, structure, context);
  auto const P = structure.P;
  require(P || !options.pressure, "--pressure", options.input.string(),
          "holds no pressures, as blobs of a trajectory do not: it cannot be kept");
  if (!options.pressure)
    structure.P.reset(); // it is shown, not kept
  auto progress = context.progress("Potential", 1);
  auto const trials = search_potential(structure, search, [&](int done) {
    progress.update(double(done) / search.iterations, fmt::format("trial {}", done));
  });
  progress.finish();
  structure.P = P;
  auto const folder = options.input.parent_path();
  auto const directory = context.output_directory(folder.empty() ? "." : folder);
  Provenance const provenance{
      .command = context.command_line(), .seed = search.seed, .scene = "", .inputs = {options.input}};
  Result result;
  result.json = potential_json(structure, trials);
  result.json["method"] = options.method;
  result.json["units"] = units_text(data.head);
  result.json["provenance"] = provenance_json(provenance);
  write_text_file(directory / "potential.csv", potential_csv(best(trials).potential));
  write_summary(directory / "potential.json", result.json);
  auto report = potential_report(structure, trials, data.head.name, units_text(data.head));
  report.provenance = provenance;
  write_text_file(directory / "potential.html", report.html());
  result.text = potential_text(structure, trials) + (directory / "potential.csv").string();
  return result;
}

void declare(CLI::App& app, CgPotentialOptions& options) {
  auto& search = options.search;
  add_blob_file(app, options.input);
  app.add_option("--cutoff", options.cutoff,
                 "Of the potential (default: where g(r) is 1 within 0.02, 1.3 times that with --pressure)");
  app.add_option("--bin-width", options.width, "Of g(r) and the potential's rows (default 0.2)");
  app.add_option("--method", options.method,
                 "hnc, which counts neighbours' neighbours, or boltzmann (default hnc)")
      ->check(CLI::IsMember({"hnc", "boltzmann"}));
  app.add_option("--share", search.inversion.share, "Of the full change that an iteration makes (default 1)");
  app.add_option("--iterations", search.iterations, "At most (default 20)");
  app.add_option("--enough", search.enough,
                 "Difference of the structures, and of P, at which it ends (default 1e-5)");
  app.add_option("--steps", search.sample, "Sampled by each trial (default 3000)");
  app.add_flag("--pressure", options.pressure, "Keep the molecules' pressure too, by a linear tail");
}

} // namespace

extern Declaration const cg_potential_command = with_options<CgPotentialOptions, declare, potential>;

} // namespace mesobridge::workflows
