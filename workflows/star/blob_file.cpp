#include "workflows/star/blob_file.hpp"
#include "md/error.hpp"
#include <algorithm>

namespace mesobridge::workflows {

namespace {

constexpr std::int64_t before_all = -1; ///< a step

std::vector<Vec3> vectors(std::vector<double> const& flat, std::size_t count) {
  std::vector<Vec3> result(count);
  for (std::size_t k = 0; k < count; ++k)
    result[k] = {flat[3 * k], flat[3 * k + 1], flat[3 * k + 2]};
  return result;
}

/// One number of each blob.
std::vector<double> scalars(cg::BlobFrame const& frame, double cg::Blob::*member) {
  std::vector<double> row;
  for (auto const& blob : frame.blobs)
    row.push_back(blob.*member);
  return row;
}

std::vector<double> flat(cg::BlobFrame const& frame, Vec3 cg::Blob::*member) {
  std::vector<double> row;
  for (auto const& blob : frame.blobs)
    row.insert(row.end(), {(blob.*member).x, (blob.*member).y, (blob.*member).z});
  return row;
}

BlobFileHead read_head(Store const& store) {
  BlobFileHead head;
  head.kind = store.read_text_attribute("settings", "kind");
  head.name = store.read_text_attribute("settings", "name");
  head.fingerprint = store.read_text_attribute("settings", "fingerprint");
  head.molecules = int(store.read_integer_attribute("settings", "molecules"));
  head.atoms = int(store.read_integer_attribute("settings", "atoms_per_molecule"));
  head.mass = store.read_double_attribute("settings", "mass");
  head.rho = store.read_double_attribute("settings", "rho");
  head.T = store.read_double_attribute("settings", "T");
  if (store.contains("settings/set"))
    head.set = store.read_doubles("settings/set");
  return head;
}

void refuse_other(Store const& store, std::filesystem::path const& file) {
  if (!store.contains("settings") || !store.has_attribute("settings", "atoms_per_molecule"))
    throw InputError(
        fmt::format("'{}' holds no blobs of `md star-melt`, `md star-vacuum` or `cg blobs`", file.string()));
}

} // namespace

BlobFile::BlobFile(std::filesystem::path const& file, BlobFileHead const& head, Provenance const& provenance)
    : store_(file, Store::Mode::create, Store::Safety::marked) {
  write_provenance(store_, provenance);
  store_.set_attribute("settings", "kind", head.kind);
  store_.set_attribute("settings", "name", head.name);
  store_.set_attribute("settings", "fingerprint", head.fingerprint);
  store_.set_attribute("settings", "molecules", std::int64_t{head.molecules});
  store_.set_attribute("settings", "atoms_per_molecule", std::int64_t{head.atoms});
  store_.set_attribute("settings", "mass", head.mass);
  store_.set_attribute("settings", "rho", head.rho);
  store_.set_attribute("settings", "T", head.T);
  if (!head.set.empty())
    store_.write("settings/set", std::span<double const>(head.set));
  store_.mark();
}

BlobFile BlobFile::continue_file(std::filesystem::path const& file, std::string const& fingerprint) {
  Store::mend(file);
  {
    Store const store(file, Store::Mode::read);
    refuse_other(store, file);
    if (auto const was = store.read_text_attribute("settings", "fingerprint"); was != fingerprint)
      throw InputError(fmt::format("--resume: '{}' was made with other settings ({}); without --resume it is "
                                   "replaced",
                                   file.string(), was));
  }
  return BlobFile(Store(file, Store::Mode::append, Store::Safety::marked));
}

void BlobFile::append(std::span<cg::BlobFrame const> frames) {
  for (auto const& frame : frames) {
    if (!last_step_) // a resumed run makes the frames after its checkpoint once more
      last_step_ = store_.contains("frames/step") ? store_.read_integers("frames/step").back() : before_all;
    if (frame.step <= *last_step_)
      continue;
    last_step_ = frame.step;
    auto const add = [&](char const* path, std::span<double const> row, Store::Shape const& shape = {}) {
      store_.append(path, row, shape);
    };
    store_.append("frames/step", std::span<std::int64_t const>(&frame.step, 1));
    add("frames/time", std::span(&frame.time, 1));
    add("frames/box", std::vector{frame.box.edge.x, frame.box.edge.y, frame.box.edge.z}, {3});
    add("frames/energy", std::span(&frame.energy, 1));
    add("frames/pressure", std::span(&frame.pressure, 1));
    auto const n = frame.blobs.size();
    add("blobs/R", flat(frame, &cg::Blob::R), {n, 3});
    add("blobs/P", flat(frame, &cg::Blob::P), {n, 3});
    add("blobs/F", flat(frame, &cg::Blob::F), {n, 3});
    add("blobs/U_kin", scalars(frame, &cg::Blob::U_kin), {n});
    add("blobs/U_pot", scalars(frame, &cg::Blob::U_pot), {n});
    add("blobs/Phi", scalars(frame, &cg::Blob::Phi), {n});
  }
  store_.mark();
}

void BlobFile::close() {
  store_.close();
}

BlobFileHead read_blob_head(std::filesystem::path const& file) {
  Store const store(file, Store::Mode::read);
  refuse_other(store, file);
  return read_head(store);
}

BlobData read_blobs(std::filesystem::path const& file) {
  Store const store(file, Store::Mode::read);
  refuse_other(store, file);
  BlobData data;
  data.head = read_head(store);
  if (!store.contains("frames/step"))
    throw InputError(
        fmt::format("'{}' holds no frame yet: the run has not reached its sampling", file.string()));
  std::size_t const frames = store.shape("frames/step")[0];
  std::size_t const blobs = frames * std::size_t(data.head.molecules);
  auto const column = [&](char const* path, std::size_t count) {
    auto values = store.read_doubles(path);
    if (values.size() != count)
      throw InputError(fmt::format("'{}': {} has {} numbers, but {} frames need {}", file.string(), path,
                                   values.size(), frames, count));
    return values;
  };
  data.steps = store.read_integers("frames/step");
  data.times = column("frames/time", frames);
  data.energies = column("frames/energy", frames);
  data.pressures = column("frames/pressure", frames);
  for (auto const& edge : vectors(column("frames/box", 3 * frames), frames))
    data.boxes.push_back({edge});
  data.R = vectors(column("blobs/R", 3 * blobs), blobs);
  data.P = vectors(column("blobs/P", 3 * blobs), blobs);
  data.U_kin = column("blobs/U_kin", blobs);
  data.U_pot = column("blobs/U_pot", blobs);
  data.Phi = column("blobs/Phi", blobs);
  return data;
}

} // namespace mesobridge::workflows
