#pragma once
#include "md/error.hpp"

namespace mesobridge::tests {

/// What the Error says that `act` ends with; "no error" when it goes through.
template <class Error = InputError>
std::string error_text(auto const& act) {
  try {
    act();
  } catch (Error const& error) {
    return error.what();
  }
  return "no error";
}

} // namespace mesobridge::tests
