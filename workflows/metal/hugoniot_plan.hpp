#pragma once
#include "cg/hugoniot.hpp"
#include <optional>
#include <span>

namespace mesobridge::workflows {

/// Which Hugoniot curve of a metal is wanted.
struct HugoniotRequest {
  double T0 = 300;                  ///< [K]
  std::optional<double> rho0;       ///< [kg/m^3]; none: the density of zero pressure at T0
  std::vector<double> compressions; ///< rho/rho0 > 1
  std::vector<double> v_P; ///< [m/s]; a compression is estimated for each, whose v_P is then measured
};

/// Estimates for a crystal whose atoms vibrate classically about its static states: e = e_c(rho) + 3 k_B T/m,
/// P = P_c(rho) + G rho 3 k_B T/m with the Grueneisen parameter G = 2. They only say where to sample.
class QuasiharmonicMetal {
 public:
  QuasiharmonicMetal(md::MpiWorld const& world, md::MetalSettings const& settings);

  double zero_pressure_density(double T);
  /// Temperature behind a shock, and velocity of the matter there.
  struct Shocked {
    double T, v_P;
  };
  /// Throws PhysicsError where the estimate has no solution (compressions towards 1 + 2/G).
  Shocked shocked(md::MetalState initial, double rho);
  /// The compression of a shock of this v_P. Throws InputError when it is out of reach.
  double compression(md::MetalState initial, double v_P);

 private:
  double thermal_energy(double T) const;

  md::MetalCrystal crystal_;
  double mass_;
};

/// What is known of the curve so far.
struct HugoniotCurve {
  std::optional<md::MetalState> initial;
  cg::Estimate rho0; ///< se = 0 when it was given
  std::vector<cg::HugoniotPoint> points;
  std::vector<std::string> unsolved;   ///< why a compression has no point
  std::vector<md::MetalState> missing; ///< what to sample next; empty: nothing more
};

/// From the request and the states sampled so far (equal calls give equal answers), what to sample next:
/// states about zero pressure; the initial state and three temperatures about each estimate; two more about
/// the solution as long as it lies outside those that it was found from. States of the start's phase are
/// preferred; a solution is taken from states of one phase only.
HugoniotCurve plan_hugoniot(HugoniotRequest const& request, QuasiharmonicMetal& metal, cg::Phase start,
                            std::span<cg::MetalPoint const> known);

} // namespace mesobridge::workflows
