#include "sdpd/setup/balance.hpp"
#include "md/error.hpp"
#include "md/processor_clock.hpp"
#include "sdpd/observe/runaway.hpp"
#include <algorithm>
#include <cmath>

namespace mesobridge::sdpd {
namespace {

constexpr std::int64_t samples = 64; ///< about so many of a trial

double largest(std::vector<double> const& values) {
  double found = 0;
  for (double const value : values)
    found = std::max(found, std::abs(value));
  return found;
}

double ratio(double error, double turnover) {
  return turnover > 0 ? error / turnover : 0;
}

/// |a t + b t^2| of the least squares of the errors, at `time`.
double fitted_error(BalanceSeries const& series, double time) {
  double t2 = 0, t3 = 0, t4 = 0, dt = 0, dt2 = 0;
  for (std::size_t k = 0; k < series.times.size(); ++k) {
    double const t = series.times[k], d = series.errors[k];
    t2 += t * t, t3 += t * t * t, t4 += t * t * t * t, dt += d * t, dt2 += d * t * t;
  }
  double const determinant = t2 * t4 - t3 * t3;
  if (!(determinant > 0))
    return 0;
  double const a = (dt * t4 - dt2 * t3) / determinant, b = (t2 * dt2 - t3 * dt) / determinant;
  return std::abs(a * time + b * time * time);
}

} // namespace

double error_share(BalanceSeries const& series) {
  return ratio(largest(series.errors), std::max(largest(series.given), largest(series.exchanged)));
}

double error_share_at(BalanceSeries const& series, double time) {
  if (series.times.empty())
    return 0;
  double const growth = std::max(1.0, time / series.times.back()), error = largest(series.errors);
  double const later = std::clamp(fitted_error(series, time), error * growth, error * growth * growth);
  return ratio(later, std::max(largest(series.given) * growth, largest(series.exchanged)));
}

BalanceResult run_balance_trial(BalanceTrial const& trial, Checkpoint const& start,
                                std::function<bool(std::int64_t)> const& keep_going) {
  auto const& settings = trial.settings;
  BalanceResult result{.failure = {}, .dt = settings.dt};
  BalanceSeries series;
  md::ProcessorClock const clock;
  std::int64_t done = 0;
  std::size_t particles = 1;
  try {
    Simulation simulation(settings);
    simulation.begin_from(start);
    particles = simulation.size();
    auto const first = simulation.observe();
    std::int64_t const every = std::max<std::int64_t>(1, trial.steps / samples);
    while (done < trial.steps) {
      auto const now = std::min(every, trial.steps - done);
      simulation.advance(static_cast<std::uint64_t>(now));
      done += now;
      auto const seen = simulation.observe();
      refuse_not_finite(seen, settings.dt);
      series.times.push_back(static_cast<double>(done) * settings.dt);
      series.errors.push_back(seen.energy() - first.energy());
      series.given.push_back(seen.given - first.given);
      series.exchanged.push_back(seen.internal - first.internal);
      if (!keep_going(done))
        throw Interrupted("the study was stopped; what was finished is stored");
    }
  } catch (PhysicsError const& error) {
    result.failure = error.what();
  }
  result.share = error_share(series);
  result.run_share = error_share_at(series, static_cast<double>(trial.run_steps) * settings.dt);
  result.us_per_particle_step =
      clock.seconds() * 1e6 / (static_cast<double>(std::max<std::int64_t>(1, done)) * double(particles));
  return result;
}

} // namespace mesobridge::sdpd
