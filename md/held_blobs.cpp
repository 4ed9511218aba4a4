#include "md/held_blobs.hpp"
#include "md/star_checkpoint.hpp"
#include <algorithm>

namespace mesobridge::md {

std::string HeldBlobsSettings::fingerprint() const {
  return fmt::format("{}, centres held for {} steps each, {} steps apart", StarMeltSettings::fingerprint(),
                     sampling_steps, free_steps);
}

void check(HeldBlobsSettings const& settings) {
  check(static_cast<StarMeltSettings const&>(settings));
  require(settings.configurations >= 1 && settings.configurations <= 10000, "configurations",
          settings.configurations, "must be 1 ... 10000");
  require(settings.free_steps >= 1, "steps between configurations", settings.free_steps, "must be > 0");
}

std::vector<MeltStretch> plan(HeldBlobsSettings const& settings) {
  auto stretches = plan(static_cast<StarMeltSettings const&>(settings));
  std::erase_if(stretches, [](MeltStretch const& s) { return s.phase == MeltPhase::sample; });
  auto const add = [&](MeltPhase phase, std::int64_t steps) {
    std::int64_t const first = steps_of(stretches);
    for (std::int64_t done = 0; done < steps; done += settings.checkpoint_every)
      stretches.push_back({.phase = phase,
                           .first_step = first + done,
                           .steps = std::min(steps - done, settings.checkpoint_every),
                           .rho = settings.rho,
                           .begins = phase == MeltPhase::hold && done == 0});
  };
  for (int k = 0; k < settings.configurations; ++k) {
    if (k > 0)
      add(MeltPhase::equilibrate, settings.free_steps);
    add(MeltPhase::hold, settings.sampling_steps);
  }
  return stretches;
}

std::int64_t frames_of_each(HeldBlobsSettings const& settings) {
  return settings.sampling_steps / settings.sample_every;
}

bool sample_held_blobs(MpiWorld const& world, HeldBlobsSettings const& settings, bool resume,
                       StarConsumers const& consumers) {
  check(settings);
  return run_stretches(world, settings, plan(settings), resume,
                       "resume with as many configurations as have begun, or more", consumers);
}

} // namespace mesobridge::md
