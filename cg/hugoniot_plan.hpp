#pragma once
#include "cg/hugoniot.hpp"
#include "md/quasiharmonic_metal.hpp"
#include <optional>
#include <span>

namespace mesobridge::cg {

/// Which Hugoniot curve of a metal is wanted.
struct HugoniotRequest {
  double T0 = 300;                  ///< [K]
  std::optional<double> rho0;       ///< [kg/m^3]; none: the density of zero pressure at T0
  std::vector<double> compressions; ///< rho/rho0 > 1
  std::vector<double> v_P; ///< [m/s]; a compression is estimated for each, whose v_P is then measured
};

/// What is known of the curve so far.
struct HugoniotCurve {
  std::optional<md::MetalState> initial;
  Estimate rho0; ///< se = 0 when it was given
  std::vector<HugoniotPoint> points;
  std::vector<std::string> unsolved;   ///< why a compression has no point
  std::vector<md::MetalState> missing; ///< what to sample next; empty: nothing more
};

/// From the request and the states sampled so far (equal calls give equal answers), what to sample next:
/// states about zero pressure; the initial state and three temperatures about each estimate; two more about
/// the solution as long as it lies outside those that it was found from. States of the start's phase are
/// preferred; a solution is taken from states of one phase only.
HugoniotCurve plan_hugoniot(HugoniotRequest const& request, md::QuasiharmonicMetal& metal, Phase start,
                            std::span<MetalPoint const> known);

} // namespace mesobridge::cg
