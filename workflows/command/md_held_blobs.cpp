#include "workflows/command/options.hpp"
#include "workflows/star/sample_held.hpp"
#include "workflows/star/star_options.hpp"

namespace mesobridge::workflows {
namespace {

struct MdHeldBlobsOptions {
  StarOptions stars;
  md::HeldBlobsSettings settings;
};

Result held_blobs(MdHeldBlobsOptions const& options, Context const& context) {
  return sampled(HeldJob{.settings = options.settings}, options.stars, "out/held-blobs", {},
                 sample_held_on_ranks, held_text, context);
}

void declare(CLI::App& app, MdHeldBlobsOptions& options) {
  auto& s = options.settings;
  add_options(app, options.stars, s, "Steps at the final density, before the first configuration",
              fmt::format("Steps that each configuration is held (default {})", s.sampling_steps));
  add_melt_options(app, s);
  app.add_option(
      "--configurations", s.configurations,
      fmt::format("Of centres that are held; 4 or more have standard errors (default {})", s.configurations));
  app.add_option("--free-steps", s.free_steps,
                 fmt::format("Steps between two of them, under the thermostat (default {})", s.free_steps));
}

} // namespace

extern Declaration const md_held_blobs_command = with_options<MdHeldBlobsOptions, declare, held_blobs>;

} // namespace mesobridge::workflows
