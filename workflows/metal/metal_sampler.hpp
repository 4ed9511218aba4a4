#pragma once
#include "cg/metal_point.hpp"
#include "workflows/command.hpp"
#include "workflows/metal/metal_file.hpp"

namespace mesobridge::workflows {

/// Runs of a metal to be made, and where.
struct MetalJob {
  md::MetalSettings settings; ///< with its log file
  std::filesystem::path runs; ///< the file of raw series
  bool resume = false;        ///< keep the complete states of that file
};

/// Samples states of a metal into one file, with progress, on the ranks that run already. Rank 0 says which
/// states; the others serve. States that the file holds already are not run again.
class MetalSampler {
 public:
  /// For rank 0. Throws InputError when a file to be resumed was made with other settings.
  MetalSampler(md::MpiWorld const& world, MetalJob job, Context const& context);

  /// Throws Interrupted when the user stopped it (what was sampled is in the file), and as
  /// md::sample_metal_grid.
  void sample(std::span<md::MetalState const> states, std::string const& what);

  /// What the states that were asked for so far tell.
  std::vector<cg::MetalPoint> const& points() const { return points_; }

  /// Ends the service of the other ranks and closes the file.
  void close();

  /// For ranks > 0: samples with rank 0 until it closes or the user stops it.
  static void serve(md::MpiWorld const& world, MetalJob const& job);

 private:
  void run(std::span<md::MetalState const> states, std::string const& what);

  md::MpiWorld const& world_;
  MetalJob job_;
  Context const& context_;
  std::vector<MetalSeries> series_; ///< complete ones, of this and an earlier run
  std::optional<MetalFile> file_;
  std::vector<cg::MetalPoint> points_;
};

/// The points of all complete states of a file, and of how many states it holds only a part.
struct MetalPoints {
  std::vector<cg::MetalPoint> points;
  int incomplete = 0;
};
MetalPoints read_metal_points(std::filesystem::path const& runs, md::MetalSettings const& settings);

} // namespace mesobridge::workflows
