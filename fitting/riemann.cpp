#include "fitting/riemann.hpp"
#include "fitting/isentrope.hpp"
#include "fitting/root.hpp"
#include "fitting/shock_relations.hpp"
#include <algorithm>

namespace mesobridge::fitting {
namespace {

// Below this relative jump of pressure a wave is sound: its velocity differs from the linear law by the
// square.
constexpr double acoustic = 1e-7;

double impedance(EosState const& state) {
  if (!(state.sound_speed_squared > 0))
    throw PhysicsError(
        fmt::format("Riemann problem: density {}, temperature {} has no sound speed", state.rho, state.T));
  return state.rho * *state.sound_speed;
}

bool can_reach(RiemannSide const (&sides)[2], double P) {
  try {
    for (auto const& side : sides)
      if (P < side.state.P)
        Isentrope(side.fluid, side.state).at_pressure(P);
    return true;
  } catch (PhysicsError const&) {
    return false;
  }
}

/// The side seen along its wave's direction of travel, which is +1 or -1.
RiemannSide along(double direction, RiemannSide side) {
  require(std::isfinite(side.u), "Riemann problem: velocity", side.u, "must be finite");
  impedance(side.state);
  side.u *= direction;
  return side;
}

} // namespace

RiemannSolution::Wave RiemannSolution::wave(RiemannSide const& side, double P) {
  auto const& state = side.state;
  double const c = *state.sound_speed, jump = P - state.P;
  if (std::abs(jump) < acoustic * impedance(state) * c)
    return {
        side,    Isentrope(side.fluid, state).at_pressure(P), jump / impedance(state), side.u + c, side.u + c,
        jump > 0};
  if (jump > 0) {
    auto const shock = Hugoniot(side.fluid, state).from_pressure(P);
    double const speed = side.u + shock.v_S;
    return {side, shock.behind, shock.v_P, speed, speed, true};
  }
  Isentrope const isentrope(side.fluid, state);
  auto const inner = isentrope.at_pressure(P);
  double const gain = isentrope.velocity_change(state.rho, inner.rho);
  return {side, inner, gain, side.u + c, side.u + gain + *inner.sound_speed, false};
}

double RiemannSolution::find_pressure() const {
  auto const& [left, right] = sides_;
  // How much the inner states overlap: they meet where their velocities along x, -left and +right, are equal.
  auto const excess = [&](double P) { return wave(left, P).gain + left.u + wave(right, P).gain + right.u; };
  double const low = std::min(left.state.P, right.state.P), high = std::max(left.state.P, right.state.P);
  constexpr double deepest = 1e-14;
  // A gas beside a liquid under tension has no state at the lower pressure, but at all positive ones.
  double const base = can_reach(sides_, low) ? low : deepest * high, f_base = excess(base);
  if (f_base == 0)
    return base;
  constexpr double step_ratio = 2;
  if (f_base > 0) {
    auto const deficit = [&](double P) { return -excess(P); };
    auto const P = base > 0 ? first_rising_zero(deficit, base, deepest * high, step_ratio) : std::nullopt;
    if (!P)
      throw PhysicsError(fmt::format(
          "Riemann problem: the sides part at {}, faster than rarefactions down to zero pressure can follow: "
          "a vacuum opens, or the matter is torn; outer pressures {} and {}",
          left.u + right.u, left.state.P, right.state.P));
    return *P;
  }
  // Upwards by jumps from there, from what sound waves would give and far less.
  constexpr double least_jump = 1e-9, largest_jump = 1e9;
  double const sound_jump =
      high - base + std::abs(left.u + right.u) * std::min(impedance(left.state), impedance(right.state));
  auto const jump = first_rising_zero([&](double dP) { return excess(base + dP); }, least_jump * sound_jump,
                                      largest_jump * sound_jump, step_ratio);
  if (!jump)
    throw PhysicsError(
        fmt::format("Riemann problem: outer pressures {} and {}, sides meeting at {}: no waves "
                    "inside the models join them",
                    left.state.P, right.state.P, -(left.u + right.u)));
  return base + *jump;
}

RiemannSolution::RiemannSolution(RiemannSide left, RiemannSide right)
    : sides_{along(-1, std::move(left)), along(1, std::move(right))}, P_(find_pressure()),
      left_(wave(sides_[0], P_)), right_(wave(sides_[1], P_)),
      u_(0.5 * (right_.outer.u + right_.gain - left_.outer.u - left_.gain)) {
  require_convex(left_);
  require_convex(right_);
}

void RiemannSolution::require_convex(Wave const& wave) const {
  if (wave.shock)
    return;
  // u + c must fall all the way from the head of the fan to its tail, or parts of it would overtake others.
  Isentrope const isentrope(wave.outer.fluid, wave.outer.state);
  constexpr int points = 16;
  double before = wave.head;
  double const ratio = wave.inner.rho / wave.outer.state.rho;
  for (int i = 1; i <= points; ++i) {
    double const rho = wave.outer.state.rho * std::pow(ratio, double(i) / points);
    double const speed = wave.outer.u + isentrope.velocity_change(wave.outer.state.rho, rho) +
                         *isentrope.at_density(rho).sound_speed;
    if (speed > before + acoustic * *wave.outer.state.sound_speed)
      throw PhysicsError(fmt::format("Riemann problem: the rarefaction from density {}, temperature {} would "
                                     "steepen at density {}: the fluid is not convex there",
                                     wave.outer.state.rho, wave.outer.state.T, rho));
    before = speed;
  }
}

FlowState RiemannSolution::in_wave(Wave const& wave, double speed, double inner_u) {
  if (speed >= wave.head)
    return {wave.outer.state, wave.outer.u};
  if (speed <= wave.tail)
    return {wave.inner, inner_u};
  Isentrope const isentrope(wave.outer.fluid, wave.outer.state);
  double const rho_outer = wave.outer.state.rho;
  auto const u_at = [&](double rho) { return wave.outer.u + isentrope.velocity_change(rho_outer, rho); };
  auto const excess = [&](double rho) { return u_at(rho) + *isentrope.at_density(rho).sound_speed - speed; };
  double const rho = bracketed_zero(excess, wave.inner.rho, wave.tail - speed, rho_outer, wave.head - speed);
  return {isentrope.at_density(rho), u_at(rho)};
}

FlowState RiemannSolution::at(double xi) const {
  if (xi >= u_)
    return in_wave(right_, xi, u_);
  auto flow = in_wave(left_, -xi, -u_);
  flow.u = -flow.u;
  return flow;
}

} // namespace mesobridge::fitting
