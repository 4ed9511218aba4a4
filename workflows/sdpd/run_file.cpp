#include "workflows/sdpd/run_file.hpp"

namespace mesobridge::workflows {
namespace {

constexpr std::size_t columns = 12;

std::int64_t last_step(Store const& store, std::string const& dataset, std::size_t width) {
  if (!store.contains(dataset))
    return -1;
  auto const rows = store.read_doubles(dataset);
  return rows.empty() ? -1 : static_cast<std::int64_t>(rows[rows.size() - width]);
}

} // namespace

RunFile::RunFile(std::filesystem::path const& file, OutputUnits const& units, Provenance const& provenance)
    : RunFile(Store(file, Store::Mode::create), units) {
  write_provenance(store_, provenance);
  store_.flush();
}

RunFile RunFile::continue_file(std::filesystem::path const& file, OutputUnits const& units) {
  RunFile run(Store(file, Store::Mode::append), units);
  run.last_row_ = last_step(run.store_, "thermodynamics", columns);
  run.last_instant_ = last_step(run.store_, "moments", 7);
  return run;
}

void RunFile::describe() {
  std::string const t = units_.time_key, e = units_.energy_key, T = units_.temperature_key,
                    P = units_.pressure_key, rho = units_.density_key, p = units_.momentum_key;
  std::vector<std::string> const thermodynamics{
      "step",       "time" + t,       "kinetic_energy" + e, "internal_energy" + e,
      "energy" + e, "T_kin" + T,      "T_int" + T,          "P" + P,
      "rho" + rho,  "momentum_x" + p, "momentum_y" + p,     "momentum_z" + p};
  static_assert(columns == 12);
  store_.set_attribute("thermodynamics", "columns", thermodynamics);
}

void RunFile::append(sdpd::Observation const& now, double time) {
  auto const step = static_cast<std::int64_t>(now.step);
  if (step <= last_row_)
    return;
  std::array<double, columns> const row{static_cast<double>(now.step),    time * units_.time,
                                        now.kinetic * units_.energy,      now.internal * units_.energy,
                                        now.energy() * units_.energy,     now.T_kin * units_.temperature,
                                        now.T_int * units_.temperature,   now.P * units_.pressure,
                                        now.rho * units_.density,         now.momentum.x * units_.momentum,
                                        now.momentum.y * units_.momentum, now.momentum.z * units_.momentum};
  store_.append("thermodynamics", row, {columns});
  if (last_row_ < 0)
    describe();
  last_row_ = step;
  store_.flush();
}

void RunFile::append(sdpd::Snapshot const& now, sdpd::InstantMoments const& m, std::uint64_t step) {
  if (static_cast<std::int64_t>(step) <= last_instant_)
    return;
  // Each mean and variance in the engine's reduced units: what a resumed run reads back must be the same
  // number.
  std::array<double, 7> const row{static_cast<double>(step),
                                  m.eps_mean,
                                  m.eps_variance,
                                  m.rho_mean,
                                  m.rho_variance,
                                  m.P_mean,
                                  m.P_variance};
  std::size_t const count = std::min(now.eps.size(), stored_particles);
  auto scaled = [count](std::vector<double> const& values, double unit) {
    std::vector<double> result(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(count));
    for (auto& value : result)
      value *= unit;
    return result;
  };
  store_.append("particles/eps", scaled(now.eps, units_.energy), {count});
  store_.append("particles/rho", scaled(now.rho, units_.density), {count});
  store_.append("particles/P", scaled(now.P, units_.pressure), {count});
  store_.append("moments", row, {row.size()});
  if (last_instant_ < 0) {
    std::vector<std::string> const names{"step",         "eps_mean", "eps_variance", "rho_mean",
                                         "rho_variance", "P_mean",   "P_variance"};
    store_.set_attribute("moments", "columns", names);
    store_.set_attribute("moments", "units",
                         std::string("reduced units of the particle size (energy K k_B T, density rho)"));
  }
  last_instant_ = static_cast<std::int64_t>(step);
  store_.flush();
}

sdpd::EquilibriumSampler RunFile::replay() const {
  sdpd::EquilibriumSampler sampler;
  auto const rows = store_.read_doubles("thermodynamics");
  for (std::size_t r = 0; r < rows.size(); r += columns)
    sampler.sample(rows[r + 1] / units_.time, rows[r + 4] / units_.energy, rows[r + 5] / units_.temperature,
                   rows[r + 6] / units_.temperature, rows[r + 7] / units_.pressure);
  auto const instants = store_.read_doubles("moments");
  for (std::size_t r = 0; r < instants.size(); r += 7)
    sampler.sample(sdpd::InstantMoments{instants[r + 1], instants[r + 2], instants[r + 3], instants[r + 4],
                                        instants[r + 5], instants[r + 6]});
  return sampler;
}

std::vector<double> RunFile::particle_values(std::string const& name) const {
  return store_.read_doubles("particles/" + name);
}

} // namespace mesobridge::workflows
