#include "workflows/store/damage_guard.hpp"
#include "workflows/store/file_lock.hpp"
#include "workflows/store/seal.hpp"
#include "workflows/store/store_implementation.hpp"
#include <fcntl.h>

namespace mesobridge::workflows {

Store::Store(std::filesystem::path file, Mode mode, Safety safety)
    : implementation_(std::make_unique<Implementation>()) {
  prepare_hdf5();
  auto& self = *implementation_;
  self.file = std::move(file), self.safety = safety;
  auto const name = self.file.string();
  auto const wait_for_others = [&](FileLock::Kind kind) {
    FileLock const held_for_a_moment(self.file, kind);
  };
  if (mode == Mode::create) {
    if (std::filesystem::exists(self.file))
      wait_for_others(FileLock::Kind::exclusive);
    UndoJournal::discard(self.file); // of a file of that name that is no more
    self.handle = self.check(
        {H5Fcreate(name.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, self.access(mode).get()), H5Fclose}, "create");
    return;
  }
  if (!std::filesystem::exists(self.file))
    throw InputError(fmt::format("cannot read '{}': No such file or directory", name));
  if (mode == Mode::append && safety == Safety::marked)
    self.begin_journal();
  else
    wait_for_others(mode == Mode::read ? FileLock::Kind::shared : FileLock::Kind::exclusive);
  DamageGuard const guard(self.file);
  if (H5Fis_hdf5(name.c_str()) <= 0)
    throw InputError(fmt::format("cannot read '{}': not an HDF5 file", name));
  auto const flags = mode == Mode::read ? H5F_ACC_RDONLY : H5F_ACC_RDWR;
  if (mode == Mode::read)
    UndoJournal::wait_for_writer(self.file);
  if (mode == Mode::read && UndoJournal::exists(self.file)) {
    self.handle = {H5Fopen(name.c_str(), flags, self.access(mode).get()), H5Fclose};
    if (!self.handle.valid())
      throw InputError(
          fmt::format("cannot read '{}': the run that wrote it was broken off; go on with --resume, "
                      "which mends it",
                      name));
    return;
  }
  Hdf5Handle handle(H5Fopen(name.c_str(), flags, self.access(mode).get()), H5Fclose);
  if (!handle.valid()) { // a lock that was held for a moment only is no reason
    wait_for_others(mode == Mode::read ? FileLock::Kind::shared : FileLock::Kind::exclusive);
    handle = {H5Fopen(name.c_str(), flags, self.access(mode).get()), H5Fclose};
  }
  self.handle = self.opened(std::move(handle), "cannot open");
}

Store::Store(Store&&) noexcept = default;
Store::~Store() = default;

void Store::write(std::string const& path, std::span<double const> values, Shape const& shape) {
  implementation_->write(path, values, shape);
}
void Store::write(std::string const& path, std::span<std::int64_t const> values, Shape const& shape) {
  implementation_->write(path, values, shape);
}
void Store::write(std::string const& path, std::span<std::uint8_t const> values) {
  implementation_->write(path, values, {});
}
void Store::write(std::string const& path, std::string const& text) {
  auto const type = text_type(text.size());
  Hdf5Handle const space(H5Screate(H5S_SCALAR), H5Sclose);
  auto const dataset = implementation_->create_dataset(path, type.get(), space);
  implementation_->check(H5Dwrite(dataset.get(), type.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, text.c_str()),
                         "write dataset '" + path + "' to");
}

void Store::append(std::string const& path, std::span<double const> values, Shape const& row_shape) {
  implementation_->append(path, values, row_shape);
}
void Store::append(std::string const& path, std::span<std::int64_t const> values, Shape const& row_shape) {
  implementation_->append(path, values, row_shape);
}

void Store::set_attribute(std::string const& object, std::string const& name, double value) {
  implementation_->set_attribute(object, name, H5T_NATIVE_DOUBLE, {H5Screate(H5S_SCALAR), H5Sclose}, &value);
}
void Store::set_attribute(std::string const& object, std::string const& name, std::int64_t value) {
  implementation_->set_attribute(object, name, H5T_NATIVE_INT64, {H5Screate(H5S_SCALAR), H5Sclose}, &value);
}
void Store::set_attribute(std::string const& object, std::string const& name,
                          std::span<std::int64_t const> values) {
  implementation_->set_attribute(object, name, H5T_NATIVE_INT64, simple_space({values.size()}),
                                 values.data());
}
void Store::set_attribute(std::string const& object, std::string const& name, std::string const& text) {
  char const* const data = text.c_str();
  implementation_->set_attribute(object, name, attribute_text_type().get(), {H5Screate(H5S_SCALAR), H5Sclose},
                                 &data);
}
void Store::set_attribute(std::string const& object, std::string const& name,
                          std::span<std::string const> texts) {
  std::vector<char const*> data;
  for (auto const& text : texts)
    data.push_back(text.c_str());
  implementation_->set_attribute(object, name, attribute_text_type().get(), simple_space({texts.size()}),
                                 data.data());
}

void Store::set_ascii_attribute(std::string const& object, std::string const& name, std::string const& text) {
  auto const type = text_type(text.size());
  H5Tset_cset(type.get(), H5T_CSET_ASCII);
  implementation_->set_attribute(object, name, type.get(), {H5Screate(H5S_SCALAR), H5Sclose}, text.data());
}

void Store::link(std::string const& existing, std::string const& path) {
  auto const& self = *implementation_;
  auto const links = creating_groups();
  self.check(H5Lcreate_hard(self.handle.get(), existing.c_str(), self.handle.get(), path.c_str(), links.get(),
                            H5P_DEFAULT),
             "link '" + path + "' in");
}

void Store::flush() {
  implementation_->check(H5Fflush(implementation_->handle.get(), H5F_SCOPE_GLOBAL), "write");
  implementation_->check_writes("write");
}

void Store::mark() {
  flush();
  auto& self = *implementation_;
  if (self.safety != Safety::marked)
    throw std::logic_error(fmt::format("'{}' was not opened to be marked", self.file.string()));
  try {
    if (self.guard.journal)
      self.guard.journal->renew();
    else
      self.guard.journal.emplace(self.file);
  } catch (std::exception const& error) {
    self.guard.failure = error.what(); // which journal is in force is not known: nothing may change any more
    throw;
  }
}

void Store::mend(std::filesystem::path const& file) {
  mend(file, FileLock::usual_patience(FileLock::Kind::exclusive));
}

void Store::mend(std::filesystem::path const& file, double patience) {
  FileLock const lock(file, FileLock::Kind::exclusive, patience);
  UndoJournal::wait_for_writer(file);
  if (!UndoJournal::exists(file))
    return;
  UndoJournal::roll_back(file);
  seal(file); // it is as if its writer had closed it
  UndoJournal::discard(file);
}

/// For a file that is to go on: from its last mark, or from its end, when it was closed.
void Store::Implementation::begin_journal() {
  {
    FileLock const held_for_a_moment(file, FileLock::Kind::exclusive);
    UndoJournal::wait_for_writer(file);
    UndoJournal::roll_back(file);
  }
  if (UndoJournal::exists(file)) {
    guard.journal.emplace(file);
    return;
  }
  auto const length = sealed_length(file);
  if (!length)
    throw InputError(
        fmt::format("cannot go on with '{}': it is damaged, or its writer ended before its first "
                    "mark, or was another version of this program",
                    file.string()));
  guard.journal.emplace(file, *length);
  cut(Descriptor(file, O_WRONLY), *length, file); // the seal
}

void Store::close() {
  flush();
  auto& self = *implementation_;
  self.check(self.handle.close(), "close");
  self.check_writes("close");
  if (self.safety == Safety::marked) {
    seal(self.file);
    UndoJournal::discard(self.file);
  }
  self.guard.journal.reset(); // who waits for the file waits until here
}

std::size_t Store::chunk_rows(std::size_t row_bytes) {
  return std::clamp<std::size_t>(65536 / row_bytes, 1, 1024);
}

std::filesystem::path const& Store::file() const {
  return implementation_->file;
}

std::string store_library_version() {
  prepare_hdf5();
  unsigned major = 0, minor = 0, release = 0;
  H5get_libversion(&major, &minor, &release);
  return fmt::format("{}.{}.{}", major, minor, release);
}

} // namespace mesobridge::workflows
