#pragma once
#include "fitting/kinetics.hpp"
#include "fitting/reactive_fluid.hpp"
#include <vector>

namespace mesobridge::fitting {

/// A state in the zone: the density of the whole and what it is made of.
struct ZoneState {
  double rho;
  MixtureState state;
};

/// The steady flow behind a detonation front that runs at D: at each progress of the reaction, the state on
/// the Rayleigh line that leaves the front subsonically (fitting/README.md, Eq. (F24)).
class ReactionZone {
 public:
  /// Throws PhysicsError where D is below the Chapman-Jouguet velocity, or no shock reaches it.
  ReactionZone(ReactiveFluid fluid, double D);

  double D() const { return D_; }
  /// The shocked, unreacted state, at which the zone begins.
  Shock const& von_neumann() const { return von_neumann_; }
  /// Velocity of the flow in the laboratory, and relative to the front.
  double velocity(double rho) const { return D_ - flow(rho); }
  double flow(double rho) const { return D_ * fluid_.at_rest.rho / rho; }

  /// 0 <= lambda < 1; `guess` is the state at a near progress. Throws PhysicsError where the flow would be
  /// faster than sound: the detonation is then a pathological one, which runs faster than this D.
  ZoneState at(double lambda, std::optional<ZoneState> const& guess = std::nullopt) const;

 private:
  /// The mixture at the density and the energy of the line, and how far its pressure lies above it.
  struct Trial {
    ZoneState at;
    double excess, slope; ///< slope = d excess/d rho = c^2 - w^2
  };
  Trial trial(double lambda, double rho, std::optional<MixtureSplit> const& split) const;
  std::optional<ZoneState> newton(double lambda, ZoneState const& guess) const;
  ZoneState search(double lambda) const;

  ReactiveFluid fluid_;
  double D_;
  Shock von_neumann_;
};

/// One place in the zone: x is the distance behind the front, t the time since it passed.
struct ZonePoint {
  double lambda, x, t;
  double rho, u; ///< density and velocity in the laboratory
  MixtureState state;
};

/// What kinetics make of it, at the given progresses (rising, the first >= 0, the last < 1):
/// dt = dlambda/rate, dx = w dt. Distances and times begin at lambda = 0; relative error below 1e-8.
std::vector<ZonePoint> reaction_profile(ReactionZone const& zone, Kinetics const& kinetics,
                                        std::vector<double> const& progress);

/// Where a zone counts as begun and ended when its length is stated.
inline constexpr double zone_begin = 0.02, zone_end = 0.98;

/// Between them, by the nearest of the points, of which there must be one at least.
struct ZoneExtent {
  double length, duration;
};
ZoneExtent zone_extent(std::vector<ZonePoint> const& points);

/// Progresses that draw the zone up to `last` in (zone_end, 1), with 0, zone_begin and zone_end among them.
std::vector<double> progress_to_draw(double last);

} // namespace mesobridge::fitting
