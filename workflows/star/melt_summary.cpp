#include "workflows/star/melt_summary.hpp"
#include "workflows/summary.hpp"
#include <algorithm>
#include <cmath>
#include <numeric>

namespace mesobridge::workflows {

namespace {

/// The largest relative difference between the blobs' energies together and the system's.
double energy_sum_error(BlobData const& data) {
  double worst = 0;
  auto const molecules = std::size_t(data.head.molecules);
  for (std::size_t frame = 0; frame < data.frames(); ++frame) {
    double sum = 0;
    for (std::size_t k = frame * molecules; k < (frame + 1) * molecules; ++k)
      sum += data.U(k) + data.Phi[k] + norm2(data.P[k]) / (2 * data.head.mass);
    worst = std::max(worst, std::abs(sum - data.energies[frame]) / std::abs(data.energies[frame]));
  }
  return worst;
}

double largest_momentum(BlobData const& data) {
  double worst = 0;
  auto const molecules = std::size_t(data.head.molecules);
  for (std::size_t frame = 0; frame < data.frames(); ++frame)
    worst = std::max(worst,
                     norm(std::accumulate(data.P.begin() + std::ptrdiff_t(frame * molecules),
                                          data.P.begin() + std::ptrdiff_t((frame + 1) * molecules), Vec3{})));
  return worst;
}

/// The slope of a line through points at equal intervals, from the two halves' means.
cg::Estimate drift(std::vector<double> const& energies, std::vector<double> const& times) {
  std::size_t const half = energies.size() / 2;
  std::span<double const> const all(energies);
  auto const first = cg::estimate_mean(all.first(half)), second = cg::estimate_mean(all.last(half));
  double const apart = times[energies.size() - half] - times[0];
  return {(second.mean - first.mean) / apart, std::hypot(first.se, second.se) / apart, second.n_eff};
}

std::vector<double> frame_means(BlobData const& data, auto const& of_blob) {
  std::vector<double> means;
  auto const molecules = std::size_t(data.head.molecules);
  for (std::size_t frame = 0; frame < data.frames(); ++frame) {
    double sum = 0;
    for (std::size_t k = frame * molecules; k < (frame + 1) * molecules; ++k)
      sum += of_blob(k);
    means.push_back(sum / double(molecules));
  }
  return means;
}

constexpr std::size_t frames_for_errors = 40;

} // namespace

void put_melt(Json& json, BlobData const& data, double boltzmann) {
  double const beads = double(data.head.molecules) * data.head.atoms;
  auto const [low, high] = std::minmax_element(data.energies.begin(), data.energies.end());
  json["energy_per_bead"] = data.energies.front() / beads;
  json["energy_spread_per_bead"] = (*high - *low) / beads;
  json["blob_energy_sum_relative_error_max"] = energy_sum_error(data);
  json["total_momentum_max"] = largest_momentum(data);
  if (data.frames() < frames_for_errors)
    return;
  auto per_bead = data.energies;
  for (double& energy : per_bead)
    energy /= beads;
  put(json, "energy_drift_per_bead_and_time", drift(per_bead, data.times));
  double const freedoms = 3 * (beads - 1) * boltzmann;
  auto const T = frame_means(data, [&](std::size_t k) {
    return (2 * data.U_kin[k] + norm2(data.P[k]) / data.head.mass) * data.head.molecules / freedoms;
  });
  put(json, "T_kin", cg::estimate_mean(T));
  put(json, "U_mean", cg::estimate_mean(frame_means(data, [&](std::size_t k) { return data.U(k); })));
  put(json, "Phi_mean", cg::estimate_mean(frame_means(data, [&](std::size_t k) { return data.Phi[k]; })));
  put(json, "P", cg::estimate_mean(data.pressures));
}

Json melt_summary(MeltJob const& job, BlobData const& data) {
  auto const& s = job.settings;
  Json json{{"file", job.blobs().string()},
            {"centres_file", (s.directory / "centres.h5").string()},
            {"units", "reduced Lennard-Jones"},
            {"star", s.star.name()},
            {"molecules", s.molecules},
            {"atoms", s.molecules * s.star.atoms()},
            {"rho", s.rho},
            {"box_edge", data.boxes.front().edge.x},
            {"T_thermostat", s.T},
            {"dt", s.dt},
            {"frames", data.frames()},
            {"time_sampled", double(s.sampling_steps) * s.dt},
            {"seed", s.seed},
            {"settings", s.fingerprint()}};
  put_melt(json, data, 1);
  return json;
}

Json molecules_summary(MoleculesJob const& job, md::MoleculeMelt const& melt, BlobData const& data,
                       double boltzmann) {
  auto const& p = melt.protocol();
  auto const& edge = data.boxes.front().edge;
  Json json{{"file", job.blobs().string()},
            {"centres_file", (job.settings.directory / "centres.h5").string()},
            {"units", units_text(data.head)},
            {"molecule", data.head.name},
            {"molecules", data.head.molecules},
            {"atoms", data.head.molecules * data.head.atoms},
            {"mass_of_molecule", data.head.mass},
            {"rho", p.rho},
            {"box_edges", {edge.x, edge.y, edge.z}},
            {"T_thermostat", p.T},
            {"k_B", boltzmann},
            {"dt", p.dt},
            {"frames", data.frames()},
            {"time_sampled", double(p.sampling_steps) * p.dt},
            {"seed", p.seed},
            {"settings", melt.fingerprint()}};
  put_melt(json, data, boltzmann);
  return json;
}

namespace {

std::string numbers_text(Json const& summary) {
  std::string text = fmt::format("energy spread          {:.3g} a bead\nblobs' energies        add up to "
                                 "LAMMPS's within {:.2g} (relative)\n"
                                 "total momentum         at most {:.2g}\n",
                                 summary["energy_spread_per_bead"].get<double>(),
                                 summary["blob_energy_sum_relative_error_max"].get<double>(),
                                 summary["total_momentum_max"].get<double>());
  for (char const* key : {"T_kin", "U_mean", "Phi_mean", "P", "energy_drift_per_bead_and_time"})
    if (summary.contains(key))
      text += fmt::format("{:<22} {:.6g} +- {:.2g}\n", key, summary[key].get<double>(),
                          summary[std::string(key) + "_se"].get<double>());
  return text + summary["file"].get<std::string>();
}

} // namespace

std::string melt_text(Json const& summary) {
  return fmt::format("{} stars, {} molecules at rho = {}: {} frames over {} time units\n",
                     summary["star"].get<std::string>(), summary["molecules"].get<int>(),
                     summary["rho"].get<double>(), summary["frames"].get<int>(),
                     summary["time_sampled"].get<double>()) +
         numbers_text(summary);
}

std::string molecules_text(Json const& summary) {
  return fmt::format("{}, {} molecules at {:.6g} atoms per volume: {} frames over {} time units\nunits       "
                     "           "
                     "{}; T_kin as LAMMPS tells temperatures\n",
                     summary["molecule"].get<std::string>(), summary["molecules"].get<int>(),
                     summary["rho"].get<double>(), summary["frames"].get<int>(),
                     summary["time_sampled"].get<double>(), summary["units"].get<std::string>()) +
         numbers_text(summary);
}

} // namespace mesobridge::workflows
