#include "workflows/star/held_file.hpp"
#include "md/error.hpp"

namespace mesobridge::workflows {
namespace {

bool is_held(Store const& store) {
  bool const may_be = store.contains("settings") && store.has_attribute("settings", "kind") &&
                      store.has_attribute("settings", "frames_of_each");
  return may_be && store.read_text_attribute("settings", "kind") == "held";
}

void refuse_not_held(Store const& store, std::filesystem::path const& file) {
  if (!is_held(store))
    throw InputError(fmt::format(
        "'{}' holds no molecules whose centres were held: `md held-blobs` makes such files", file.string()));
}

std::int64_t read_frames_of_each(Store const& store) {
  return store.read_integer_attribute("settings", "frames_of_each", {.least = 1, .most = 1e9});
}

/// The frames of each configuration stand together, as many in each but the last.
void check_order(HeldData const& data, std::vector<std::int64_t> const& configurations,
                 std::filesystem::path const& file) {
  for (std::size_t k = 0; k < data.steps.size(); ++k) {
    if (configurations[k] != std::int64_t(k / data.frames_of_each))
      throw InputError(fmt::format("'{}': frames/configuration[{}] = {}: each configuration has {} frames",
                                   file.string(), k, configurations[k], data.frames_of_each));
    if (k > 0 && !(data.times[k] > data.times[k - 1]))
      throw InputError(fmt::format("'{}': frames/time[{}] = {} is not after {}: times must grow",
                                   file.string(), k, data.times[k], data.times[k - 1]));
  }
}

} // namespace

HeldFile::HeldFile(std::filesystem::path const& file, BlobFileHead const& head, std::int64_t frames,
                   Provenance const& provenance)
    : store_(file, Store::Mode::create, Store::Safety::marked), frames_of_each_(frames) {
  write_provenance(store_, provenance);
  write_head(store_, head);
  store_.set_attribute("settings", "frames_of_each", frames);
  store_.mark();
}

HeldFile HeldFile::continue_file(std::filesystem::path const& file, std::string const& fingerprint) {
  Store::mend(file);
  {
    Store const store(file, Store::Mode::read);
    refuse_not_held(store, file);
    refuse_other_settings(store, fingerprint);
  }
  HeldFile held(Store(file, Store::Mode::append, Store::Safety::marked));
  held.frames_of_each_ = read_frames_of_each(held.store_);
  if (auto const& store = held.store_; store.contains("frames/step")) {
    held.frames_ = std::int64_t(store.rows("frames/step"));
    held.last_step_ = store.read_integer_row("frames/step", std::size_t(held.frames_) - 1).at(0);
  }
  return held;
}

void HeldFile::append(cg::BlobFrame const& frame) {
  if (frame.step <= last_step_)
    return;
  auto const add = [&](char const* path, std::span<double const> row, Store::Shape const& shape = {}) {
    store_.append(path, row, shape);
  };
  auto const n = frame.blobs.size();
  if (frames_ % frames_of_each_ == 0) {
    add("configurations/R", row_of(frame, &cg::Blob::R), {n, 3});
    add("configurations/box", std::vector{frame.box.edge.x, frame.box.edge.y, frame.box.edge.z}, {3});
  }
  std::int64_t const configuration = frames_++ / frames_of_each_;
  store_.append("frames/configuration", std::span(&configuration, 1));
  store_.append("frames/step", std::span(&frame.step, 1));
  add("frames/time", std::span(&frame.time, 1));
  add("frames/energy", std::span(&frame.energy, 1));
  add("blobs/F", row_of(frame, &cg::Blob::F), {n, 3});
  add("blobs/U_kin", row_of(frame, &cg::Blob::U_kin), {n});
  add("blobs/U_pot", row_of(frame, &cg::Blob::U_pot), {n});
  add("blobs/Phi", row_of(frame, &cg::Blob::Phi), {n});
}

bool holds_held(std::filesystem::path const& file) {
  return is_held(Store(file, Store::Mode::read));
}

HeldData read_held(std::filesystem::path const& file) {
  Store const store(file, Store::Mode::read);
  refuse_not_held(store, file);
  HeldData data;
  data.head = read_head(store);
  data.frames_of_each = std::size_t(read_frames_of_each(store));
  if (!store.contains("frames/step"))
    throw InputError(fmt::format("'{}' holds no frame yet: the run has not reached its first configuration",
                                 file.string()));
  std::size_t const frames = store.rows("frames/step"), molecules = data.molecules(),
                    configurations = (frames + data.frames_of_each - 1) / data.frames_of_each;
  Expected const number{.rows = frames, .row_shape = Store::Shape{}},
      of_blobs{.rows = frames, .row_shape = Store::Shape{molecules}},
      forces{.rows = frames, .row_shape = Store::Shape{molecules, 3}},
      places{.rows = configurations, .row_shape = Store::Shape{molecules, 3}},
      edges{.rows = configurations, .row_shape = Store::Shape{3}, .bounds = {.above = 0}};
  data.steps = store.read_integers("frames/step", number);
  data.times = store.read_doubles("frames/time", number);
  data.energies = store.read_doubles("frames/energy", number);
  check_order(data, store.read_integers("frames/configuration", number), file);
  for (Vec3 const& edge : vectors_of(store.read_doubles("configurations/box", edges)))
    data.boxes.push_back({edge});
  data.R = vectors_of(store.read_doubles("configurations/R", places));
  data.F = vectors_of(store.read_doubles("blobs/F", forces));
  data.U_kin = store.read_doubles("blobs/U_kin", of_blobs);
  data.U_pot = store.read_doubles("blobs/U_pot", of_blobs);
  data.Phi = store.read_doubles("blobs/Phi", of_blobs);
  return data;
}

} // namespace mesobridge::workflows
