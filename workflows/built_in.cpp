#include "workflows/built_in.hpp"

namespace mesobridge::workflows {
namespace {

constexpr BuiltIn tables[] = {
#include "generated/built_in_tables.inc"
};

constexpr BuiltIn scenes[] = {
#include "generated/built_in_scenes.inc"
};

constexpr BuiltIn model_files[] = {
#include "generated/built_in_models.inc"
};

} // namespace

std::span<BuiltIn const> built_in_tables() {
  return tables;
}

std::span<BuiltIn const> built_in_scenes() {
  return scenes;
}

std::span<BuiltIn const> built_in_model_files() {
  return model_files;
}

} // namespace mesobridge::workflows
