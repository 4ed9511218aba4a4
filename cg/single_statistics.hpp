#pragma once
#include "cg/correlations.hpp"
#include "cg/jackknife.hpp"

namespace mesobridge::cg {

/// What molecules tell one by one: moments and distributions of momentum and energies, and the map of how far
/// K and U depend on each other.
class SingleStatistics {
 public:
  SingleStatistics(BlobSeries const& series, CorrelationSettings const& settings);

  /// Fills in everything about single molecules, with errors over these blocks of frames.
  void results_into(std::vector<std::pair<std::size_t, std::size_t>> const& blocks, Correlations& out) const;

 private:
  /// Equal bins of [low, high).
  struct Bins {
    double low = 0, high = 1;
    std::size_t count = 1;

    double width() const { return (high - low) / double(count); }
    double centre(std::size_t bin) const { return low + (double(bin) + 0.5) * width(); }
    /// `count` when the value lies outside.
    std::size_t of(double value) const;
  };

  /// Sums over one block.
  struct Block {
    Sums moments;
    Sums P_x, P_U; ///< the last entry is the number of samples
    Sums map;      ///< counts K x U, the last entry is the number of samples
  };

  Block block(std::pair<std::size_t, std::size_t> frames) const;
  void add(std::size_t k, Block& block) const;
  void moments_into(std::vector<Block> const& blocks, Correlations& out) const;
  RelativeErrorMap map(std::vector<Block> const& blocks) const;
  std::vector<double> relative_errors(Sums const& s) const;
  static std::vector<Sums> column(std::vector<Block> const& blocks, Sums Block::*member);
  static Profile density(std::vector<Sums> const& sums, Bins const& bins);

  BlobSeries const& series_;
  double U_shift_, U_spread_;
  Bins P_bins_, U_bins_, map_K_, map_U_;
};

} // namespace mesobridge::cg
