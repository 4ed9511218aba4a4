#pragma once
#include <fmt/format.h>
#include <type_traits>

// LAMMPS's own headers of classes, included after this one, call a function of fmt that later versions lack.
namespace fmt {
template <class... Args, class Format>
auto make_args_checked(Format const&, std::remove_reference_t<Args>&... args) {
  return fmt::make_format_args(args...);
}
} // namespace fmt
