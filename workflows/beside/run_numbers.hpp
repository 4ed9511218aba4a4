#pragma once
#include "cg/estimate.hpp"
#include <filesystem>
#include <string>
#include <vector>

namespace mesobridge::workflows {

/// What a folder says of the run in it, for a look at several of them side by side.
struct RunNumbers {
  std::string name;             ///< as the user called the folder
  std::filesystem::path folder; ///< with summary.json, perhaps scene.toml and run.h5
  std::vector<std::pair<std::string, cg::Estimate>> numbers; ///< all that have a standard error, "T_kin_K"
  std::vector<std::pair<std::string, std::string>> keys;     ///< of the scene, "particles.K"; none: no scene

  /// Null where it has none of that name.
  cg::Estimate const* number(std::string const& name) const;
};

/// Of a folder that `run`, or a command that ends with a summary, has written. Numbers in objects of the
/// summary are called "object.number". Throws InputError that names the folder when it has no summary.json,
/// or one that is damaged or holds no number with an error.
RunNumbers read_run_numbers(std::filesystem::path const& folder);

} // namespace mesobridge::workflows
