#pragma once
#include "cg/blob_series.hpp"
#include <optional>

namespace mesobridge::cg {

struct DiffusionSettings {
  double longest = 0;      ///< lag up to which displacements are followed; 0: a tenth of the run
  std::size_t groups = 16; ///< of molecules, whose spread is the error; 4 or more
  double viscosity = 0;    ///< of the fluid, for the correction of finite size; 0: none is made
  double viscosity_se = 0; ///< its standard error, which adds to that of the corrected D
  double temperature = 0;  ///< k_B T of that correction; 0: that of the motion itself
};

/// How molecules move: their displacements and velocities, without the motion of all together. In the units
/// of the series; cg/README.md, Eqs. (C17) ... (C19); the error of D is the larger one of (C52).
struct Diffusion {
  std::vector<double> lag;
  std::vector<Estimate> displacement; ///< mean square, of three dimensions
  std::vector<Estimate> velocity;     ///< autocorrelation of the velocity over its value at lag 0
  Estimate D;                    ///< from the slope of the displacements over the second half of the lags
  Estimate D_earlier;            ///< over the second quarter: the same once diffusion has come
  Estimate temperature;          ///< k_B T of the motion of the centres of mass
  std::optional<Estimate> decay; ///< when the velocity's correlation has fallen to 1/e
  std::optional<Estimate>
      D_velocity; ///< integral of that correlation; nothing where frames are too far apart
  std::optional<Estimate> D_infinite; ///< D without the images of a periodic box
};

/// Of the molecules of a series at equal intervals, all of one mass. Throws InputError for fewer than 16
/// frames or 4 molecules, velocities that are all zero, unequal intervals, settings out of range, or a step
/// between two frames of 0.4 edges of the box or more, beyond which ways are not known.
Diffusion diffusion(BlobSeries const& series, DiffusionSettings const& settings = {});

} // namespace mesobridge::cg
