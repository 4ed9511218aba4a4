#include "workflows/sdpd/disk_estimate.hpp"
#include "workflows/scene/quantities.hpp"
#include "workflows/sdpd/film_series.hpp"
#include "workflows/sdpd/measured_series.hpp"
#include "workflows/sdpd/run_file.hpp"
#include "workflows/store/store.hpp"
#include <algorithm>

namespace mesobridge::workflows {
namespace {

constexpr double number = 8; ///< bytes
constexpr double text =
    19; ///< bytes of a number in extended XYZ that reads back as the same bits, with a space

/// How many particles' numbers a method has.
struct Particle {
  double scalars;    ///< fields that are written
  double instants;   ///< of those, the ones that RunFile keeps of single particles
  double checkpoint; ///< id, q, q_at_renewal, p, rates and the fields that are checkpointed
  double sample;     ///< columns of `thermodynamics`
  double moments;    ///< columns of `moments`
};

double count_fields(sdpd::Features const& has, bool sdpd::Field::*taken) {
  return static_cast<double>(std::ranges::count_if(
      sdpd::fields, [&](auto const& field) { return has.*field.feature && field.*taken; }));
}

Particle particle_of(Scene const& scene) {
  auto const has = scene.features();
  double const scalars = count_fields(has, &sdpd::Field::written), rates = has.reacts ? 2 : 0,
               checkpoint = 10 + rates + count_fields(has, &sdpd::Field::checkpointed);
  double sample = 2; // step and time
  for (auto const& measured : measured_in_every_run(has))
    sample += static_cast<double>(measured.components.size());
  double const instants = has.densities  ? 3
                          : has.energies ? 1
                                         : 0,
               moments = has.densities  ? 9
                         : has.energies ? 3
                                        : 0;
  return {.scalars = scalars,
          .instants = instants,
          .checkpoint = checkpoint,
          .sample = sample,
          .moments = moments};
}

/// Rows that are written after so many steps each, and before the first.
double rows(Scene const& scene, std::int64_t every) {
  return every > 0 ? static_cast<double>(scene.run.steps / every + 1) : 0;
}

/// Bytes of a dataset that grows by rows: it takes whole chunks.
double growing(double rows, double row_numbers) {
  double const chunk = static_cast<double>(Store::chunk_rows(static_cast<std::size_t>(row_numbers * number)));
  return std::ceil(rows / chunk) * chunk * row_numbers * number;
}

/// In the slab of a film, at the mean density.
double particles_in_film(Scene const& scene) {
  auto const settings = settings_of(scene, 1);
  auto const view = film_view(scene, settings);
  double const edge = component(sdpd::box_of(settings).edge, view.along);
  return static_cast<double>(particles_of(scene)) * (std::min(view.upper, edge) - std::max(view.lower, 0.0)) /
         edge;
}

double results(Scene const& scene, Particle const& of) {
  double const instants = rows(scene, instants_every(scene.run)),
               stored = static_cast<double>(
                   std::min<std::int64_t>(particles_of(scene), RunFile::stored_particles));
  double bytes = growing(rows(scene, scene.run.sample_every), of.sample);
  if (of.moments > 0)
    bytes += growing(instants, of.moments) + of.instants * growing(instants, stored);

  double const profiles = rows(scene, scene.profile.every), slices = static_cast<double>(scene.profile.bins);
  if (profiles > 0) {
    bytes += 2 * growing(profiles, 1) + growing(profiles, slices) + slices * number;
    for (auto const& quantity : chosen(scene.profile.quantities, profile_quantities(), scene.features()))
      bytes += growing(profiles, quantity == "velocity" ? 3 * slices : slices);
  }
  double const histograms = rows(scene, scene.histogram.every),
               bins = static_cast<double>(scene.histogram.bins);
  if (histograms > 0)
    bytes += 2 * growing(histograms, 1) +
             static_cast<double>(
                 chosen(scene.histogram.quantities, histogram_quantities(), scene.features()).size()) *
                 (growing(histograms, bins) + 2 * growing(histograms, 1) + bins * number);
  if (double const frames = rows(scene, film_every(scene)); frames > 0)
    bytes += 3 * growing(frames, 1) + 3 * growing(frames * particles_in_film(scene), 1);
  double const measured = rows(scene, scene.series.every);
  if (measured > 0)
    bytes += 2 * growing(measured, 1);
  for (auto const& of_series : measured_in_series(scene))
    bytes += growing(measured, static_cast<double>(of_series.components.size()));
  return bytes;
}

double trajectories(Scene const& scene, Particle const& of) {
  auto const N = static_cast<double>(particles_of(scene));
  constexpr double vectors = 6;                // of position and velocity
  constexpr double of_paraview_frame = 11.5e3; // in bytes, whatever it shows
  double const h5md = rows(scene, scene.run.trajectory_every), vtkhdf = rows(scene, scene.run.vtkhdf_every),
               xyz = rows(scene, scene.run.xyz_every);
  double const id = std::log10(N) + 3; // and the species
  // Beside the vectors: steps, times and the box; the vertices and their ids; nothing.
  double bytes = xyz * N * ((vectors + of.scalars) * text + id);
  if (h5md > 0)
    bytes += 2 * growing(h5md, 3 * N) + of.scalars * growing(h5md, N) +
             (6 + 2 * of.scalars) * growing(h5md, 1) + growing(h5md, 9);
  if (vtkhdf > 0)
    bytes += 2 * growing(vtkhdf * N, 3) + of.scalars * growing(vtkhdf * N, 1) +
             (12 + of.scalars) * growing(vtkhdf, 1) + N * (3 * number + 1) + vtkhdf * of_paraview_frame;
  return bytes;
}

} // namespace

DiskEstimate estimate_disk(Scene const& scene) {
  auto const of = particle_of(scene);
  return {.results = results(scene, of),
          .trajectories = trajectories(scene, of),
          .checkpoint = static_cast<double>(particles_of(scene)) * of.checkpoint * number};
}

} // namespace mesobridge::workflows
