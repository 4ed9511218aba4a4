#include "workflows/metal/metal_file.hpp"
#include "md/error.hpp"
#include <algorithm>

namespace mesobridge::workflows {

namespace {

std::string group_of(std::size_t index) {
  return fmt::format("states/{:04}", index);
}

/// The columns of a series beside its step numbers.
constexpr std::pair<char const*, double md::MetalSample::*> columns[] = {
    {"T_K", &md::MetalSample::T},
    {"e_J_kg", &md::MetalSample::e},
    {"P_Pa", &md::MetalSample::P},
    {"displacement_2_m2", &md::MetalSample::displacement_2}};

MetalSeries read_series(Store const& store, std::string const& group) {
  MetalSeries series{.state = {.rho = store.read_double_attribute(group, "rho_kg_m3", {.above = 0}),
                               .T = store.read_double_attribute(group, "T_K", {.above = 0})},
                     .samples = {},
                     .end = {}};
  if (!store.contains(group + "/step"))
    return series; // interrupted before its first sample
  Expected const numbers{.row_shape = Store::Shape{}};
  auto const steps = store.read_integers(group + "/step", numbers);
  auto length = steps.size();
  std::vector<std::vector<double>> values;
  for (auto const& [name, member] : columns) {
    // A run that was killed between two columns leaves the later ones shorter.
    values.push_back(store.contains(group + "/" + name) ? store.read_doubles(group + "/" + name, numbers)
                                                        : std::vector<double>{});
    length = std::min(length, values.back().size());
  }
  for (std::size_t i = 0; i < length; ++i) {
    md::MetalSample sample{.step = steps[i]};
    for (std::size_t c = 0; c < std::size(columns); ++c)
      sample.*columns[c].second = values[c][i];
    series.samples.push_back(sample);
  }
  if (store.has_attribute(group, "lattice_order") && store.has_attribute(group, "part_beyond_table"))
    series.end = {.lattice_order = store.read_double_attribute(group, "lattice_order"),
                  .part_beyond_table = store.read_double_attribute(group, "part_beyond_table")};
  return series;
}

std::filesystem::path scratch_of(std::filesystem::path const& file) {
  return file.string() + ".new";
}

} // namespace

MetalFile::MetalFile(std::filesystem::path const& file, md::MetalSettings const& settings,
                     Provenance const& provenance, std::span<MetalSeries const> kept)
    : store_(scratch_of(file), Store::Mode::create) {
  write_provenance(store_, provenance);
  store_.set_attribute("settings", "description", settings.description());
  store_.set_attribute("settings", "fingerprint", fingerprint(settings));
  store_.set_attribute("settings", "units",
                       std::string("SI; e above the perfect crystal of zero pressure at rest"));
  store_.set_attribute("settings", "atoms", std::int64_t{settings.atoms()});
  store_.set_attribute("settings", "atom_mass_kg", settings.potential.mass);
  for (auto const& series : kept) {
    auto const index = add(series.state);
    append(index, series.samples);
    if (series.end)
      finish(index, *series.end);
  }
  store_.flush();
  // HDF5 goes on writing to the file that it has opened, under its new name.
  std::filesystem::rename(scratch_of(file), file);
}

std::size_t MetalFile::add(md::MetalState state) {
  store_.set_attribute(group_of(states_), "rho_kg_m3", state.rho);
  store_.set_attribute(group_of(states_), "T_K", state.T);
  return states_++;
}

void MetalFile::append(std::size_t index, std::span<md::MetalSample const> samples) {
  std::vector<std::int64_t> steps;
  for (auto const& sample : samples)
    steps.push_back(sample.step);
  store_.append(group_of(index) + "/step", steps);
  for (auto const& [name, member] : columns) {
    std::vector<double> values;
    for (auto const& sample : samples)
      values.push_back(sample.*member);
    store_.append(group_of(index) + "/" + name, values);
  }
  store_.flush();
}

void MetalFile::finish(std::size_t index, md::MetalEnd const& end) {
  store_.set_attribute(group_of(index), "lattice_order", end.lattice_order);
  store_.set_attribute(group_of(index), "part_beyond_table", end.part_beyond_table);
  store_.flush();
}

void MetalFile::close() {
  store_.close();
}

std::string fingerprint(md::MetalSettings const& settings) {
  return fmt::format("{}; friction {} steps; seed {}; potential {}", settings.description(),
                     settings.friction_steps, settings.seed, sha256_of_file(settings.potential.file));
}

MetalData read_metal_file(std::filesystem::path const& file) {
  Store const store(file, Store::Mode::read);
  if (!store.has_attribute("settings", "fingerprint"))
    throw InputError(fmt::format("'{}' holds no runs of `md metal-grid` or `md hugoniot`", file.string()));
  MetalData data{.fingerprint = store.read_text_attribute("settings", "fingerprint"), .series = {}};
  if (store.is_group("states"))
    for (auto const& name : store.list("states"))
      data.series.push_back(read_series(store, "states/" + name));
  return data;
}

} // namespace mesobridge::workflows
