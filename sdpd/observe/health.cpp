#include "sdpd/observe/health.hpp"
#include "md/error.hpp"
#include "sdpd/observe/pairing.hpp"
#include <algorithm>
#include <cmath>
#include <gsl/gsl_fit.h>
#include <numeric>

namespace mesobridge::sdpd {
namespace {

constexpr double enough_errors = 5; ///< standard errors that chance does not reach
constexpr double much = 0.03;       ///< of the set temperature or the pressure
constexpr double too_much = 0.1;    ///< of them: another state than the scene's
constexpr double much_density = 0.01;

/// One run while its findings are gathered.
class Examination {
 public:
  Examination(EquilibriumSampler const& samples, Equilibrium const& means, HealthConditions const& conditions)
      : samples_(samples), means_(means), conditions_(conditions) {}

  std::vector<Finding> findings() && {
    bool const has_T_int = means_.T_int.mean != 0;
    if (conditions_.has_motion && has_T_int)
      compare_temperatures();
    if (conditions_.has_motion)
      compare_with_set("T_kin", means_.T_kin);
    if (has_T_int)
      compare_with_set("T_int", means_.T_int);
    if (conditions_.has_motion)
      look_for_trend("T_kin", samples_.T_kin(), 1, much);
    if (has_T_int)
      look_for_trend("T_int", samples_.T_int(), 1, much);
    look_for_trend("P", samples_.P(), std::max(std::abs(means_.P.mean), conditions_.thermal_pressure), much);
    if (means_.rho.mean.mean != 0)
      look_for_trend("rho", samples_.at_instants(&InstantMoments::rho_mean), means_.rho.mean.mean,
                     much_density);
    if (conditions_.keeps_energy)
      look_at_energy();
    look_for_pairs();
    look_for_crystal();
    return std::move(findings_);
  }

 private:
  void add(std::string name, bool spoils, std::string text) {
    findings_.push_back({std::move(name), spoils && conditions_.was_equilibrated, std::move(text)});
  }

  static bool is_beyond(double difference, double se, double limit) {
    return std::abs(difference) > enough_errors * se && std::abs(difference) > limit;
  }

  void compare_temperatures() {
    std::vector<double> differences;
    for (std::size_t k = 0; k < samples_.T_kin().size(); ++k)
      differences.push_back(samples_.T_kin()[k] - samples_.T_int()[k]);
    double const difference = means_.T_kin.mean - means_.T_int.mean, se = cg::estimate_mean(differences).se;
    if (is_beyond(difference, se, much))
      add("equipartition", std::abs(difference) > too_much,
          fmt::format(
              "the temperatures of motion and of internal energy are apart: T_kin is {:.3g} % {} T_int "
              "(standard error {:.2g} %); take a shorter time step, or let the fluid settle for longer",
              100 * std::abs(difference) / means_.T_int.mean, difference > 0 ? "above" : "below",
              100 * se / means_.T_int.mean));
  }

  void compare_with_set(std::string const& name, cg::Estimate const& T) {
    double const se = error_without_gain(T, conditions_.gained_temperature);
    if (!is_beyond(T.mean - 1, se, much))
      return;
    auto text = fmt::format("{} is {:.3g} % {} the set temperature (standard error {:.2g} %", name,
                            100 * std::abs(T.mean - 1), T.mean > 1 ? "above" : "below", 100 * T.se);
    constexpr double noticed = 0.9;
    if (se < noticed * T.se)
      text += fmt::format(", {:.2g} % without the energy that the time step has added", 100 * se);
    add("temperature_of_" + name, std::abs(T.mean - 1) > too_much, text + ")");
  }

  void look_for_trend(std::string const& name, std::span<double const> series, double scale, double limit) {
    auto const [change, se] = trend(series);
    if (is_beyond(change, se, limit * scale))
      add("trend_of_" + name, false,
          fmt::format(
              "{} still {} while it was averaged, by {:.3g} % over the run (standard error {:.2g} %): its "
              "standard error does not tell how far its mean is from equilibrium",
              name, change > 0 ? "rose" : "fell", 100 * std::abs(change) / scale, 100 * se / scale));
  }

  /// The energy that a run gains or loses, as what it does to the temperature.
  void look_at_energy() {
    double const duration = samples_.times().back() - samples_.times().front();
    double const of_rate = duration * samples_.energies()[0] / conditions_.thermal_energy; // as a temperature
    double const heating = means_.drift.rate * of_rate, se = means_.drift.se * std::abs(of_rate);
    if (is_beyond(heating, se, much))
      add("energy_drift", std::abs(heating) > too_much,
          fmt::format("the total energy {} over the run by what {} the fluid by {:.3g} % of its temperature; "
                      "take a shorter time step, or conservative = \"mclachlan\"",
                      heating > 0 ? "grew" : "fell", heating > 0 ? "heats" : "cools",
                      100 * std::abs(heating)));
  }

  void look_for_pairs() {
    look_for_share("pairing", means_.pairing, &InstantMoments::pairing, conditions_.tolerable_pairing,
                   fmt::format("had a neighbour nearer than {} mean distances", pairing_distance),
                   "the kernel lets particles pair, which carries pressure and density away; take kernel = "
                   "\"wendland-c4\" or fewer neighbours");
  }

  void look_for_crystal() {
    look_for_share(
        "crystal", means_.crystal, &InstantMoments::crystal, conditions_.tolerable_crystal,
        "had neighbours in the order of a crystal",
        "the particles are not a fluid. They have kept the lattice of the start or have frozen; take "
        "particles.start = \"melted\", smaller particles or another number of neighbours");
  }

  /// Warns where more of the particles than may be do what fluids do not.
  void look_for_share(std::string const& name, cg::Estimate const& mean, double InstantMoments::*share,
                      double tolerable, std::string const& what, std::string const& advice) {
    auto const in_the_end = end_of(share);
    if (is_surely_above(mean, in_the_end, tolerable))
      add(name, false,
          fmt::format("{:.3g} % of the particles {}, {:.3g} % in the last quarter of the run: {}",
                      100 * mean.mean, what, 100 * in_the_end.mean, advice));
  }

  /// The mean over the last quarter of the instants, which lie apart, so that their scatter is its error.
  cg::Estimate end_of(double InstantMoments::*quantity) const {
    auto const series = samples_.at_instants(quantity);
    if (series.empty())
      return {};
    std::size_t const count = std::max<std::size_t>(series.size() / 4, 1), last = series.size() - count;
    std::span<double const> const end(series.begin() + static_cast<std::ptrdiff_t>(last), series.end());
    double const mean = std::accumulate(end.begin(), end.end(), 0.0) / static_cast<double>(count);
    double squares = 0;
    for (double const share : end)
      squares += (share - mean) * (share - mean);
    return {mean, std::sqrt(squares) / static_cast<double>(count)};
  }

  static bool is_surely_above(cg::Estimate const& mean, cg::Estimate const& in_the_end, double limit) {
    return std::max(mean.mean - 2 * mean.se, in_the_end.mean - 2 * in_the_end.se) > limit;
  }

  EquilibriumSampler const& samples_;
  Equilibrium const& means_;
  HealthConditions const& conditions_;
  std::vector<Finding> findings_;
};

} // namespace

Trend trend(std::span<double const> series) {
  std::size_t const n = series.size();
  require(n >= 16, "samples for a trend", n, "must be at least 16");
  std::vector<double> x(n), left(n);
  for (std::size_t k = 0; k < n; ++k)
    x[k] = static_cast<double>(k) / static_cast<double>(n - 1);
  double offset, slope, cov_00, cov_01, cov_11, sum_of_squares;
  gsl_fit_linear(x.data(), 1, series.data(), 1, n, &offset, &slope, &cov_00, &cov_01, &cov_11,
                 &sum_of_squares);
  for (std::size_t k = 0; k < n; ++k)
    left[k] = series[k] - offset - slope * x[k];
  double const spread_of_x = std::sqrt(1.0 / 12);
  return {slope, cg::estimate_mean(left).se / spread_of_x};
}

double error_without_gain(cg::Estimate const& T, double gained_temperature) {
  return std::sqrt(std::max(0.0, T.se * T.se - gained_temperature * gained_temperature));
}

std::vector<Finding> examine(EquilibriumSampler const& samples, Equilibrium const& means,
                             HealthConditions const& conditions) {
  return Examination(samples, means, conditions).findings();
}

} // namespace mesobridge::sdpd
