#pragma once
#include <span>
#include <string_view>

namespace mesobridge::workflows {

/// A file that is built into the program, which finds it wherever it is moved to.
struct BuiltIn {
  std::string_view name; ///< of the file, with its ending
  std::string_view content;
};

/// Printed values: workflows/data/*.csv.
std::span<BuiltIn const> built_in_tables();

/// The scenes that come with the program: workflows/scenes/*.toml.
std::span<BuiltIn const> built_in_scenes();

/// The models that these name as files: workflows/scenes/models/*.toml.
std::span<BuiltIn const> built_in_model_files();

} // namespace mesobridge::workflows
