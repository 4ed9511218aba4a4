#pragma once
#include "cg/blob_series.hpp"
#include "cg/correlations.hpp"
#include "cg/entropy.hpp"
#include "workflows/command.hpp"
#include "workflows/star/blob_file.hpp"

namespace mesobridge::workflows {

/// The columns of a file as the analyses take them.
cg::BlobSeries series_of(BlobData data);

/// The Lucy range of the thesis, h = 10 for 6-3 stars at rho = 0.3, at the same number of neighbours in any
/// melt.
double default_h(BlobFileHead const& head);

/// The frames between those whose pairs are looked at, an eighth of the energies' memory: nearer frames tell
/// little anew.
std::size_t default_pair_stride(cg::BlobSeries const& series);

Json correlations_json(cg::Correlations const& found);
std::string correlations_text(cg::Correlations const& found);

/// S(U), T(U) and C of a molecule by every route that the files allow.
struct EntropyRoutes {
  struct Curve {
    std::string name; ///< "melt", "melt_kinetic", "vacuum", "vacuum_kinetic"
    cg::EntropyFit fit;
    cg::Estimate C;    ///< at U_mean
    double C_bias = 0; ///< C with a curve of one order more, minus C
  };
  double U_mean = 0;     ///< of the melt (or of the vacuum samples)
  std::vector<double> U; ///< where the curves are told
  std::vector<Curve> curves;
  std::optional<cg::Estimate> C_from_variance; ///< beta^2 Var(U) of the melt: the same C if the KA holds
  std::optional<cg::Equipartition> equipartition;
  std::string equipartition_from; ///< which samples
  std::optional<cg::WhamEntropy> wham;
  std::optional<cg::KineticTemperature> kinetic_bins;

  Curve const* curve(std::string const& name) const;
};

struct EntropyInputs {
  std::optional<BlobData> melt, vacuum, microcanonical;
  std::size_t order = 3;
};

/// Throws InputError when a file is not of its kind, PhysicsError as cg::fit_entropy.
EntropyRoutes entropy_routes(EntropyInputs const& inputs);

Json entropy_json(EntropyRoutes const& routes);
std::string entropy_text(EntropyRoutes const& routes);

} // namespace mesobridge::workflows
