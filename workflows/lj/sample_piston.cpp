#include "workflows/lj/sample_piston.hpp"
#include "md/error.hpp"
#include "md/units.hpp"
#include "workflows/interrupt.hpp"
#include "workflows/lj/piston_file.hpp"
#include "workflows/ranks.hpp"

namespace mesobridge::workflows {

namespace {

std::int64_t steps_before(md::LjPistonSettings const& settings) {
  return settings.melt_steps + settings.equilibration_steps;
}
std::int64_t steps_before(md::MetalPistonSettings const& settings) {
  return settings.equilibration_steps;
}
std::int64_t steps_before(md::StarPistonSettings const& settings) {
  return settings.steps_before();
}

bool sample(md::MpiWorld const& world, md::LjPistonSettings const& settings, std::int64_t steps,
            md::PistonConsumers const& consumers) {
  return md::sample_lj_piston(world, settings, steps, consumers);
}
bool sample(md::MpiWorld const& world, md::MetalPistonSettings const& settings, std::int64_t steps,
            md::PistonConsumers const& consumers) {
  return md::sample_metal_piston(world, settings, steps, consumers);
}
bool sample(md::MpiWorld const& world, md::StarPistonSettings const& settings, std::int64_t steps,
            md::PistonConsumers const& consumers) {
  return md::sample_star_piston(world, settings, steps, consumers);
}

void sample_as_root(md::MpiWorld const& world, PistonJob const& job, auto const& settings,
                    Context const& context) {
  PistonFile file(job.file(), info_of(settings),
                  {.command = context.command_line(), .seed = settings.seed, .scene = "", .inputs = {}});
  auto progress = context.progress("MD of a piston", static_cast<double>(steps_before(settings) + job.steps));
  bool const complete = sample(world, settings, job.steps,
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

void sample_piston(PistonJob const& job, Context const& context) {
  guard_ranks([&] {
    md::MpiWorld const world;
    std::visit(
        [&](auto const& settings) {
          if (world.is_root())
            sample_as_root(world, job, settings, context);
          else
            sample(world, settings, job.steps, {});
        },
        job.settings);
  });
}

} // namespace mesobridge::workflows
