#pragma once
#include "cg/blob_series.hpp"
#include "cg/estimate.hpp"
#include "cg/viscous_decay.hpp"
#include <string>

namespace mesobridge::cg {

struct ViscositySettings {
  double reach = 2;       ///< longest wave vectors, in the shortest ones of the box; 1 ... 6
  std::size_t blocks = 0; ///< of the run, whose spread is the error; 8 or more, or 0: 8 ... 16, of which each
                          ///< is twice as long as the fitted lags of the slowest wave
};

/// Throws InputError for settings out of range.
void check(ViscositySettings const& settings);

/// What the waves of one length tell; cg/README.md, Eqs. (C32) ... (C34).
struct WaveViscosity {
  double k = 0;
  std::size_t vectors = 0;           ///< without their opposites
  Estimate eta;                      ///< by the fit of the viscoelastic decay
  Estimate eta_integral;             ///< by the time integral of the correlation itself
  double memory = 0;                 ///< of the shear stress, by the fit
  Estimate temperature;              ///< k_B T of the currents: C(0) over the mass of all molecules
  std::vector<Estimate> correlation; ///< C(t)/C(0) at whole intervals
  std::size_t fitted = 0;            ///< how many of its lags the fit takes: until C has come to 0.2
  ViscousDecay decay;                ///< that fits them
};

/// The shear viscosity of a fluid by its transverse currents, in the units of the series.
struct Viscosity {
  double interval = 0; ///< of the lags
  double density = 0;  ///< mass per volume
  std::vector<WaveViscosity> waves;
  std::vector<std::string> left_out; ///< wave vectors that were not used, and why
  Estimate eta;                      ///< of k -> 0
  Estimate eta_integral;             ///< the same of the integrals
  double slope = 0;                  ///< eta(k) = eta + slope k^2
  double chi2 = 0; ///< of the waves about that line, in standard errors squared; freedom = waves - 2
};

/// Of a fluid at rest in a periodic box, all molecules of one mass. Throws InputError for fewer than 16
/// molecules, unequal intervals, a box that changes, molecules at rest, settings out of range, or
/// a run too short or frames too far apart for the decay of at least two lengths of waves.
Viscosity viscosity(BlobSeries const& series, ViscositySettings const& settings = {});

} // namespace mesobridge::cg
