#include "cg/hugoniot.hpp"
#include "md/error.hpp"
#include <algorithm>
#include <array>
#include <cmath>
#include <gsl/gsl_fit.h>

namespace mesobridge::cg {
namespace {

Line weighted_line(std::span<double const> x, std::span<double const> weights, std::span<double const> y) {
  Line line;
  gsl_fit_wlinear(x.data(), 1, weights.data(), 1, y.data(), 1, x.size(), &line.a, &line.b, &line.var_a,
                  &line.cov_ab, &line.var_b, &line.chi_2);
  return line;
}

/// One Hugoniot problem as a function of what was measured: e0, P0, e1, P1, e2, P2 ... so that errors can be
/// carried through it.
class Problem {
 public:
  enum Result { T, P, e, v_P, v_S, results };
  using Results = std::array<double, results>;

  Problem(MetalPoint const& initial, std::span<MetalPoint const> shocked) : initial_(initial) {
    rho0_ = initial.state.rho, rho_ = shocked.front().state.rho;
    dv_ = 1 / rho0_ - 1 / rho_;
    add(initial);
    for (auto const& point : shocked) {
      add(point);
      T_.push_back(point.state.T);
      weights_.push_back(1 / variance_of_h(point));
    }
  }

  std::vector<double> const& measured() const { return measured_; }

  /// Lines e(T) and P(T) have the same weights, so that h(T) is the line of the same weights through the h of
  /// the states.
  Results solve(std::vector<double> const& measured) const {
    auto const lines = lines_of(measured);
    double const h_a = lines.e.a - measured[0] - (lines.P.a + measured[1]) * dv_ / 2;
    double const h_b = lines.e.b - lines.P.b * dv_ / 2;
    if (!(h_b > 0))
      refuse(fmt::format("the Hugoniot function does not grow with the temperature ({:.3g} J/(kg K))", h_b));
    double const temperature = -h_a / h_b;
    double const pressure = lines.P.a + lines.P.b * temperature, rise = (pressure - measured[1]) * dv_;
    if (!(rise > 0))
      refuse(fmt::format("the pressure {:.3g} Pa is not above the initial {:.3g} Pa", pressure, measured[1]));
    double const velocity = std::sqrt(rise);
    return {temperature, pressure, lines.e.a + lines.e.b * temperature, velocity,
            velocity * rho_ / (rho_ - rho0_)};
  }

  /// Weighted squares of the distances of the states' h from their line.
  double chi_2() const {
    std::vector<double> h;
    for (std::size_t k = 2; k < measured_.size(); k += 2)
      h.push_back(measured_[k] - measured_[k + 1] * dv_ / 2);
    return weighted_line(T_, weights_, h).chi_2;
  }

  /// Covariance of two results, through central differences of one standard error.
  double covariance(Result a, Result b) const {
    double sum = 0;
    for (std::size_t k = 0; k < covariances_.size(); ++k) {
      auto const& c = covariances_[k];
      auto const by_e = derivative(2 * k, std::sqrt(c.ee)), by_P = derivative(2 * k + 1, std::sqrt(c.PP));
      sum += by_e[a] * by_e[b] * c.ee + by_P[a] * by_P[b] * c.PP +
             (by_e[a] * by_P[b] + by_P[a] * by_e[b]) * c.eP;
    }
    return sum;
  }

 private:
  struct Lines {
    Line e, P;
  };
  struct Covariance {
    double ee, eP, PP;
  };

  void add(MetalPoint const& point) {
    measured_.insert(measured_.end(), {point.e.mean, point.P.mean});
    covariances_.push_back({point.e.se * point.e.se, point.cov_eP, point.P.se * point.P.se});
  }

  double variance_of_h(MetalPoint const& point) const {
    double const half = dv_ / 2;
    return point.e.se * point.e.se + half * half * point.P.se * point.P.se - 2 * half * point.cov_eP;
  }

  Lines lines_of(std::vector<double> const& measured) const {
    std::vector<double> e, P;
    for (std::size_t k = 2; k < measured.size(); k += 2) {
      e.push_back(measured[k]);
      P.push_back(measured[k + 1]);
    }
    return {weighted_line(T_, weights_, e), weighted_line(T_, weights_, P)};
  }

  Results derivative(std::size_t k, double step) const {
    auto up = measured_, down = measured_;
    up[k] += step, down[k] -= step;
    auto const above = solve(up), below = solve(down);
    Results slope{};
    for (std::size_t i = 0; i < results; ++i)
      slope[i] = (above[i] - below[i]) / (2 * step);
    return slope;
  }

  [[noreturn]] void refuse(std::string const& why) const {
    throw PhysicsError(fmt::format("no shocked state at {} kg/m^3 from {} kg/m^3, {} K: {}", rho_, rho0_,
                                   initial_.state.T, why));
  }

  MetalPoint const& initial_;
  double rho0_ = 0, rho_ = 0, dv_ = 0;
  std::vector<double> measured_, T_, weights_;
  std::vector<Covariance> covariances_;
};

} // namespace

HugoniotPoint solve_hugoniot(MetalPoint const& initial, std::span<MetalPoint const> shocked) {
  require(shocked.size() >= 2, "states to find a shocked state between", shocked.size(),
          "at least 2 are needed");
  bool several_T = false;
  for (auto const& point : shocked) {
    require(point.state.rho == shocked.front().state.rho, "density of a state [kg/m^3]", point.state.rho,
            "must be that of the others");
    several_T = several_T || point.state.T != shocked.front().state.T;
    require(point.e.se > 0 && point.P.se > 0, "standard error of e [J/kg]", point.e.se,
            "must be > 0, as P's");
  }
  require(several_T, "temperature of all states [K]", shocked.front().state.T, "two at least must differ");
  require(shocked.front().state.rho > initial.state.rho, "shocked density [kg/m^3]",
          shocked.front().state.rho, "must be above the initial one");
  Problem const problem(initial, shocked);
  auto const values = problem.solve(problem.measured());
  auto const estimate = [&](Problem::Result result) {
    return Estimate{values[result], std::sqrt(problem.covariance(result, result)), 0};
  };
  return {.initial = initial.state,
          .rho = shocked.front().state.rho,
          .v_P = estimate(Problem::v_P),
          .v_S = estimate(Problem::v_S),
          .cov_vSvP = problem.covariance(Problem::v_S, Problem::v_P),
          .T = estimate(Problem::T),
          .P = estimate(Problem::P),
          .e = estimate(Problem::e),
          .P0 = initial.P,
          .phase = shocked.front().phase,
          .chi_2 = problem.chi_2(),
          .states = int(shocked.size())};
}

Estimate zero_pressure_density(std::span<MetalPoint const> states) {
  require(states.size() >= 2, "states to find zero pressure between", states.size(), "at least 2 are needed");
  std::vector<double> rho, P, weights;
  double const shift = states.front().state.rho;
  for (auto const& point : states) {
    rho.push_back(point.state.rho - shift);
    P.push_back(point.P.mean);
    weights.push_back(1 / (point.P.se * point.P.se));
  }
  auto const line = weighted_line(rho, weights, P);
  if (!(line.b > 0))
    throw PhysicsError(fmt::format("the pressure does not grow with the density near {} kg/m^3, {} K", shift,
                                   states.front().state.T));
  double const root = -line.a / line.b;
  double const variance = line.var_a + 2 * root * line.cov_ab + root * root * line.var_b;
  return {shift + root, std::sqrt(variance) / line.b, 0};
}

Line fit_us_up(std::span<HugoniotPoint const> points) {
  require(points.size() >= 3, "points of the Hugoniot curve", points.size(), "at least 3 are needed");
  std::vector<double> v_P, v_S, weights(points.size(), 1.0);
  for (auto const& point : points) {
    v_P.push_back(point.v_P.mean);
    v_S.push_back(point.v_S.mean);
  }
  Line line;
  // The slope enters the weights; it is settled after few rounds since the weights hardly depend on it.
  constexpr int rounds = 10;
  for (int round = 0; round < rounds; ++round) {
    line = weighted_line(v_P, weights, v_S);
    for (std::size_t k = 0; k < points.size(); ++k) {
      auto const& p = points[k];
      weights[k] =
          1 / (p.v_S.se * p.v_S.se + line.b * line.b * p.v_P.se * p.v_P.se - 2 * line.b * p.cov_vSvP);
    }
  }
  line = weighted_line(v_P, weights, v_S);
  double const scatter = std::max(1.0, line.chi_2 / double(points.size() - 2));
  line.var_a *= scatter, line.cov_ab *= scatter, line.var_b *= scatter;
  return line;
}

} // namespace mesobridge::cg
