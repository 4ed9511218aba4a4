#pragma once
#include "fitting/eos/list.hpp"
#include <gtest/gtest.h>

namespace mesobridge::fitting::test {

/// The equation of state of a material that needs no file.
template <class Model>
Model const& built_in(std::string_view name) {
  return std::get<Model>(material(name).eos);
}

/// Calls f(model) for every built-in material's.
template <class F>
void for_each_model(F const& f) {
  int models = 0;
  for (auto const& material : materials()) {
    SCOPED_TRACE(material.name);
    std::visit(f, material.eos);
    ++models;
  }
  EXPECT_GE(models, 9);
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
