#include "md/error.hpp"
#include "workflows/command/options.hpp"
#include "workflows/lj/preset.hpp"
#include "workflows/star/chapter.hpp"
#include "workflows/star/melt_summary.hpp"
#include "workflows/star/sample_melt.hpp"
#include "workflows/star/star_options.hpp"

namespace mesobridge::workflows {

namespace {

struct MdStarMeltOptions {
  StarOptions stars;
  std::string preset;
  md::StarMeltSettings settings;
  CLI::App const* app = nullptr; ///< knows what the command line says
};

/// The preset's first melt, where the command line says nothing else.
void fill_in(MdStarMeltOptions& options) {
  if (options.preset.empty())
    return;
  auto const plan = chapter_plan(preset_of(options.preset), 1);
  auto const& [star, melts] = plan.molecules.front();
  auto const usual = melt_settings(plan, star, melts.front());
  auto const fill = [&](char const* option, auto& value, auto const& of_preset) {
    if (options.app->count(option) == 0)
      value = of_preset;
  };
  auto& s = options.settings;
  fill("--star", options.stars.star, star.name());
  fill("--molecules", s.molecules, usual.molecules);
  fill("--rho", s.rho, usual.rho);
  fill("--dt", s.dt, usual.dt);
  fill("--equilibration-steps", s.equilibration_steps, usual.equilibration_steps);
  fill("--sampling-steps", s.sampling_steps, usual.sampling_steps);
  fill("--sample-every", s.sample_every, usual.sample_every);
}

Result star_melt(MdStarMeltOptions const& given, Context const& context) {
  auto options = given;
  fill_in(options);
  return sampled(MeltJob{.settings = options.settings}, options.stars, "out/star-melt", {"centres.h5"},
                 sample_melt_on_ranks, melt_text, context);
}

void declare(CLI::App& app, MdStarMeltOptions& options) {
  options.app = &app;
  auto& s = options.settings;
  add_preset(app, options.preset, "The 6-3 melt of chapter 3: quick (minutes), standard or paper");
  add_options(app, options.stars, s, "Steps at the final density", "Steps at constant energy");
  add_melt_options(app, s);
}

} // namespace

extern Declaration const md_star_melt_command = with_options<MdStarMeltOptions, declare, star_melt>;

} // namespace mesobridge::workflows
