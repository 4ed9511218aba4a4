#include "workflows/sdpd/run_file.hpp"
#include "md/error.hpp"
#include "workflows/sdpd/last_step.hpp"
#include "workflows/sdpd/measured_columns.hpp"
#include <algorithm>

namespace mesobridge::workflows {
namespace {

constexpr char const* step_origin = "step_origin"; ///< an attribute of the file

/// The first number of the last row. Throws InputError when the rows are not those of this scene.
std::int64_t last_step(Store const& store, std::string const& dataset, std::size_t width) {
  if (!store.contains(dataset))
    return -1;
  auto const shape = store.shape(dataset);
  if (shape.size() != 2 || shape[1] != width)
    throw InputError(fmt::format("cannot go on with '{}': '{}' has no rows of {} numbers as this scene makes "
                                 "them",
                                 store.file().string(), dataset, width));
  auto const rows = store.read_doubles(dataset);
  return rows.empty() ? -1 : static_cast<std::int64_t>(rows[rows.size() - width]);
}

/// Columns of `moments`.
std::vector<std::string> moment_names(sdpd::Features const& features) {
  if (!features.densities)
    return {"step", "eps_mean", "eps_variance"};
  return {"step",   "eps_mean",   "eps_variance",     "rho_mean",        "rho_variance",
          "P_mean", "P_variance", "pairing_fraction", "crystal_fraction"};
}

} // namespace

RunFile::RunFile(std::filesystem::path const& file, OutputUnits const& units, sdpd::Features features,
                 Provenance const& provenance)
    : RunFile(Store(file, Store::Mode::create, Store::Safety::marked), units, features) {
  write_provenance(store_, provenance);
  store_.set_attribute("/", step_origin, std::string("begin of the sampling"));
  store_.mark();
}

RunFile RunFile::continue_file(std::filesystem::path const& file, OutputUnits const& units,
                               sdpd::Features features) {
  RunFile run(Store(file, Store::Mode::append, Store::Safety::marked), units, features);
  if (!run.store_.has_attribute("/", step_origin)) // its steps count from the start: rows would be missed
    throw InputError(fmt::format("cannot go on with '{}': an earlier version of mesobridge wrote it; begin "
                                 "the run anew",
                                 file.string()));
  run.last_row_ = last_step(run.store_, "thermodynamics", run.columns({}, 0).size());
  run.last_instant_ = last_step(run.store_, "moments", moment_names(features).size());
  return run;
}

void RunFile::refuse_gap(std::int64_t last_sample, std::int64_t last_instant) const {
  workflows::refuse_gap(store_.file(), "thermodynamics", last_row_, last_sample);
  if (features_.energies)
    workflows::refuse_gap(store_.file(), "moments", last_instant_, last_instant);
}

std::vector<RunFile::Column> RunFile::columns(OutputUnits const& u, sdpd::Features features,
                                              sdpd::Observation const& now, double time) {
  std::vector<Column> all{{"step", static_cast<double>(now.step)}, {"time" + u.time_key, time * u.time}};
  for (auto const& measured : measured_in_every_run(features)) {
    auto const names = columns_of(measured, u);
    auto const values = std::get<sdpd::Measurement::FromSums>(measured.values)(now);
    for (std::size_t c = 0; c < names.size(); ++c)
      all.push_back({names[c], values[c] * u.of(measured.dimension).first});
  }
  return all;
}

std::vector<std::string> RunFile::column_names(OutputUnits const& units, sdpd::Features features) {
  std::vector<std::string> names;
  for (auto const& column : columns(units, features, {}, 0))
    names.push_back(column.name);
  return names;
}

void RunFile::append(sdpd::Observation now, std::int64_t step, double time) {
  if (step <= last_row_)
    return;
  now.step = static_cast<std::uint64_t>(step);
  std::vector<double> row;
  std::vector<std::string> names;
  for (auto const& [name, value] : columns(now, time))
    names.push_back(name), row.push_back(value);
  store_.append("thermodynamics", row, {row.size()});
  if (last_row_ < 0)
    store_.set_attribute("thermodynamics", "columns", names);
  last_row_ = step;
  store_.flush();
}

void RunFile::append(sdpd::Snapshot const& now, sdpd::InstantMoments const& m, std::int64_t step) {
  if (step <= last_instant_)
    return;
  if (!features_.energies)
    return;
  // Each mean and variance in the engine's reduced units: what a resumed run reads back must be the same
  // number.
  auto const names = moment_names(features_);
  std::vector<double> row{static_cast<double>(step),
                          m.eps_mean,
                          m.eps_variance,
                          m.rho_mean,
                          m.rho_variance,
                          m.P_mean,
                          m.P_variance,
                          m.pairing,
                          m.crystal};
  row.resize(names.size());
  std::size_t const count = std::min(now.eps.size(), stored_particles);
  auto scaled = [count](std::vector<double> const& values, double unit) {
    std::vector<double> result(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(count));
    for (auto& value : result)
      value *= unit;
    return result;
  };
  store_.append("particles/eps", scaled(now.eps, units_.energy), {count});
  if (features_.densities) {
    store_.append("particles/rho", scaled(now.rho, units_.density), {count});
    store_.append("particles/P", scaled(now.P, units_.pressure), {count});
  }
  store_.append("moments", row, {row.size()});
  if (last_instant_ < 0) {
    store_.set_attribute("moments", "columns", names);
    store_.set_attribute("moments", "units",
                         std::string("reduced units of the particle size (energy K k_B T, density rho)"));
  }
  last_instant_ = step;
  store_.flush();
}

std::vector<double> RunFile::column(std::string const& name) const {
  auto const all = columns({}, 0);
  auto const found = std::ranges::find(all, name, &Column::name);
  if (found == all.end())
    return {};
  auto const rows = store_.read_doubles("thermodynamics");
  std::vector<double> values;
  for (auto r = static_cast<std::size_t>(found - all.begin()); r < rows.size(); r += all.size())
    values.push_back(rows[r]);
  return values;
}

std::optional<cg::Estimate> RunFile::mean(std::string const& column_name) const {
  auto const values = column(column_name);
  return values.empty() ? std::nullopt : std::optional(cg::estimate_mean(values));
}

sdpd::EquilibriumSampler RunFile::replay() const {
  sdpd::EquilibriumSampler sampler(features_);
  auto const all = columns({}, 0);
  auto place = [&](std::string const& name) {
    for (std::size_t c = 0; c < all.size(); ++c)
      if (all[c].name == name)
        return c;
    return all.size(); // the method has no such column
  };
  std::size_t const energy = place("energy" + units_.energy_key),
                    T_kin = place("T_kin" + units_.temperature_key),
                    T_int = place("T_int" + units_.temperature_key), P = place("P" + units_.pressure_key);
  auto const rows = store_.read_doubles("thermodynamics");
  for (std::size_t r = 0; r < rows.size(); r += all.size())
    sampler.sample(
        rows[r + 1] / units_.time, rows[r + energy] / units_.energy, rows[r + T_kin] / units_.temperature,
        T_int < all.size() ? rows[r + T_int] / units_.temperature : 0, rows[r + P] / units_.pressure);
  if (!features_.energies)
    return sampler;
  std::size_t const width = moment_names(features_).size();
  auto const instants = store_.read_doubles("moments");
  for (std::size_t r = 0; r < instants.size(); r += width) {
    std::vector<double> row(instants.begin() + static_cast<std::ptrdiff_t>(r),
                            instants.begin() + static_cast<std::ptrdiff_t>(r + width));
    row.resize(9);
    sampler.sample(sdpd::InstantMoments{row[1], row[2], row[3], row[4], row[5], row[6], row[7], row[8]});
  }
  return sampler;
}

std::vector<double> RunFile::particle_values(std::string const& name) const {
  auto const dataset = "particles/" + name;
  return store_.contains(dataset) ? store_.read_doubles(dataset) : std::vector<double>();
}

} // namespace mesobridge::workflows
