#pragma once
#include "cg/correlations.hpp"
#include "cg/jackknife.hpp"

namespace mesobridge::cg {

/// What pairs of molecules tell: g(r), u(r), local densities. One pass over the pairs of every frame that is
/// looked at.
class PairStatistics {
 public:
  /// Throws InputError when the range of the density, or nothing, fits into half the box.
  PairStatistics(BlobSeries const& series, CorrelationSettings const& settings);

  /// The Lucy density of each molecule, without itself: number (frame/stride) * molecules + molecule.
  std::vector<double> const& densities() const { return densities_; }

  /// Fills in everything about pairs and densities, with errors over these blocks of frames.
  void results_into(std::vector<std::pair<std::size_t, std::size_t>> const& blocks, Correlations& out) const;

 private:
  void look_at(std::size_t frame);
  std::size_t radial_bins() const;
  /// The bins of g(r) that stand for each result: the innermost ones are joined until they hold enough pairs.
  std::vector<std::size_t> joined_bins() const;
  /// How many of the joined bins lie nearer than where g(r) first reaches its value at contact; at least 1.
  std::size_t bins_in_contact(std::vector<Sums> const& sums, std::vector<std::size_t> const& ends,
                              std::vector<double> const& ideal) const;
  void radial_into(std::vector<Sums> const& sums, Correlations& out) const;

  BlobSeries const& series_;
  CorrelationSettings settings_;
  double r_max_ = 0, volume_ = 0, U_mean_ = 0;
  std::vector<double> W_; ///< configurational energy of each blob
  std::vector<double> densities_;
  /// Of each frame looked at: pairs, sums of U1 U2/<U>^2 and of W1 W2/<U>^2 in every radial bin.
  std::vector<std::vector<double>> frames_;
};

} // namespace mesobridge::cg
