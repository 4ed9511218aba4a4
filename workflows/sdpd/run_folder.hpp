#pragma once
#include <filesystem>
#include <string>

namespace mesobridge::workflows {

/// The folder of one run: what its files are called, and what is there.
class RunFolder {
 public:
  explicit RunFolder(std::filesystem::path path) : path_(std::move(path)) {}

  std::filesystem::path const& path() const { return path_; }
  std::filesystem::path scene() const { return path_ / "scene.toml"; } ///< resolved
  std::filesystem::path run_file() const { return path_ / "run.h5"; }
  std::filesystem::path checkpoint() const { return path_ / "checkpoint.h5"; }
  std::filesystem::path calibration() const { return path_ / "calibration.json"; }
  std::filesystem::path summary() const { return path_ / "summary.json"; }

  std::filesystem::path log() const { return path_ / "log.txt"; } ///< for people

  bool has_checkpoint() const { return std::filesystem::exists(checkpoint()); }

  /// Whether this very scene (resolved) began here and did not come to its first checkpoint.
  bool stopped_before_first_checkpoint(std::string const& resolved_scene) const;

 private:
  std::filesystem::path path_;
};

} // namespace mesobridge::workflows
