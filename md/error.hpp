#pragma once
#include <cmath>
#include <fmt/format.h>
#include <stdexcept>
#include <string>
#include <string_view>

namespace mesobridge {

/// The user's input is wrong: a key, a value, a unit, a file's content. Exit code 2.
struct InputError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The physics cannot go on: an unstable step, a state outside the model. Exit code 3.
struct PhysicsError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The machine fails us: a missing library or file, a full disk, an error inside LAMMPS. Exit code 4.
struct EnvironmentError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The user stopped the work; what had been written stays. Exit code 130.
struct Interrupted : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Refuses bad input by name and value: `require(sigma > 0, "LJ sigma", sigma, "must be > 0")`.
/// A condition on a NaN is false, so NaNs are refused too.
template <class Value>
void require(bool condition, std::string_view quantity, Value const& value,
             std::string_view what_is_allowed) {
  if (!condition)
    throw InputError(fmt::format("{} = {}: {}", quantity, value, what_is_allowed));
}

} // namespace mesobridge
