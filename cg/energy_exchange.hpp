#pragma once
#include "cg/blob_series.hpp"
#include <optional>

namespace mesobridge::cg {

struct ExchangeSettings {
  double longest = 2;      ///< lag up to which energies are followed
  double from = 0.5, to = 1.5; ///< lags between which they pass steadily from molecule to molecule
  double cutoff = 8;       ///< beyond it molecules count as strangers
  double width = 0.5;      ///< of the bins of distance
  std::size_t blocks = 10; ///< of frames, left out in turn for the standard errors; 4 or more
};

/// How internal energies of molecules decay and how they pass to neighbours, in the units of the series with
/// k_B = 1; cg/README.md, Eqs. (C40) ... (C42). What molecules beyond the cut-off have in common, because the
/// energy of all is conserved, is taken off.
struct EnergyExchange {
  std::vector<double> lag;
  Estimate variance;         ///< <dU^2>
  std::vector<Estimate> own; ///< <dU(t) dU(0)> of one molecule over its variance
  std::optional<Estimate> decay; ///< when that has fallen to 1/e; nothing where it does not
  Estimate loss;             ///< -d<dU(t) dU(0)>/dt between the two lags
  struct Bin {
    double r;         ///< mean distance of its pairs
    double neighbours; ///< of a molecule in it
    std::vector<Estimate> together; ///< <dU_i(t) dU_j(0)>, i and j at the distance r at time 0
    Estimate flow;    ///< its slope between the two lags
  };
  std::vector<Bin> bins; ///< those that hold pairs
  Estimate gain; ///< the sum of the flows to all neighbours: loss, but for what goes to motion
};

/// Of a melt's molecules. Throws InputError for fewer than 4 molecules, frames that are not at equal
/// intervals or too few for the lags, settings out of range, energies that are all alike, or a cut-off that leaves no strangers in half the
/// box.
EnergyExchange energy_exchange(BlobSeries const& series, ExchangeSettings const& settings);

} // namespace mesobridge::cg
