#include "workflows/interrupt.hpp"
#include "workflows/job_pool.hpp"
#include "workflows/report/heat_map.hpp"
#include "workflows/report/number_text.hpp"
#include "workflows/reproduce/list.hpp"
#include "workflows/reproduce/structure_study.hpp"
#include "workflows/summary.hpp"
#include "workflows/text_file.hpp"
#include <algorithm>
#include <cmath>
#include <mutex>

namespace mesobridge::workflows {
namespace {

struct Row {
  StructureCase of;
  std::vector<FoundStructure> runs;

  StructureVerdict verdict() const { return verdict_of(of, runs); }
  std::optional<cg::Estimate> mean(cg::Estimate FoundStructure::*quantity) const {
    return over_runs(runs, quantity);
  }
  /// Of the runs that went on; 0 where none did.
  double us_per_particle_step() const {
    double n = 0, sum = 0;
    for (auto const& run : runs)
      if (run.failure.empty())
        ++n, sum += run.us_per_particle_step;
    return n > 0 ? sum / n : 0;
  }
};

StructurePlan plan_of(md::Preset preset) {
  if (preset == md::Preset::quick)
    return {.kernels = {"cubic", "wendland-c2", "wendland-c4"},
            .neighbours = {30, 65, 110},
            .K = {10, 100, 1e3, 1e4, 1e6},
            .runs = 2};
  StructurePlan plan{.kernels = {"cubic", "lucy", "quintic", "wendland-c2", "wendland-c4", "wendland-c6"},
                     .neighbours = {30, 45, 65, 90, 130, 200},
                     .K = {10, 30, 100, 300, 1e3, 3e3, 1e4, 1e5, 1e6},
                     .time = 600,
                     .side = 9,
                     .runs = 3};
  if (preset == md::Preset::paper)
    plan.time = 6000, plan.side = 10, plan.runs = 5;
  return plan;
}

std::vector<Row> run_all(StructurePlan const& plan, ReproduceOptions const& options, Context const& context) {
  std::vector<Row> rows;
  for (auto const& of : cases_of(plan))
    rows.push_back({of, std::vector<FoundStructure>(plan.runs)});
  auto progress = context.progress("Structure", static_cast<double>(rows.size() * plan.runs));
  std::mutex mutex;
  double done = 0;
  std::vector<std::function<void()>> jobs;
  for (auto& row : rows)
    for (std::size_t run = 0; run < plan.runs; ++run)
      jobs.push_back([&, run] {
        row.runs[run] =
            find_structure(row.of, plan, options.seed + run, [] { return !interrupt_requested(); });
        std::lock_guard const lock(mutex);
        progress.update(++done, row.of.kernel);
      });
  run_jobs(jobs, options.threads);
  progress.finish();
  return rows;
}

Json json_of(Row const& row) {
  auto const verdict = row.verdict();
  using enum StructureKind;
  Json json{{"kernel", row.of.kernel},
            {"neighbours", row.of.neighbours},
            {"K", row.of.K},
            {"structure", verdict.text()},
            {"runs", verdict.runs},
            {"froze", verdict.count(crystal)},
            {"paired", verdict.count(paired)},
            {"glasses", verdict.count(glass)},
            {"fluids", verdict.count(fluid)},
            {"stopped", verdict.stopped}};
  for (auto const& run : row.runs)
    if (!run.failure.empty())
      json["failure"] = run.failure;
  for (auto const& [key, quantity] : {std::pair("pairing_fraction", &FoundStructure::paired),
                                      {"crystal_fraction", &FoundStructure::crystal},
                                      {"moved_in_mean_distances_squared", &FoundStructure::moved}})
    if (auto const mean = row.mean(quantity)) {
      put(json, key, *mean);
      json["us_per_particle_step"] = row.us_per_particle_step();
    }
  return json;
}

/// One line for each run.
std::string csv_of(std::vector<Row> const& rows, std::uint64_t seed) {
  std::string text =
      "kernel,neighbours,K,seed,structure,paired,paired_se,crystal,crystal_se,moved,moved_se,us\n";
  for (auto const& [of, runs] : rows)
    for (std::size_t k = 0; k < runs.size(); ++k)
      if (auto const& found = runs[k]; found.failure.empty())
        text += fmt::format("{},{:g},{:g},{},{},{:.4g},{:.2g},{:.4g},{:.2g},{:.4g},{:.2g},{:.3g}\n",
                            of.kernel, of.neighbours, of.K, seed + k, name_of(structure_of(of, found)),
                            found.paired.mean, found.paired.se, found.crystal.mean, found.crystal.se,
                            found.moved.mean, found.moved.se, found.us_per_particle_step);
  return text;
}

/// One line for each kernel and number of neighbours: cost, then a word for each size.
Table words(StructurePlan const& plan, std::vector<Row> const& rows) {
  Table table{
      .header = {"kernel, neighbours", "µs a particle and step"},
      .caption = fmt::format(
          "fluid: particles have gone further than {0} mean distances within {1:g} reduced times; "
          "glass: they have not; pairs: more of them have a neighbour nearer than 0.35 mean distances "
          "than thermal motion brings together; crystal: more than a fifth are ordered as one. {2} of each; "
          "where they differ, how many became what. Cost of one thread, at the largest K.",
          number_text(std::sqrt(cage), 2), 0.5 * plan.time,
          plan.runs == 1 ? "One run" : fmt::format("{} runs with different seeds", plan.runs))};
  for (double const K : plan.K)
    table.header.push_back("K = " + number_text(K, 4));
  for (std::size_t first = 0; first < rows.size(); first += plan.K.size()) {
    auto const& of = rows[first].of;
    double const us = rows[first + plan.K.size() - 1].us_per_particle_step();
    table.rows.push_back(
        {fmt::format("{}, {:g}", of.kernel, of.neighbours), us > 0 ? number_text(us, 2) : ""});
    for (std::size_t k = 0; k < plan.K.size(); ++k)
      table.rows.back().push_back(rows[first + k].verdict().text());
  }
  return table;
}

Table numbers(std::vector<Row> const& rows) {
  Table table{.header = {"kernel, neighbours, K", "paired", "crystal", "moved² / l²", "structure"},
              .caption =
                  "Shares of the particles and mean square displacements in the second half of each run, "
                  "in the mean over the runs, with standard errors: the larger ones of the runs' own "
                  "(displacements: by the scatter of the particles) and of their spread."};
  for (auto const& row : rows) {
    auto const cell = [&](cg::Estimate FoundStructure::*quantity) {
      auto const mean = row.mean(quantity);
      return mean ? with_error_text(*mean) : std::string();
    };
    table.rows.push_back({fmt::format("{}, {:g}, {:g}", row.of.kernel, row.of.neighbours, row.of.K),
                          cell(&FoundStructure::paired), cell(&FoundStructure::crystal),
                          cell(&FoundStructure::moved), row.verdict().text()});
  }
  return table;
}

/// One map for each kernel.
Figure maps(StructurePlan const& plan, std::vector<Row> const& rows, std::string const& what,
            cg::Estimate FoundStructure::*quantity, double top, std::string const& caption) {
  Figure figure{.svgs = {}, .caption = caption};
  std::vector<double> sizes;
  for (double const K : plan.K)
    sizes.push_back(std::log10(K));
  for (auto const& kernel : plan.kernels) {
    HeatMap map{.title = kernel,
                .x_label = "log10 K",
                .y_label = "neighbours",
                .value_label = what,
                .x = sizes,
                .y = plan.neighbours,
                .value = std::vector<std::optional<double>>(sizes.size() * plan.neighbours.size()),
                .top = top};
    for (auto const& row : rows) {
      auto const& of = row.of;
      auto const mean = row.mean(quantity);
      if (of.kernel != kernel || !mean)
        continue;
      auto const i = std::ranges::find(plan.K, of.K) - plan.K.begin(),
                 j = std::ranges::find(plan.neighbours, of.neighbours) - plan.neighbours.begin();
      map.value[static_cast<std::size_t>(i) * plan.neighbours.size() + static_cast<std::size_t>(j)] =
          mean->mean;
    }
    figure.svgs.push_back(draw_svg(map));
  }
  return figure;
}

} // namespace

Reproduced reproduce_structure(ReproduceOptions const& options, Context const& context) {
  auto const plan = plan_of(options.preset);
  auto const rows = run_all(plan, options, context);
  Reproduced found;
  for (auto const& row : rows)
    found.summary["rows"].push_back(json_of(row));
  write_text_file(options.directory / "structure.csv", csv_of(rows, options.seed));
  Section section{"Fluid, glass, pairs or crystal", {words(plan, rows)}};
  section.content.emplace_back(
      maps(plan, rows, "paired", &FoundStructure::paired, 1,
           "Share of the particles with a neighbour nearer than 0.35 mean distances."));
  section.content.emplace_back(maps(
      plan, rows, "moved", &FoundStructure::moved, 2 * cage,
      fmt::format("Mean square displacement over half a run, in squares of the mean distance; {:g} and more: "
                  "the particles flow.",
                  cage)));
  section.content.emplace_back(numbers(rows));
  section.content.emplace_back(Files{{{"structure.csv", "the numbers"}}});
  found.report = {.title = "Where particles of SDPD are a fluid",
                  .lead = "Argon at 1150 kg/m³ and 1000 K, 2 mPa s, from a start without a lattice "
                          "(sdpd/README.md, Eq. (S83)): what "
                          "each kernel, number of neighbours and size of the particles becomes.",
                  .verdicts = {},
                  .sections = {std::move(section)},
                  .provenance = {}};
  return found;
}

} // namespace mesobridge::workflows
