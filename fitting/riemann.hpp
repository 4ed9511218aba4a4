#pragma once
#include "fitting/fluid.hpp"
#include <functional>

namespace mesobridge::fitting {

/// One half space before the membrane breaks.
struct RiemannSide {
  Fluid fluid;
  EosState state;
  double u; ///< velocity along x
};

/// A point of the flow.
struct FlowState {
  EosState state;
  double u;
};

/// The exact solution of the Riemann problem: two half spaces of any fluids, at rest or moving, that are in
/// contact from t = 0 on. A wave runs into either: a shock (Rankine-Hugoniot relations) or a rarefaction
/// (isentrope, u changes by the integral of c drho/rho); between them lie equal pressures and velocities on
/// both sides of the contact (fitting/README.md, Eq. (F16)). See Toro's book, chapter 4,
/// for the ideal gas; nothing here is special to it.
///
/// Throws PhysicsError when the sides move apart so fast that the pressure between them would not stay
/// positive (a vacuum opens, or condensed matter comes under tension and breaks), or when a wave would leave
/// the model or need a fluid that is not convex.
class RiemannSolution {
 public:
  RiemannSolution(RiemannSide left, RiemannSide right);

  double P() const { return P_; } ///< between the waves
  double u() const { return u_; }
  EosState const& left_of_contact() const { return left_.inner; }
  EosState const& right_of_contact() const { return right_.inner; }
  /// Of the wave's two edges, the one that runs ahead and the one at the contact's side; equal for a shock.
  struct Speeds {
    double head, tail;
  };
  Speeds left_wave() const { return {-left_.head, -left_.tail}; }
  Speeds right_wave() const { return {right_.head, right_.tail}; }
  bool left_shock() const { return left_.shock; }
  bool right_shock() const { return right_.shock; }

  /// The flow at x/t = xi.
  FlowState at(double xi) const;

 private:
  /// A wave seen along its own direction of travel: velocities count positive away from the contact.
  struct Wave {
    RiemannSide outer; // u along the direction of travel
    EosState inner;
    double gain; // of velocity from the outer to the inner state
    double head, tail;
    bool shock;
  };
  static Wave wave(RiemannSide const& side, double P);
  static FlowState in_wave(Wave const& wave, double speed, double inner_u);
  double find_pressure() const;
  void require_convex(Wave const& wave) const;

  RiemannSide sides_[2]; // u along the direction of travel
  double P_;
  Wave left_, right_;
  double u_;
};

} // namespace mesobridge::fitting
