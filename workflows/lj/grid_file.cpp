#include "workflows/lj/grid_file.hpp"
#include "md/error.hpp"

namespace mesobridge::workflows {

namespace {

std::string group_of(std::size_t state) {
  return fmt::format("states/{:04}", state);
}

template <class Member>
auto column(std::span<md::ThermoSample const> samples, Member md::ThermoSample::*member) {
  std::vector<Member> values;
  for (auto const& sample : samples)
    values.push_back(sample.*member);
  return values;
}

LjGridData::Series read_series(Store const& store, std::string const& group) {
  LjGridData::Series series{.state = {.rho = store.read_double_attribute(group, "rho", {.above = 0}),
                                      .T = store.read_double_attribute(group, "T", {.above = 0})},
                            .samples = {}};
  if (!store.contains(group + "/step"))
    return series; // interrupted before its first sample
  Expected const numbers{.row_shape = Store::Shape{}};
  auto const step = store.read_integers(group + "/step", numbers);
  auto const read = [&](std::string const& name) {
    // A run that was killed between two columns leaves the later ones away, or shorter.
    return store.contains(group + "/" + name) ? store.read_doubles(group + "/" + name, numbers)
                                              : std::vector<double>();
  };
  auto const T = read("T"), U = read("U"), P = read("P");
  auto const length = std::min({step.size(), T.size(), U.size(), P.size()});
  for (std::size_t i = 0; i < length; ++i)
    series.samples.push_back({.step = step[i], .T = T[i], .U = U[i], .P = P[i]});
  return series;
}

} // namespace

LjGridFile::LjGridFile(std::filesystem::path const& file, std::span<md::LjState const> states,
                       md::LjFluidSettings const& settings, Provenance const& provenance)
    : store_(file, Store::Mode::create) {
  write_provenance(store_, provenance);
  store_.set_attribute("settings", "description", settings.description());
  store_.set_attribute("settings", "units", std::string("reduced Lennard-Jones, per atom"));
  store_.set_attribute("settings", "atoms", std::int64_t{settings.atoms});
  store_.set_attribute("settings", "cutoff", settings.cutoff);
  store_.set_attribute("settings", "tail", std::int64_t{settings.tail});
  store_.set_attribute("settings", "reduced_time_step", settings.reduced_time_step);
  store_.set_attribute("settings", "equilibration_steps", settings.equilibration_steps);
  store_.set_attribute("settings", "sampling_steps", settings.sampling_steps);
  store_.set_attribute("settings", "sample_every", settings.sample_every);
  store_.set_attribute("settings", "complete", std::int64_t{0});
  for (std::size_t i = 0; i < states.size(); ++i) {
    store_.set_attribute(group_of(i), "rho", states[i].rho);
    store_.set_attribute(group_of(i), "T", states[i].T);
  }
  store_.flush();
}

void LjGridFile::append(std::size_t state, std::span<md::ThermoSample const> samples) {
  auto const group = group_of(state);
  store_.append(group + "/step", column(samples, &md::ThermoSample::step));
  store_.append(group + "/T", column(samples, &md::ThermoSample::T));
  store_.append(group + "/U", column(samples, &md::ThermoSample::U));
  store_.append(group + "/P", column(samples, &md::ThermoSample::P));
  store_.flush();
}

void LjGridFile::close(bool complete) {
  store_.set_attribute("settings", "complete", std::int64_t{complete});
  store_.close();
}

LjGridData read_lj_grid(std::filesystem::path const& file) {
  Store const store(file, Store::Mode::read);
  if (!store.is_group("states") || !store.has_attribute("settings", "atoms"))
    throw InputError(fmt::format("'{}' holds no runs of `md lj-grid`", file.string()));
  LjGridData data;
  data.atoms = static_cast<int>(store.read_integer_attribute(
      "settings", "atoms", {.least = 1, .most = std::numeric_limits<int>::max()}));
  data.description = store.read_text_attribute("settings", "description");
  data.complete = store.read_integer_attribute("settings", "complete") != 0;
  for (auto const& name : store.list("states"))
    data.series.push_back(read_series(store, "states/" + name));
  if (data.series.empty())
    throw InputError(fmt::format("'{}' holds no state: the group 'states' is empty", file.string()));
  return data;
}

} // namespace mesobridge::workflows
