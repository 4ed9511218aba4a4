#include "fitting/shock_profile.hpp"
#include "fitting/root.hpp"
#include <algorithm>
#include <exception>
#include <functional>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>

namespace mesobridge::fitting {
namespace {

/// Derivatives at constant density or temperature from what a state knows.
struct Slopes {
  double P_T, P_rho, e_rho;
  explicit Slopes(EosState const& s)
      : P_T(s.gruneisen * s.rho * s.c_v),
        P_rho(s.sound_speed_squared - s.T * P_T * P_T / (s.rho * s.rho * s.c_v)),
        e_rho((s.P - s.T * P_T) / (s.rho * s.rho)) {}
};

/// The steady equations, with derivatives along the flow.
struct SteadyFlow {
  Fluid fluid;
  double m, momentum, energy; // fluxes
  double mu, kappa;

  SteadyFlow(Fluid fluid, Shock const& shock, Transport const& t)
      : fluid(std::move(fluid)), m(shock.ahead.rho * shock.v_S), momentum(m * shock.v_S + shock.ahead.P),
        energy(m * (shock.ahead.e + 0.5 * shock.v_S * shock.v_S) + shock.ahead.P * shock.v_S),
        mu(4.0 / 3 * t.shear_viscosity + t.bulk_viscosity), kappa(t.conductivity) {}

  bool conducts() const { return kappa > 0; }
  /// m e where no heat flows.
  double adiabatic_energy(double w) const { return energy + 0.5 * m * w * w - momentum * w; }
  EosState state(double w, double T) const {
    return conducts() ? fluid.at_temperature(m / w, T) : fluid.at_energy(m / w, adiabatic_energy(w) / m);
  }
  double dw(EosState const& s, double w) const { return (m * w + s.P - momentum) / mu; }
  double dT(EosState const& s, double w) const { return (m * s.e - adiabatic_energy(w)) / kappa; }

  /// The way in which the flow settles at an end: rate (1/length) of the mode with the lowest or highest
  /// rate, and its direction dT/dw.
  struct Mode {
    double rate, dT_dw;
  };
  Mode mode(EosState const& s, bool lowest) const {
    Slopes const slopes(s);
    double const w = m / s.rho, w_w = (m - slopes.P_rho * m / (w * w)) / mu, w_T = slopes.P_T / mu;
    double const e_w = -slopes.e_rho * m / (w * w); // at constant T
    if (!conducts()) {
      double const T_w = ((m * w - momentum) / m - e_w) / s.c_v;
      return {w_w + w_T * T_w, T_w};
    }
    double const T_w = (m * e_w - m * w + momentum) / kappa, T_T = m * s.c_v / kappa;
    double const half_trace = 0.5 * (w_w + T_T);
    double const root = std::hypot(0.5 * (w_w - T_T), std::sqrt(w_T * T_w));
    double const determinant = w_w * T_T - w_T * T_w;
    // Of the two roots, the one of the larger magnitude first: the other one follows without cancellation.
    double const large = half_trace + (half_trace >= 0 ? root : -root), small = determinant / large;
    double const rate = lowest ? std::min(large, small) : std::max(large, small);
    return {rate, T_w / (rate - T_T)};
  }
};

/// GSL's integrator behind an interface with exceptions.
class Integrator {
 public:
  using Slope = std::function<void(double const* y, double* dy)>;

  Integrator(std::size_t dimension, Slope slope, double first_step)
      : slope_(std::move(slope)), system_{call, nullptr, dimension, this},
        driver_(
            gsl_odeiv2_driver_alloc_y_new(&system_, gsl_odeiv2_step_rk8pd, first_step, absolute, relative),
            gsl_odeiv2_driver_free) {
    constexpr unsigned long most_steps = 100000;
    gsl_odeiv2_driver_set_nmax(driver_.get(), most_steps);
  }
  Integrator(Integrator const&) = delete;
  Integrator& operator=(Integrator const&) = delete;

  void advance(double& x, double x_end, double* y) {
    int const status = gsl_odeiv2_driver_apply(driver_.get(), &x, x_end, y);
    if (error_)
      std::rethrow_exception(error_);
    if (status != GSL_SUCCESS)
      throw PhysicsError(
          fmt::format("the equations of the shock front are too stiff to be integrated ({}); the "
                      "ratio of viscosity to conductivity is too extreme",
                      gsl_strerror(status)));
  }

 private:
  static constexpr double absolute = 1e-13, relative = 1e-11; // of variables of order 1

  static int call(double, double const* y, double* dy, void* self) {
    auto& integrator = *static_cast<Integrator*>(self);
    try {
      integrator.slope_(y, dy);
      return GSL_SUCCESS;
    } catch (...) {
      integrator.error_ = std::current_exception();
      return GSL_EBADFUNC;
    }
  }

  Slope slope_;
  std::exception_ptr error_;
  gsl_odeiv2_system system_;
  std::unique_ptr<gsl_odeiv2_driver, decltype(&gsl_odeiv2_driver_free)> driver_;
};

/// Where v crosses the given value, on the cubic through the values and slopes at two neighbours.
double crossing(ProfilePoint const& a, ProfilePoint const& b, double v) {
  double const h = b.x - a.x;
  auto const cubic = [&](double t) {
    double const u = 1 - t;
    return u * u * (1 + 2 * t) * a.v + t * t * (3 - 2 * t) * b.v + h * t * u * (u * a.dv_dx - t * b.dv_dx) -
           v;
  };
  return a.x + h * bracketed_zero(cubic, 0, a.v - v, 1, b.v - v);
}

void centre(ShockProfile& profile) {
  auto& points = profile.points;
  double const half = 0.5 * profile.shock.v_P;
  auto const after = std::ranges::find_if(points, [&](auto const& p) { return p.v < half; });
  if (after == points.begin() || after == points.end())
    throw std::logic_error("a shock front without a middle");
  double const x_0 = crossing(*(after - 1), *after, half);
  double steepest = 0;
  for (auto& point : points) {
    point.x -= x_0;
    steepest = std::max(steepest, std::abs(point.dv_dx));
  }
  profile.thickness = profile.shock.v_P / steepest;
}

void validate(Transport const& t, double end) {
  auto const allowed = [](double value) { return value >= 0 && std::isfinite(value); };
  require(allowed(t.shear_viscosity), "shear viscosity", t.shear_viscosity, "must be >= 0 and finite");
  require(allowed(t.bulk_viscosity), "bulk viscosity", t.bulk_viscosity, "must be >= 0 and finite");
  require(allowed(t.conductivity), "conductivity", t.conductivity, "must be >= 0 and finite");
  require(t.shear_viscosity + t.bulk_viscosity > 0, "viscosities", 0, "one of them must be > 0");
  require(end > 0 && end < 0.1, "end of the profile", end, "must lie between 0 and 0.1");
}

} // namespace

ShockProfile shock_profile(Fluid const& fluid, Shock const& shock, Transport const& transport, double end) {
  validate(transport, end);
  SteadyFlow const flow(fluid, shock, transport);
  auto const& [ahead, behind, v_S, v_P] = shock;
  double const w_behind = v_S - v_P, dT = behind.T - ahead.T;
  auto const leaving = flow.mode(behind, true), arriving = flow.mode(ahead, false);
  if (!(leaving.rate < 0 && arriving.rate > 0))
    throw PhysicsError(
        fmt::format("a shock of v_S = {}, v_P = {} has no steady front: the states at its ends are "
                    "not joined",
                    v_S, v_P));
  constexpr double points_a_length = 20;
  double const spacing = 1 / (points_a_length * std::max(-leaving.rate, arriving.rate));

  // Against the flow, in the direction of travel; velocities in v_P, temperatures in their jump.
  auto const slope = [&](double const* y, double* dy) {
    double const w = w_behind + v_P * y[0];
    auto const state = flow.state(w, flow.conducts() ? behind.T + dT * y[1] : behind.T);
    dy[0] = -flow.dw(state, w) / v_P;
    if (flow.conducts())
      dy[1] = -flow.dT(state, w) / dT;
  };
  Integrator integrator(flow.conducts() ? 2 : 1, slope, spacing);

  ShockProfile profile{.shock = shock, .transport = transport, .points = {}, .thickness = 0};
  double x = 0, y[2] = {end, leaving.dT_dw * end * v_P / dT};
  auto const record = [&] {
    double const w = w_behind + v_P * y[0];
    auto const state = flow.state(w, behind.T + dT * y[1]);
    double const dw = flow.dw(state, w);
    // Without conduction T follows from w along the adiabatic energy, by e_w = (w - momentum/m).
    Slopes const slopes(state);
    double const dT_dx =
        flow.conducts() ? -flow.dT(state, w)
                        : -dw * ((w - flow.momentum / flow.m) + slopes.e_rho * flow.m / (w * w)) / state.c_v;
    profile.points.push_back({.x = x, .v = v_P * (1 - y[0]), .dv_dx = dw, .dT_dx = dT_dx, .state = state});
  };
  auto const arrived = [&] {
    auto const& last = profile.points.back();
    return std::abs(last.v) <= end * v_P && std::abs(last.state.T - ahead.T) <= end * std::abs(dT);
  };
  constexpr std::size_t most_points = 200000;
  record();
  while (!arrived()) {
    if (profile.points.size() == most_points)
      throw PhysicsError(
          fmt::format("the shock front did not arrive at the state ahead within {} points; the "
                      "ratio of viscosity to conductivity is too extreme",
                      most_points));
    integrator.advance(x, x + spacing, y);
    record();
  }
  centre(profile);
  return profile;
}

} // namespace mesobridge::fitting
