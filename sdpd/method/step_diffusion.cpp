#include "sdpd/method/step_diffusion.hpp"
#include "fitting/root.hpp"
#include "sdpd/method/mean_field_viscosity.hpp"
#include <cmath>
#include <gsl/gsl_cdf.h>
#include <gsl/gsl_fit.h>
#include <limits>
#include <vector>

namespace mesobridge::sdpd {
namespace {

constexpr std::size_t least_steps = 3; ///< of a line that can be judged

/// The line through the first `count` points, D = D_0 + slope * excess.
struct Line {
  double D_0, slope, D_0_variance, covariance, slope_variance, chi2;

  Line(std::vector<double> const& x, std::vector<double> const& y, std::vector<double> const& weight,
       std::size_t count) {
    gsl_fit_wlinear(x.data(), 1, weight.data(), 1, y.data(), 1, count, &D_0, &slope, &D_0_variance,
                    &covariance, &slope_variance, &chi2);
  }
  bool holds(std::size_t count) const {
    constexpr double least_probability = 0.01;
    return D_0 > 2 * std::sqrt(D_0_variance) &&
           gsl_cdf_chisq_Q(chi2, static_cast<double>(count) - 2) > least_probability;
  }
  DiffusionAgainstStep result(std::size_t count) const {
    double const share = slope / D_0, n = static_cast<double>(count);
    double const variance =
        slope_variance - 2 * share * covariance + share * share * D_0_variance; // times D_0^2
    return {.D_0 = {D_0, std::sqrt(D_0_variance), n}, .share = {share, std::sqrt(variance) / D_0, n}};
  }
};

} // namespace

double velocity_decay_rate(SimulationSettings const& settings) {
  double const kinetic = mean_field_viscosity(settings).kinetic / settings.units().viscosity();
  return std::pow(settings.spacing(), -3) / (2 * settings.K() * kinetic);
}

double diffusion_excess(double rate, double step) {
  double const x = 0.5 * rate * step;
  return x < 1e-4 ? x * x / 3 : x / std::tanh(x) - 1;
}

double step_of_diffusion_excess(double rate, double share) {
  if (!(rate > 0))
    return std::numeric_limits<double>::infinity();
  double const farthest = 2 * (1 + share) / rate; // x coth x > x
  return fitting::bracketed_zero([&](double step) { return diffusion_excess(rate, step) - share; }, 0,
                                 farthest);
}

double DiffusionAgainstStep::at_most() const {
  if (!known())
    return 1;
  double const most = std::abs(share.mean) + share.se;
  return most > 1 && std::abs(share.mean) - 2 * share.se <= 1 ? 1 : most;
}

DiffusionAgainstStep diffusion_against_step(std::span<double const> excess, std::span<cg::Estimate const> D) {
  std::vector<double> x, y, weight;
  for (std::size_t k = 0; k < D.size(); ++k)
    if (D[k].se > 0) {
      x.push_back(excess[k]), y.push_back(D[k].mean), weight.push_back(1 / (D[k].se * D[k].se));
    }
  for (std::size_t count = x.size(); count >= least_steps; --count) {
    Line const line(x, y, weight, count);
    if (line.holds(count))
      return line.result(count);
  }
  return {};
}

} // namespace mesobridge::sdpd
