#pragma once
#include "fitting/eos/list.hpp"

namespace mesobridge::fitting::test {

/// The equation of state of a material that needs no file.
template <class Model>
Model const& built_in(std::string_view name) {
  return std::get<Model>(material(name).eos);
}

inline LjBwr const& lj() {
  return built_in<LjBwr>("lj");
}
inline LjBwr const& argon() {
  return built_in<LjBwr>("argon");
}
inline MieGruneisen const& tin() {
  return built_in<MieGruneisen>("tin");
}
inline Hz const& nitromethane() {
  return built_in<Hz>("nitromethane");
}
inline Jwl const& products() {
  return built_in<Jwl>("nitromethane-products");
}

} // namespace mesobridge::fitting::test
