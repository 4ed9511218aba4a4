#include "workflows/lj/sample_grid.hpp"
#include "md/error.hpp"
#include "workflows/interrupt.hpp"
#include "workflows/lj/grid_file.hpp"
#include "workflows/ranks.hpp"

namespace mesobridge::workflows {

namespace {

void sample_as_root(md::MpiWorld const& world, LjGridJob const& job, Context const& context) {
  auto const path = job.directory / "lj-grid.h5";
  LjGridFile file(path, job.states, job.settings,
                  {.command = context.command_line(), .seed = job.settings.seed, .scene = "", .inputs = {}});
  auto progress = context.progress(fmt::format("MD of {} states", job.states.size()), 1);
  bool const complete =
      md::sample_lj_grid(world, job.states, job.settings,
                         {.samples =
                              [&](std::size_t state, std::span<md::ThermoSample const> samples) {
                                file.append(state, samples);
                                return !interrupt_requested();
                              },
                          .progress =
                              [&](double fraction) {
                                progress.update(fraction);
                                return !interrupt_requested();
                              }});
  file.close(complete);
  if (!complete)
    throw Interrupted(fmt::format("interrupted; what was sampled is in '{}'", path.string()));
  progress.finish();
}

} // namespace

void sample_grid(LjGridJob const& job, Context const& context) {
  guard_ranks([&] {
    md::MpiWorld const world;
    if (world.is_root())
      sample_as_root(world, job, context);
    else
      md::sample_lj_grid(world, job.states, job.settings, {});
  });
}

} // namespace mesobridge::workflows
