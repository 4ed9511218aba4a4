#include "workflows/store/hdf5_handle.hpp"

namespace mesobridge::workflows {

namespace {

struct Causes {
  std::string system, innermost;
};

herr_t collect(unsigned, H5E_error2_t const* error, void* data) {
  auto& causes = *static_cast<Causes*>(data);
  std::string const description = error->desc ? error->desc : "";
  constexpr std::string_view key = "error message = '";
  if (auto const at = description.find(key); at != description.npos && causes.system.empty()) {
    auto const start = at + key.size();
    causes.system = description.substr(start, description.find('\'', start) - start);
  }
  if (causes.innermost.empty())
    causes.innermost = description;
  return 0;
}

} // namespace

namespace {

Causes causes_of_last_failure() {
  Causes causes;
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, collect, &causes);
  if (causes.system == "Success") // a read beyond the end of the file
    causes.system.clear();
  return causes;
}

} // namespace

std::string hdf5_system_cause() {
  return causes_of_last_failure().system;
}

std::string hdf5_cause() {
  auto const causes = causes_of_last_failure();
  if (!causes.system.empty())
    return causes.system;
  return causes.innermost.empty() ? "unknown cause" : causes.innermost;
}

void prepare_hdf5() {
  // After a write that failed, HDF5's own tidying at exit crashes (seen with 1.10.8 and a full disk). Every
  // handle here is closed by its owner, so nothing is left to tidy.
  H5dont_atexit();
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

} // namespace mesobridge::workflows
