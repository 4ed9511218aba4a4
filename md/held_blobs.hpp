#pragma once
#include "md/star_melt.hpp"

namespace mesobridge::md {

/// A melt of stars as StarMeltSettings makes it, whose molecules are then held at their centres of mass in
/// several configurations, one after the other (md/README.md, Eq. (M11)). Between two of them the melt moves
/// freely under its thermostat. Here sampling_steps are those of each configuration.
struct HeldBlobsSettings : StarMeltSettings {
  HeldBlobsSettings() {
    molecules = 216, dt = 0.004, sampling_steps = 10000, sample_every = 5;
    name = "held-blobs";
  }
  int configurations = 6;
  std::int64_t free_steps = 5000; ///< between two configurations

  /// What decides the run, in one line: it may be resumed with more configurations.
  std::string fingerprint() const;
};

/// Throws InputError that names the quantity when the settings make no sense.
void check(HeldBlobsSettings const& settings);

/// The whole run, stretch by stretch.
std::vector<MeltStretch> plan(HeldBlobsSettings const& settings);

/// Frames of each configuration.
std::int64_t frames_of_each(HeldBlobsSettings const& settings);

/// Makes the run, or what is left of it, as sample_star_melt does. The frames are those of held molecules,
/// their forces what acts on the atoms without what holds them. Throws as sample_star_melt, and PhysicsError
/// when a held molecule moves.
bool sample_held_blobs(MpiWorld const& world, HeldBlobsSettings const& settings, bool resume,
                       StarConsumers const& consumers);

} // namespace mesobridge::md
