#include "workflows/sdpd/checkpoint_file.hpp"
#include "workflows/store/durable_file.hpp"
#include "workflows/store/seal.hpp"
#include <algorithm>
#include <cstdio>
#include <unistd.h>

namespace mesobridge::workflows {
namespace {

// Three doubles in a row are what HDF5 shall see of a vector.
static_assert(sizeof(Vec3) == 3 * sizeof(double) && std::is_standard_layout_v<Vec3>);

std::span<double const> numbers(std::vector<Vec3> const& vectors) {
  return {reinterpret_cast<double const*>(vectors.data()), 3 * vectors.size()};
}

/// The layout of a checkpoint; it counts up when that changes.
constexpr std::int64_t layout = 2;

/// Reads a checkpoint's datasets and refuses what no run can have written.
class Reader {
 public:
  explicit Reader(std::filesystem::path const& file) : store_(file, Store::Mode::read) {
    require_that(store_.has_attribute("layout", "version") &&
                     store_.read_integer_attribute("layout", "version") == layout,
                 "its layout is not that of this version of the program");
  }

  std::vector<std::int64_t> integers(char const* name, std::size_t count) const {
    auto const values = store_.read_integers(name);
    require_that(values.size() == count,
                 fmt::format("'{}' holds {} numbers instead of {}", name, values.size(), count));
    require_that(std::ranges::all_of(values, [](auto value) { return value >= 0; }),
                 fmt::format("'{}' holds a negative number", name));
    return values;
  }

  std::vector<double> doubles(std::string const& name, std::size_t count) const {
    auto const values = store_.read_doubles(name);
    require_that(values.size() == count,
                 fmt::format("'{}' holds {} numbers instead of {}", name, values.size(), count));
    require_that(std::ranges::all_of(values, [](double value) { return std::isfinite(value); }),
                 fmt::format("'{}' holds a number that is not finite", name));
    return values;
  }
  std::vector<double> doubles_if_there(std::string const& name, std::size_t count) const {
    return store_.contains(name) ? doubles(name, count) : std::vector<double>();
  }

  std::vector<Vec3> vectors(char const* name, std::size_t count) const {
    auto const numbers = doubles(name, 3 * count);
    std::vector<Vec3> result(count);
    for (std::size_t i = 0; i < count; ++i)
      result[i] = {numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2]};
    return result;
  }

  sdpd::Particles particles() const {
    sdpd::Particles all;
    all.id = ids();
    all.q = vectors("q", all.size()), all.p = vectors("p", all.size());
    for (auto const& field : sdpd::fields)
      if (field.checkpointed)
        all.*field.values = doubles_if_there(std::string(field.name), all.size());
    return all;
  }

  /// Numbers of the particles: each from 0 on, once.
  std::vector<std::uint32_t> ids() const {
    auto const shape = store_.shape("id");
    require_that(shape.size() == 1 && shape[0] > 0, "'id' is no row of numbers");
    auto const stored = integers("id", shape[0]);
    std::vector<bool> seen(stored.size(), false);
    for (auto const id : stored) {
      require_that(std::size_t(id) < seen.size() && !seen[std::size_t(id)],
                   fmt::format("'id' holds {}, which is out of range or there twice", id));
      seen[std::size_t(id)] = true;
    }
    return {stored.begin(), stored.end()};
  }

  sdpd::PairCounts pair_counts(char const* name) const {
    auto const stored = integers(name, 3);
    auto at = [&](std::size_t k) { return static_cast<std::uint64_t>(stored[k]); };
    return {.proposed = at(0), .out_of_domain = at(1), .metropolis = at(2)};
  }

  /// Impulse and work of the lower and the upper walls of some axes, and their time, where there are walls.
  std::vector<double> walls() const { return doubles_if_there("walls", 4 * walled_axes() + 1); }
  /// Drag and heat of these walls, where there are any, and the body force's work and sink.
  std::vector<double> flow() const { return doubles_if_there("flow", 8 * walled_axes() + 2); }
  /// Its time, and both rates of every particle where the next step begins with them.
  std::vector<double> reaction(std::size_t particles) const {
    auto const shape = store_.contains("reaction") ? store_.shape("reaction") : Store::Shape{1};
    require_that(shape.size() == 1 && (shape[0] == 1 || shape[0] == 1 + 2 * particles),
                 "'reaction' is neither its time nor that and two rates for each particle");
    return doubles_if_there("reaction", shape[0]);
  }

  std::string scene() const { return store_.read_text("scene"); }
  std::vector<InputFile> inputs() const { return read_inputs(store_); }

  sdpd::EquilibrationProgress equilibration() const {
    auto const stored = doubles("equilibration", 3);
    require_that(stored[0] >= 0 && stored[0] < 0x1p53, "'equilibration' begins with no number of steps");
    return {.done = static_cast<std::uint64_t>(stored[0]), .sum_T_kin = stored[1], .sum_T_int = stored[2]};
  }

 private:
  std::size_t walled_axes() const {
    auto const shape = store_.contains("walls") ? store_.shape("walls") : Store::Shape{1};
    require_that(shape.size() == 1 && shape[0] <= 13, "'walls' is no row of the numbers of up to six walls");
    return shape[0] / 4;
  }

  void require_that(bool condition, std::string const& fault) const {
    if (!condition)
      throw InputError(fmt::format("cannot go on from checkpoint '{}': {}", store_.file().string(), fault));
  }

  Store store_;
};

std::array<std::int64_t, 3> integers(sdpd::PairCounts const& counts) {
  return {static_cast<std::int64_t>(counts.proposed), static_cast<std::int64_t>(counts.out_of_domain),
          static_cast<std::int64_t>(counts.metropolis)};
}

} // namespace

std::filesystem::path previous_checkpoint(std::filesystem::path const& file) {
  return std::filesystem::path(file).replace_extension(".previous" + file.extension().string());
}

namespace {

bool is_whole(std::filesystem::path const& file) {
  try {
    return std::filesystem::exists(file) && sealed_length(file);
  } catch (InputError const&) {
    return false;
  }
}

/// Makes the last checkpoint, unless it is damaged, the previous one as well; it keeps its own name where the
/// file system has links.
void keep_as_previous(std::filesystem::path const& file) {
  auto const previous = previous_checkpoint(file), scratch = std::filesystem::path(previous).concat(".new");
  if (!is_whole(file))
    return;
  unlink(scratch.c_str());
  bool const linked = link(file.c_str(), scratch.c_str()) == 0;
  // Without waiting for the disk: it keeps the order of names, and the next one is waited for.
  if (std::rename(linked ? scratch.c_str() : file.c_str(), previous.c_str()) != 0)
    fail_to("write", previous);
}

void write_datasets(Store& store, sdpd::Checkpoint const& c, Provenance const& provenance,
                    sdpd::EquilibrationProgress const& equilibration) {
  auto const& particles = c.particles;
  std::size_t const n = particles.size();
  std::int64_t const step = static_cast<std::int64_t>(c.step);
  std::vector<std::int64_t> const id(particles.id.begin(), particles.id.end());
  store.set_attribute("layout", "version", layout);
  store.write("step", std::span(&step, 1));
  store.write("id", id);
  store.write("q", numbers(particles.q), {n, 3});
  store.write("q_at_renewal", numbers(c.q_at_renewal), {n, 3});
  store.write("p", numbers(particles.p), {n, 3});
  for (auto const& field : sdpd::fields)
    if (auto const& values = particles.*field.values; field.checkpointed && !values.empty())
      store.write(std::string(field.name), values);
  store.write("kept_energy", std::span(&c.kept_energy, 1));
  store.write("pair_counts", integers(c.pair_counts));
  store.write("conduction_counts", integers(c.conduction_counts));
  if (!c.walls.empty())
    store.write("walls", c.walls);
  if (!c.flow.empty())
    store.write("flow", c.flow);
  if (!c.reaction.empty())
    store.write("reaction", c.reaction);
  store.write("equilibration", std::array{static_cast<double>(equilibration.done), equilibration.sum_T_kin,
                                          equilibration.sum_T_int});
  write_provenance(store, provenance);
  store.write("scene", provenance.scene);
}

/// The checksum comes first: HDF5 is not to be led astray by a damaged file.
StoredCheckpoint read_whole(std::filesystem::path const& file) {
  if (!std::filesystem::exists(file))
    throw InputError(fmt::format("cannot read '{}': No such file or directory", file.string()));
  if (!sealed_length(file))
    throw InputError(fmt::format("cannot go on from checkpoint '{}': it is incomplete, or of another version "
                                 "of the program",
                                 file.string()));
  Reader const reader(file);
  auto particles = reader.particles();
  auto const n = particles.size();
  return {.checkpoint = {.step = static_cast<std::uint64_t>(reader.integers("step", 1)[0]),
                         .particles = std::move(particles),
                         .q_at_renewal = reader.vectors("q_at_renewal", n),
                         .kept_energy = reader.doubles("kept_energy", 1)[0],
                         .pair_counts = reader.pair_counts("pair_counts"),
                         .conduction_counts = reader.pair_counts("conduction_counts"),
                         .walls = reader.walls(),
                         .flow = reader.flow(),
                         .reaction = reader.reaction(n)},
          .scene = reader.scene(),
          .inputs = reader.inputs(),
          .equilibration = reader.equilibration(),
          .warning = ""};
}

} // namespace

void write_checkpoint(std::filesystem::path const& file, sdpd::Checkpoint const& checkpoint,
                      Provenance const& provenance, sdpd::EquilibrationProgress const& equilibration) {
  auto const fresh = std::filesystem::path(file).concat(".new");
  Store store(fresh, Store::Mode::create);
  write_datasets(store, checkpoint, provenance, equilibration);
  store.close();
  seal(fresh);
  keep_as_previous(file);
  replace(fresh, file);
}

bool checkpoint_exists(std::filesystem::path const& file) {
  return std::filesystem::exists(file) || std::filesystem::exists(previous_checkpoint(file));
}

void remove_checkpoints(std::filesystem::path const& file) {
  for (auto const& each : {file, previous_checkpoint(file)}) {
    std::error_code error;
    std::filesystem::remove(each, error);
    if (error)
      throw EnvironmentError(fmt::format("cannot remove '{}': {}", each.string(), error.message()));
  }
}

StoredCheckpoint read_checkpoint(std::filesystem::path const& file) {
  try {
    return read_whole(file);
  } catch (InputError const& fault) {
    auto const previous = previous_checkpoint(file);
    if (!std::filesystem::exists(previous))
      throw;
    auto stored = read_whole(previous);
    stored.warning = fmt::format("{}; going on from the one before it, '{}', at step {}", fault.what(),
                                 previous.string(), stored.checkpoint.step);
    return stored;
  }
}

} // namespace mesobridge::workflows
