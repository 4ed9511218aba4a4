#pragma once
#include "cg/blob_series.hpp"
#include <optional>

namespace mesobridge::cg {

struct ExchangeSettings {
  double from = 0;         ///< lags of the parabolas whose slopes at lag 0 are the flows; 0: the first one
  double to = 0;           ///< 0: 0.4 of the time in which a molecule's correlation falls to 1/e
  double longest = 0;      ///< lag up to which energies are followed; 0: twice that time
  double cutoff = 0;       ///< beyond it molecules count as strangers; 0: two thirds of half the box
  double width = 0.5;      ///< of the bins of distance
  std::size_t blocks = 10; ///< of frames, left out in turn for the standard errors; 4 or more
};

/// How internal energies of molecules decay and how they pass to neighbours, in the units of the series with
/// k_B = 1; cg/README.md, Eqs. (C40) ... (C42). What molecules beyond the cut-off have in common, because the
/// energy of all is conserved, is taken off.
struct EnergyExchange {
  std::vector<double> lag;
  Estimate variance;                   ///< <dU^2>
  std::vector<Estimate> own;           ///< <dU(t) dU(0)> of one molecule over its variance
  std::optional<Estimate> decay;       ///< when that has fallen to 1/e; nothing where it does not
  double from = 0, to = 0, cutoff = 0; ///< as the settings, or what was taken for them
  Estimate loss;                       ///< -d<dU(t) dU(0)>/dt at short times
  struct Bin {
    double r;                       ///< mean distance of its pairs
    double neighbours;              ///< of a molecule in it
    std::vector<Estimate> together; ///< <dU_i(t) dU_j(0)>, i and j at the distance r at time 0
    Estimate flow;                  ///< its slope at short times
  };
  std::vector<Bin> bins; ///< those that hold pairs in every block
  Estimate gain;         ///< the sum of the flows to all neighbours: loss, but for what goes to motion
};

/// Conduction over the distance as the bins tell it: smooth, nowhere negative, rising inwards, zero from the
/// cut-off on; cg/README.md, Eq. (C43).
struct ConductionTable {
  std::vector<double> r, kappa;
};

/// By weighted least squares of the bins' values and standard errors at their distances. Throws InputError
/// for fewer than 4 bins, PhysicsError when nothing but noise is there.
ConductionTable conduction_table(std::vector<double> const& r, std::vector<Estimate> const& kappa,
                                 double cutoff);

/// Of a melt's molecules. Throws InputError for fewer than 4 molecules, frames that are not at equal
/// intervals or too few for the lags, settings out of range, energies that are all alike, or a cut-off that
/// leaves no strangers in half the box.
EnergyExchange energy_exchange(BlobSeries const& series, ExchangeSettings const& settings);

} // namespace mesobridge::cg
