#include "workflows/star/blob_file.hpp"
#include "md/error.hpp"
#include <algorithm>

namespace mesobridge::workflows {

namespace {

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

constexpr char const* last_column = "blobs/Phi"; ///< the one that append writes last

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
    : store_(file, Store::Mode::create) {
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
  store_.flush();
}

BlobFile BlobFile::continue_file(std::filesystem::path const& file, std::string const& fingerprint) {
  {
    Store const store(file, Store::Mode::read);
    refuse_other(store, file);
    if (auto const was = store.read_text_attribute("settings", "fingerprint"); was != fingerprint)
      throw InputError(fmt::format("--resume: '{}' was made with other settings ({}); without --resume it is "
                                   "replaced",
                                   file.string(), was));
  }
  return BlobFile(Store(file, Store::Mode::append));
}

std::size_t BlobFile::frames() const {
  return store_.contains(last_column) ? store_.shape(last_column)[0] : 0;
}

void BlobFile::append_column(std::string const& path, std::span<double const> row, std::size_t frame,
                             Store::Shape const& shape) {
  // A run that was killed between two columns left the earlier ones longer.
  if (!store_.contains(path) || store_.shape(path)[0] <= frame)
    store_.append(path, row, shape);
}

void BlobFile::append(std::span<cg::BlobFrame const> frames) {
  for (auto const& frame : frames) {
    if (!next_) { // frames that an interrupted run has written are not written again
      auto const steps =
          store_.contains("frames/step") ? store_.read_integers("frames/step") : std::vector<std::int64_t>{};
      next_ = std::size_t(std::lower_bound(steps.begin(), steps.end(), frame.step) - steps.begin());
    }
    std::size_t const k = (*next_)++;
    if (k < this->frames())
      continue;
    if (!store_.contains("frames/step") || store_.shape("frames/step")[0] <= k)
      store_.append("frames/step", std::span<std::int64_t const>(&frame.step, 1));
    append_column("frames/time", std::span(&frame.time, 1), k, {});
    std::vector<double> const edges{frame.box.edge.x, frame.box.edge.y, frame.box.edge.z};
    append_column("frames/box", edges, k, {3});
    append_column("frames/energy", std::span(&frame.energy, 1), k, {});
    append_column("frames/pressure", std::span(&frame.pressure, 1), k, {});
    auto const n = frame.blobs.size();
    append_column("blobs/R", flat(frame, &cg::Blob::R), k, {n, 3});
    append_column("blobs/P", flat(frame, &cg::Blob::P), k, {n, 3});
    append_column("blobs/F", flat(frame, &cg::Blob::F), k, {n, 3});
    append_column("blobs/U_kin", scalars(frame, &cg::Blob::U_kin), k, {n});
    append_column("blobs/U_pot", scalars(frame, &cg::Blob::U_pot), k, {n});
    append_column(last_column, scalars(frame, &cg::Blob::Phi), k, {n});
  }
  store_.flush();
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
  if (!store.contains(last_column))
    throw InputError(
        fmt::format("'{}' holds no frame yet: the run has not reached its sampling", file.string()));
  std::size_t const frames = store.shape(last_column)[0];
  std::size_t const blobs = frames * std::size_t(data.head.molecules);
  auto const column = [&](char const* path, std::size_t count) {
    auto values = store.read_doubles(path);
    values.resize(count);
    return values;
  };
  data.steps = store.read_integers("frames/step");
  data.steps.resize(frames);
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
