#pragma once
#include <hdf5.h>
#include <string>
#include <utility>

namespace mesobridge::workflows {

/// Owns one HDF5 identifier and closes it with the function that its kind needs.
class Hdf5Handle {
 public:
  using Closer = herr_t (*)(hid_t);

  Hdf5Handle() = default;
  Hdf5Handle(hid_t id, Closer closer) : id_(id), closer_(closer) {}
  Hdf5Handle(Hdf5Handle&& other) noexcept : id_(std::exchange(other.id_, -1)), closer_(other.closer_) {}
  Hdf5Handle& operator=(Hdf5Handle&& other) noexcept {
    std::swap(id_, other.id_);
    std::swap(closer_, other.closer_);
    return *this;
  }
  ~Hdf5Handle() { close(); }

  hid_t get() const { return id_; }
  bool valid() const { return id_ >= 0; }
  herr_t close() { return valid() ? closer_(std::exchange(id_, -1)) : 0; }

 private:
  hid_t id_ = -1;
  Closer closer_ = nullptr;
};

/// The cause of the last failure in HDF5's own words: the operating system's message if there is one,
/// otherwise the innermost message of HDF5's error stack.
std::string hdf5_cause();

/// The operating system's message alone ("No space left on device"); empty when it has nothing to do with it.
std::string hdf5_system_cause();

/// To be called before anything else of HDF5, as often as you like: its error stack is no longer printed on
/// stderr, and it does nothing at the program's exit.
void prepare_hdf5();

} // namespace mesobridge::workflows
