#include "workflows/sdpd/checkpoint_file.hpp"

namespace mesobridge::workflows {
namespace {

// Three doubles in a row are what HDF5 shall see of a vector.
static_assert(sizeof(Vec3) == 3 * sizeof(double) && std::is_standard_layout_v<Vec3>);

std::span<double const> numbers(std::vector<Vec3> const& vectors) {
  return {reinterpret_cast<double const*>(vectors.data()), 3 * vectors.size()};
}

std::vector<Vec3> vectors(std::vector<double> const& numbers) {
  std::vector<Vec3> result(numbers.size() / 3);
  for (std::size_t i = 0; i < result.size(); ++i)
    result[i] = {numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2]};
  return result;
}

sdpd::PairCounts pair_counts(std::vector<std::int64_t> const& stored) {
  auto at = [&](std::size_t k) { return static_cast<std::uint64_t>(stored.at(k)); };
  return {.proposed = at(0), .out_of_domain = at(1), .metropolis = at(2)};
}

std::array<std::int64_t, 3> integers(sdpd::PairCounts const& counts) {
  return {static_cast<std::int64_t>(counts.proposed), static_cast<std::int64_t>(counts.out_of_domain),
          static_cast<std::int64_t>(counts.metropolis)};
}

sdpd::EquilibrationProgress equilibration(std::vector<double> const& stored) {
  return {
      .done = static_cast<std::uint64_t>(stored.at(0)), .sum_T_kin = stored.at(1), .sum_T_int = stored.at(2)};
}

} // namespace

void write_checkpoint(std::filesystem::path const& file, sdpd::Checkpoint const& c,
                      Provenance const& provenance, sdpd::EquilibrationProgress const& equilibration) {
  auto const fresh = std::filesystem::path(file).concat(".new");
  Store store(fresh, Store::Mode::create);
  std::size_t const n = c.id.size();
  std::int64_t const step = static_cast<std::int64_t>(c.step);
  std::vector<std::int64_t> const id(c.id.begin(), c.id.end());
  store.write("step", std::span(&step, 1));
  store.write("id", id);
  store.write("q", numbers(c.q), {n, 3});
  store.write("q_at_renewal", numbers(c.q_at_renewal), {n, 3});
  store.write("p", numbers(c.p), {n, 3});
  if (!c.eps.empty()) {
    store.write("eps", c.eps);
    store.write("T", c.T);
  }
  if (!c.S.empty())
    store.write("S", c.S);
  store.write("kept_energy", std::span(&c.kept_energy, 1));
  store.write("pair_counts", integers(c.pair_counts));
  store.write("conduction_counts", integers(c.conduction_counts));
  store.write("equilibration", std::array{static_cast<double>(equilibration.done), equilibration.sum_T_kin,
                                          equilibration.sum_T_int});
  write_provenance(store, provenance);
  store.write("scene", provenance.scene);
  store.close();
  std::error_code error;
  std::filesystem::rename(fresh, file, error);
  if (error)
    throw EnvironmentError(fmt::format("cannot write checkpoint '{}': {}", file.string(), error.message()));
}

StoredCheckpoint read_checkpoint(std::filesystem::path const& file) {
  Store const store(file, Store::Mode::read);
  auto const id = store.read_integers("id");
  auto if_there = [&](char const* name) {
    return store.contains(name) ? store.read_doubles(name) : std::vector<double>();
  };
  return {.checkpoint = {.step = static_cast<std::uint64_t>(store.read_integers("step").at(0)),
                         .id = {id.begin(), id.end()},
                         .q = vectors(store.read_doubles("q")),
                         .q_at_renewal = vectors(store.read_doubles("q_at_renewal")),
                         .p = vectors(store.read_doubles("p")),
                         .eps = if_there("eps"),
                         .S = if_there("S"),
                         .T = if_there("T"),
                         .kept_energy = store.read_doubles("kept_energy").at(0),
                         .pair_counts = pair_counts(store.read_integers("pair_counts")),
                         .conduction_counts = pair_counts(store.read_integers("conduction_counts"))},
          .scene = store.read_text("scene"),
          .inputs = read_inputs(store),
          .equilibration = equilibration(store.read_doubles("equilibration"))};
}

} // namespace mesobridge::workflows
