#include "workflows/store/journaled_driver.hpp"
#include <exception>
#include <memory>

// A virtual file driver of HDF5 (its documentation, "HDF5 Virtual File Layer"): everything is done by the
// ordinary driver, sec2, after the journal has been told, and nothing after a write that failed.

namespace mesobridge::workflows {
namespace {

struct Access {
  WriteGuard* guard;
};

/// The open file; HDF5 sees its first member.
struct File {
  H5FD_t head{};
  H5FD_t* inner = nullptr;
  WriteGuard* guard = nullptr;
};

H5FD_t* inner(H5FD_t const* file) {
  return reinterpret_cast<File const*>(file)->inner;
}

/// Tells the journal, if there is one, then changes the file. A failure, and each one after the first,
/// becomes one of HDF5, whose message names the cause of the first.
template <class Tell, class Change>
herr_t guarded(H5FD_t* file, Tell const& tell, Change const& change) {
  auto& guard = *reinterpret_cast<File*>(file)->guard;
  if (guard.failure.empty()) {
    try {
      if (guard.journal)
        tell(*guard.journal);
      if (change() >= 0)
        return 0;
      guard.failure = hdf5_cause();
    } catch (std::exception const& error) {
      guard.failure = error.what();
    }
  }
  H5Epush2(H5E_DEFAULT, __FILE__, __func__, __LINE__, H5E_ERR_CLS, H5E_VFL, H5E_WRITEERROR,
           "error message = '%s'", guard.failure.c_str());
  return -1;
}

H5FD_t* open(char const* name, unsigned flags, hid_t access, haddr_t max_address) {
  auto const* info = static_cast<Access const*>(H5Pget_driver_info(access));
  Hdf5Handle const plain(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  if (!info || H5Pset_fapl_sec2(plain.get()) < 0)
    return nullptr;
  auto file = std::make_unique<File>();
  file->guard = info->guard;
  file->inner = H5FDopen(name, flags, plain.get(), max_address);
  return file->inner ? &file.release()->head : nullptr;
}

herr_t close(H5FD_t* file) {
  std::unique_ptr<File> const owned(reinterpret_cast<File*>(file));
  return H5FDclose(owned->inner);
}

/// What sec2 can do.
herr_t query(H5FD_t const*, unsigned long* flags) {
  *flags = H5FD_FEAT_AGGREGATE_METADATA | H5FD_FEAT_ACCUMULATE_METADATA | H5FD_FEAT_DATA_SIEVE |
           H5FD_FEAT_AGGREGATE_SMALLDATA;
  return 0;
}

herr_t write(H5FD_t* file, H5FD_mem_t type, hid_t transfer, haddr_t address, std::size_t size,
             void const* data) {
  return guarded(
      file, [&](UndoJournal& journal) { journal.protect(address, size); },
      [&] { return H5FDwrite(inner(file), type, transfer, address, size, data); });
}

herr_t truncate(H5FD_t* file, hid_t transfer, hbool_t closing) {
  auto const end = H5FDget_eoa(inner(file), H5FD_MEM_DEFAULT);
  return guarded(
      file, [&](UndoJournal& journal) { journal.protect_beyond(end); },
      [&] { return H5FDtruncate(inner(file), transfer, closing); });
}

H5FD_class_t driver_class() {
  constexpr haddr_t largest_file = (haddr_t{1} << 63) - 1;
  return {.name = "mesobridge_guarded",
          .maxaddr = largest_file,
          .fc_degree = H5F_CLOSE_WEAK,
          .fapl_size = sizeof(Access),
          .open = open,
          .close = close,
          .cmp = [](H5FD_t const* a, H5FD_t const* b) { return H5FDcmp(inner(a), inner(b)); },
          .query = query,
          .get_eoa = [](H5FD_t const* file, H5FD_mem_t type) { return H5FDget_eoa(inner(file), type); },
          .set_eoa = [](H5FD_t* file, H5FD_mem_t type,
                        haddr_t address) { return H5FDset_eoa(inner(file), type, address); },
          .get_eof = [](H5FD_t const* file, H5FD_mem_t type) { return H5FDget_eof(inner(file), type); },
          .read = [](H5FD_t* file, H5FD_mem_t type, hid_t transfer, haddr_t address, std::size_t size,
                     void* data) { return H5FDread(inner(file), type, transfer, address, size, data); },
          .write = write,
          .flush = [](H5FD_t* file, hid_t transfer,
                      hbool_t closing) { return H5FDflush(inner(file), transfer, closing); },
          .truncate = truncate,
          .lock = [](H5FD_t* file, hbool_t exclusive) { return H5FDlock(inner(file), exclusive); },
          .unlock = [](H5FD_t* file) { return H5FDunlock(inner(file)); },
          .fl_map = H5FD_FLMAP_DICHOTOMY};
}

} // namespace

Hdf5Handle guarded_access(WriteGuard& guard) {
  static hid_t const driver = [] {
    auto const description = driver_class();
    return H5FDregister(&description);
  }();
  Hdf5Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  Access const info{&guard};
  if (H5Pset_driver(access.get(), driver, &info) < 0)
    access.close();
  return access;
}

} // namespace mesobridge::workflows
