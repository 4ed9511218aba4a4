#include "workflows/star/blob_file.hpp"
#include "md/error.hpp"
#include "workflows/trajectory/unit_style.hpp"
#include <algorithm>

namespace mesobridge::workflows {

namespace {

void refuse_other(Store const& store, std::filesystem::path const& file) {
  if (!store.contains("settings") || !store.has_attribute("settings", "atoms_per_molecule"))
    throw InputError(
        fmt::format("'{}' holds no blobs of `md star-melt`, `md star-vacuum` or `cg blobs`", file.string()));
}

void refuse_held(BlobFileHead const& head, std::filesystem::path const& file) {
  if (head.kind == "held")
    throw InputError(
        fmt::format("'{}' holds molecules whose centres were held: `cg friction` reads it", file.string()));
}

/// Versions without marks left columns of different lengths when they were killed while they wrote.
void refuse_ragged(Store const& store, std::filesystem::path const& file) {
  auto const frames = store.rows("frames/step");
  for (std::string const group : {"frames", "blobs"})
    for (auto const& name : store.list(group))
      if (auto const rows = store.rows(group + "/" + name); rows != frames || rows == 0)
        throw InputError(fmt::format("'{}': {}/{} has {} rows, frames/step {}: the run that wrote it was "
                                     "broken off in the middle; make it again without --resume",
                                     file.string(), group, name, rows, frames));
}

bool says_tilts(Store const& store) {
  return store.has_attribute("settings", "may_tilt");
}

void read_tilts(Store const& store, std::vector<Box>& boxes) {
  auto const tilts =
      vectors_of(store.read_doubles("frames/tilt", {.rows = boxes.size(), .row_shape = Store::Shape{3}}));
  for (std::size_t k = 0; k < boxes.size(); ++k)
    boxes[k].xy = tilts[k].x, boxes[k].xz = tilts[k].y, boxes[k].yz = tilts[k].z;
}

} // namespace

std::vector<Vec3> vectors_of(std::vector<double> const& flat) {
  std::vector<Vec3> result(flat.size() / 3);
  for (std::size_t k = 0; k < result.size(); ++k)
    result[k] = {flat[3 * k], flat[3 * k + 1], flat[3 * k + 2]};
  return result;
}

std::vector<double> row_of(cg::BlobFrame const& frame, double cg::Blob::*member) {
  std::vector<double> row;
  for (auto const& blob : frame.blobs)
    row.push_back(blob.*member);
  return row;
}

std::vector<double> row_of(cg::BlobFrame const& frame, Vec3 cg::Blob::*member) {
  std::vector<double> row;
  for (auto const& blob : frame.blobs)
    row.insert(row.end(), {(blob.*member).x, (blob.*member).y, (blob.*member).z});
  return row;
}

void write_head(Store& store, BlobFileHead const& head) {
  store.set_attribute("settings", "kind", head.kind);
  store.set_attribute("settings", "name", head.name);
  store.set_attribute("settings", "fingerprint", head.fingerprint);
  store.set_attribute("settings", "molecules", std::int64_t{head.molecules});
  store.set_attribute("settings", "atoms_per_molecule", std::int64_t{head.atoms});
  store.set_attribute("settings", "mass", head.mass);
  store.set_attribute("settings", "rho", head.rho);
  store.set_attribute("settings", "T", head.T);
  BlobFileHead const usual;
  if (head.units != usual.units)
    store.set_attribute("settings", "unit_system", head.units);
  if (head.walls != usual.walls)
    store.set_attribute("settings", "walls", head.walls);
  if (head.may_tilt)
    store.set_attribute("settings", "may_tilt", std::int64_t{1});
  if (head.time_unit != usual.time_unit)
    store.set_attribute("settings", "time_unit", head.time_unit);
  if (!head.set.empty())
    store.write("settings/set", std::span<double const>(head.set));
}

BlobFileHead read_head(Store const& store) {
  constexpr double most = 1e9; // of counts that are multiplied with each other
  BlobFileHead head;
  head.kind = store.read_text_attribute("settings", "kind");
  head.name = store.read_text_attribute("settings", "name");
  head.fingerprint = store.read_text_attribute("settings", "fingerprint");
  head.molecules = int(store.read_integer_attribute("settings", "molecules", {.least = 1, .most = most}));
  head.atoms =
      int(store.read_integer_attribute("settings", "atoms_per_molecule", {.least = 1, .most = most}));
  head.mass = store.read_double_attribute("settings", "mass", {.above = 0});
  head.rho = store.read_double_attribute("settings", "rho", {.least = 0});
  head.T = store.read_double_attribute("settings", "T", {.least = 0});
  bool const has_levels = head.kind.starts_with("vacuum"); // which no analysis can do without
  if (has_levels || store.contains("settings/set"))
    head.set = store.read_doubles("settings/set",
                                  {.rows = std::size_t(head.molecules), .row_shape = Store::Shape{}});
  auto const if_there = [&](char const* name, std::string& into) {
    if (store.has_attribute("settings", name))
      into = store.read_text_attribute("settings", name);
  };
  if_there("unit_system", head.units);
  if_there("walls", head.walls);
  head.may_tilt = says_tilts(store);
  if_there("time_unit", head.time_unit);
  return head;
}

void refuse_other_settings(Store const& store, std::string const& fingerprint) {
  if (auto const was = store.read_text_attribute("settings", "fingerprint"); was != fingerprint)
    throw InputError(fmt::format("--resume: '{}' was made with other settings ({}); without --resume it is "
                                 "replaced",
                                 store.file().string(), was));
}

BlobFile::BlobFile(std::filesystem::path const& file, BlobFileHead const& head, Provenance const& provenance)
    : store_(file, Store::Mode::create, Store::Safety::marked), may_tilt_(head.may_tilt) {
  write_provenance(store_, provenance);
  write_head(store_, head);
  store_.mark();
}

BlobFile BlobFile::continue_file(std::filesystem::path const& file, std::string const& fingerprint) {
  Store::mend(file);
  {
    Store const store(file, Store::Mode::read);
    refuse_other(store, file);
    refuse_other_settings(store, fingerprint);
  }
  BlobFile blobs(Store(file, Store::Mode::append, Store::Safety::marked));
  blobs.may_tilt_ = says_tilts(blobs.store_);
  if (auto const& store = blobs.store_; store.contains("frames/step")) {
    refuse_ragged(store, file);
    blobs.last_step_ = store.read_integer_row("frames/step", store.rows("frames/step") - 1).at(0);
  }
  return blobs;
}

void BlobFile::append(std::span<cg::BlobFrame const> frames) {
  for (auto const& frame : frames) {
    if (frame.step <= last_step_)
      continue;
    auto const add = [&](char const* path, std::span<double const> row, Store::Shape const& shape = {}) {
      store_.append(path, row, shape);
    };
    store_.append("frames/step", std::span<std::int64_t const>(&frame.step, 1));
    add("frames/time", std::span(&frame.time, 1));
    add("frames/box", std::vector{frame.box.edge.x, frame.box.edge.y, frame.box.edge.z}, {3});
    if (may_tilt_)
      add("frames/tilt", std::vector{frame.box.xy, frame.box.xz, frame.box.yz}, {3});
    add("frames/energy", std::span(&frame.energy, 1));
    add("frames/pressure", std::span(&frame.pressure, 1));
    auto const n = frame.blobs.size();
    add("blobs/R", row_of(frame, &cg::Blob::R), {n, 3});
    add("blobs/P", row_of(frame, &cg::Blob::P), {n, 3});
    add("blobs/F", row_of(frame, &cg::Blob::F), {n, 3});
    add("blobs/U_kin", row_of(frame, &cg::Blob::U_kin), {n});
    add("blobs/U_pot", row_of(frame, &cg::Blob::U_pot), {n});
    add("blobs/Phi", row_of(frame, &cg::Blob::Phi), {n});
  }
  store_.mark();
}

void BlobFile::close() {
  store_.close();
}

BlobFileHead read_blob_head(std::filesystem::path const& file) {
  Store const store(file, Store::Mode::read);
  refuse_other(store, file);
  auto const head = read_head(store);
  refuse_held(head, file);
  return head;
}

void refuse_walls(BlobFileHead const& head, std::filesystem::path const& file, std::string const& what) {
  if (!head.walls.empty())
    throw InputError(fmt::format("'{}': the box is not periodic along {}: {} are those of a periodic box",
                                 file.string(), head.walls, what));
}

std::string units_text(BlobFileHead const& head) {
  return head.units == "lj" ? "reduced Lennard-Jones"
                            : fmt::format("LAMMPS {} ({}); masses so that m v^2 is an energy", head.units,
                                          unit_style(head.units).description);
}

BlobData read_blobs(std::filesystem::path const& file) {
  Store const store(file, Store::Mode::read);
  refuse_other(store, file);
  BlobData data;
  data.head = read_head(store);
  refuse_held(data.head, file);
  if (!store.contains("frames/step"))
    throw InputError(
        fmt::format("'{}' holds no frame yet: the run has not reached its sampling", file.string()));
  refuse_ragged(store, file);
  std::size_t const frames = store.rows("frames/step"), molecules = std::size_t(data.head.molecules);
  Expected const number{.rows = frames, .row_shape = Store::Shape{}},
      of_blobs{.rows = frames, .row_shape = Store::Shape{molecules}},
      vectors_of_blobs{.rows = frames, .row_shape = Store::Shape{molecules, 3}};
  data.steps = store.read_integers("frames/step", number);
  data.times = store.read_doubles("frames/time", number);
  data.energies = store.read_doubles("frames/energy", number);
  data.pressures = store.read_doubles("frames/pressure", number);
  for (auto const& edge : vectors_of(store.read_doubles(
           "frames/box", {.rows = frames, .row_shape = Store::Shape{3}, .bounds = {.above = 0}})))
    data.boxes.push_back({edge});
  if (data.head.may_tilt)
    read_tilts(store, data.boxes);
  data.R = vectors_of(store.read_doubles("blobs/R", vectors_of_blobs));
  data.P = vectors_of(store.read_doubles("blobs/P", vectors_of_blobs));
  data.U_kin = store.read_doubles("blobs/U_kin", of_blobs);
  data.U_pot = store.read_doubles("blobs/U_pot", of_blobs);
  data.Phi = store.read_doubles("blobs/Phi", of_blobs);
  for (std::size_t frame = 1; frame < frames; ++frame)
    if (!(data.times[frame] > data.times[frame - 1]))
      throw InputError(fmt::format("'{}': frames/time[{}] = {} is not after {}: times must grow",
                                   file.string(), frame, data.times[frame], data.times[frame - 1]));
  return data;
}

std::vector<Vec3> read_blob_forces(std::filesystem::path const& file) {
  Store const store(file, Store::Mode::read);
  refuse_other(store, file);
  if (!store.contains("blobs/F"))
    throw InputError(fmt::format("'{}' holds no forces on its molecules (blobs/F)", file.string()));
  auto const molecules = std::size_t(read_head(store).molecules);
  return vectors_of(store.read_doubles(
      "blobs/F", {.rows = store.rows("frames/step"), .row_shape = Store::Shape{molecules, 3}}));
}

} // namespace mesobridge::workflows
