#include "workflows/lj/sample_piston.hpp"
#include "md/error.hpp"
#include "md/units.hpp"
#include "workflows/interrupt.hpp"
#include "workflows/lj/piston_file.hpp"
#include "workflows/ranks.hpp"

namespace mesobridge::workflows {

namespace {

void sample_as_root(md::MpiWorld const& world, LjPistonJob const& job, Context const& context) {
  auto const& settings = job.settings;
  LjPistonFile file(job.file(), settings,
                    {.command = context.command_line(), .seed = settings.seed, .scene = "", .inputs = {}});
  auto progress = context.progress(
      "MD of a piston", static_cast<double>(settings.melt_steps + settings.equilibration_steps + job.steps));
  bool const complete = md::sample_lj_piston(world, settings, job.steps,
                                             {.slices =
                                                  [&](md::PistonSlices const& slices) {
                                                    file.append(slices);
                                                    return !interrupt_requested();
                                                  },
                                              .steps =
                                                  [&](std::int64_t done) {
                                                    progress.update(static_cast<double>(done));
                                                    return !interrupt_requested();
                                                  }});
  file.close(complete);
  if (!complete)
    throw Interrupted(fmt::format("interrupted; what was sampled is in '{}'", job.file().string()));
  progress.finish();
}

} // namespace

md::LjPistonSettings argon_piston(md::Preset preset, double rho0, double T0, double v_P) {
  auto settings = md::lj_piston_settings(preset);
  settings.ahead = {.rho = rho0 / argon_units.density(), .T = T0 / argon_units.temperature()};
  settings.v_P = v_P / argon_units.velocity();
  return settings;
}

void sample_piston(LjPistonJob const& job, Context const& context) {
  guard_ranks([&] {
    md::MpiWorld const world;
    if (world.is_root())
      sample_as_root(world, job, context);
    else
      md::sample_lj_piston(world, job.settings, job.steps, {});
  });
}

} // namespace mesobridge::workflows
