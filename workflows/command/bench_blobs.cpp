#include "cg/blobs.hpp"
#include "cg/estimate.hpp"
#include "md/error.hpp"
#include "md/star_melt.hpp"
#include "md/star_system.hpp"
#include "workflows/command/options.hpp"
#include "workflows/report/number_text.hpp"
#include "workflows/summary.hpp"
#include <CLI/CLI.hpp>
#include <ctime>

namespace mesobridge::workflows {
namespace {

struct BenchBlobsOptions {
  std::string star = "6-3";
  int molecules = 500, repeats = 40;
  std::int64_t sample_every = 100;
  double rho = 0.3;
};

/// Processor time of this process [s]: what others do on the machine does not count.
double processor_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return double(now.tv_sec) + 1e-9 * double(now.tv_nsec);
}

double seconds_of(std::function<void()> const& work) {
  double const begin = processor_seconds();
  work();
  return processor_seconds() - begin;
}

/// A melt in motion that goes on from a checkpoint.
md::LammpsSession moving(md::MpiWorld const& world, md::StarMeltSettings const& settings, bool tallies) {
  md::LammpsSession lammps(world, md::Ranks::all, settings.log_file(), md::Log::append);
  md::prepare_for_stars(lammps, settings.star);
  lammps.command_with_file("read_restart", settings.restart_file());
  md::set_star_forces(lammps, settings.star);
  if (!tallies)
    lammps.command("thermo_style custom step temp");
  lammps.command("timestep {}", settings.dt);
  lammps.command("thermo {}", settings.sample_every);
  lammps.command("fix move all nve");
  lammps.command("run 0 post no");
  return lammps;
}

Result bench_blobs(BenchBlobsOptions const& options, Context const& context) {
  md::MpiWorld const world;
  md::StarMeltSettings settings{.star = md::star_of_name(options.star),
                                .molecules = options.molecules,
                                .rho = options.rho,
                                .squeeze_steps = 400,
                                .equilibration_steps = 1000,
                                .sampling_steps = options.sample_every,
                                .sample_every = options.sample_every,
                                .checkpoint_every = options.sample_every,
                                .directory = {}};
  md::check(settings);
  settings.directory = context.output_directory("out/bench-blobs");
  md::sample_star_melt(world, settings, false, {});
  auto with = moving(world, settings, true), without = moving(world, settings, false);
  cg::BlobMaker maker(cg::model_of(settings.star));
  std::vector<double> plain, whole, blobs;
  auto const step = fmt::format("run {} pre no post no", options.sample_every);
  for (int repeat = 0; repeat < options.repeats; ++repeat) {
    plain.push_back(seconds_of([&] { without.command(step); }));
    whole.push_back(seconds_of([&] { with.command(step); }));
    blobs.push_back(seconds_of([&] {
      auto const frame = md::collect_molecules(world, with, settings.molecules, settings.star.atoms());
      cg::gather_blobs(world, frame, maker.blobs(frame));
    }));
    whole.back() += blobs.back();
  }
  std::vector<double> percent, blobs_percent;
  for (std::size_t k = 0; k < plain.size(); ++k) {
    percent.push_back(100 * (whole[k] / plain[k] - 1));
    blobs_percent.push_back(100 * blobs[k] / plain[k]);
  }
  auto const cost = cg::estimate_mean(percent), blob_cost = cg::estimate_mean(blobs_percent);
  auto const md_cost = cg::estimate_mean(plain);
  double const atom_steps = double(options.molecules) * settings.star.atoms() * double(options.sample_every);
  Result result;
  result.json = {{"star", options.star},
                 {"atoms", options.molecules * settings.star.atoms()},
                 {"sample_every", options.sample_every},
                 {"repeats", options.repeats}};
  put(result.json, "cost_percent_of_md", cost);
  put(result.json, "blobs_alone_percent_of_md", blob_cost);
  result.json["md_atom_steps_per_s"] = atom_steps / md_cost.mean;
  result.text = fmt::format(
      "blobs every {} steps cost {} % of the MD (the blobs alone {} %, the rest LAMMPS's "
      "energies of atoms), {:.3g} atom steps a second",
      options.sample_every, with_error_text(cost), with_error_text(blob_cost), atom_steps / md_cost.mean);
  return result;
}

void declare(CLI::App& app, BenchBlobsOptions& options) {
  app.add_option("--star", options.star, "ARMS-BEADS (default 6-3)")->type_name("N-N");
  app.add_option("--molecules", options.molecules, "Number of stars (default 500)");
  app.add_option("--rho", options.rho, "Beads per sigma^3 (default 0.3)");
  app.add_option("--sample-every", options.sample_every, "Steps between frames (default 100)");
  app.add_option("--repeats", options.repeats, "Pairs of runs, with and without (default 40)")
      ->check(CLI::Range(16, 100000));
}

} // namespace

extern Declaration const bench_blobs_command = with_options<BenchBlobsOptions, declare, bench_blobs>;

} // namespace mesobridge::workflows
