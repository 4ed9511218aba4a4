#pragma once
#include "cg/blob_series.hpp"
#include "cg/entropy.hpp"
#include <optional>
#include <string>

namespace mesobridge::cg {

/// Isolated molecules, each at a temperature (or an energy) that is set for it.
struct LevelSeries {
  BlobSeries blobs;
  std::vector<double> set; ///< of each molecule
};

/// S(U), T(U) and C of a molecule by every route that the samples allow.
struct EntropyRoutes {
  struct Curve {
    std::string name; ///< "melt", "melt_kinetic", "vacuum", "vacuum_kinetic"
    EntropyFit fit;
    Estimate C;        ///< at U_mean
    double C_bias = 0; ///< C with a curve of one order more, minus C
  };
  double U_mean = 0;     ///< of the melt (or of the vacuum samples)
  std::vector<double> U; ///< where the curves are told
  std::vector<Curve> curves;
  std::optional<Estimate> C_from_variance; ///< beta^2 Var(U) of the melt: the same C if the KA holds
  std::optional<Equipartition> equipartition;
  std::string equipartition_from; ///< which samples
  std::optional<WhamEntropy> wham;
  std::optional<KineticTemperature> kinetic_bins;

  Curve const* curve(std::string const& name) const;
};

/// At least a melt or a vacuum, canonical samples of isolated molecules, is needed; runs of isolated
/// molecules at constant energy are the thesis's way to equipartition.
struct EntropyInputs {
  std::optional<BlobSeries> melt;
  std::optional<LevelSeries> vacuum, microcanonical;
  std::size_t order = 3; ///< terms of the curves
};

/// Throws InputError for fewer than four molecules at a level, TooShort for a melt whose run has too few
/// memory times, PhysicsError as fit_entropy.
EntropyRoutes entropy_routes(EntropyInputs const& inputs);

} // namespace mesobridge::cg
