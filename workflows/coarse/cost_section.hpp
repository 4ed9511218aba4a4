#pragma once
#include "workflows/coarse/kept.hpp"

namespace mesobridge::workflows {

/// What a quantity costs and how far it can be trusted.
struct Accuracy {
  double seconds = 0; ///< processor time
  double se = 0;      ///< of the mean after them, as a share of the molecules' value
  double bias = 0;    ///< as a share of it; 0 for the molecules themselves

  /// Root of bias and chance together after that much processor time [s].
  double error(double after) const;
  /// Processor time for an error; none where the bias alone is larger [s].
  std::optional<double> time_for(double error) const;
};

/// Of the molecules.
Accuracy accuracy_of_molecules(Kept const& kept, KeptQuantity const& of);
/// Of the particles; the bias is what the difference shows beyond chance.
Accuracy accuracy_of_particles(KeptRun const& run, KeptQuantity const& of);

/// What each run costs and keeps, and the processor time that both fluids take for an error.
Section cost_section(Kept const& kept);

} // namespace mesobridge::workflows
