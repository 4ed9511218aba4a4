#include "cg/viscous_decay.hpp"
#include "md/error.hpp"
#include <algorithm>
#include <cmath>

namespace mesobridge::cg {
namespace {

double squares(std::span<double const> values, double interval, ViscousDecay const& decay) {
  double sum = 0;
  for (std::size_t lag = 0; lag < values.size(); ++lag) {
    double const miss = values[lag] - decay(double(lag) * interval);
    sum += miss * miss;
  }
  return sum;
}

ViscousDecay decay_of(double ln_rate, double ln_memory) {
  return {std::exp(ln_rate), std::exp(ln_memory)};
}

/// The normal equations of a step in ln a and ln T: the matrix, then the right-hand side.
struct Normal {
  double aa = 0, aT = 0, TT = 0, a = 0, T = 0;
};

Normal normal_at(std::span<double const> values, double interval, double ln_rate, double ln_memory) {
  constexpr double h = 1e-5;
  auto const at = decay_of(ln_rate, ln_memory), more_a = decay_of(ln_rate + h, ln_memory),
             less_a = decay_of(ln_rate - h, ln_memory), more_T = decay_of(ln_rate, ln_memory + h),
             less_T = decay_of(ln_rate, ln_memory - h);
  Normal sum;
  for (std::size_t lag = 0; lag < values.size(); ++lag) {
    double const t = double(lag) * interval, miss = values[lag] - at(t),
                 by_a = (more_a(t) - less_a(t)) / (2 * h), by_T = (more_T(t) - less_T(t)) / (2 * h);
    sum.aa += by_a * by_a, sum.aT += by_a * by_T, sum.TT += by_T * by_T;
    sum.a += by_a * miss, sum.T += by_T * miss;
  }
  return sum;
}

/// Memory times below a thousandth of an interval leave no trace in the values.
double least_ln_memory(double interval) {
  return std::log(1e-3 * interval);
}

} // namespace

double ViscousDecay::operator()(double t) const {
  double const v = t / (2 * memory), W2 = 1 - 4 * rate * memory;
  if (W2 > 1e-4) { // two decays, lambda = (1 -+ W)/2T, of which the slower is found without a difference
    double const W = std::sqrt(W2), slow = 2 * rate / (1 + W), gap = W / memory, fast = slow + gap;
    return std::exp(-slow * t) * (fast - slow * std::exp(-gap * t)) / gap;
  }
  if (W2 < -1e-4) {
    double const w = std::sqrt(-W2);
    return std::exp(-v) * (std::cos(w * v) + std::sin(w * v) / w);
  }
  double const x2 = W2 * v * v; // both series in W^2 v^2, which is small wherever exp(-v) is not
  return std::exp(-v) * (1 + x2 / 2 + x2 * x2 / 24 + v * (1 + x2 / 6 + x2 * x2 / 120));
}

ViscousDecay fit_viscous_decay(std::span<double const> values, double interval) {
  require(values.size() >= 4, "values of a decay", values.size(), "at least 4 are needed");
  double area = 0.5 * (values.front() + values.back());
  for (double const value : values.subspan(1, values.size() - 2))
    area += value;
  double ln_rate = -std::log(std::max(area, 0.1) * interval), ln_memory = std::log(interval), damping = 1e-3;
  double least = squares(values, interval, decay_of(ln_rate, ln_memory));
  int steps = 0;
  for (; steps < 200 && damping < 1e8; ++steps) {
    auto const n = normal_at(values, interval, ln_rate, ln_memory);
    double const aa = n.aa * (1 + damping), TT = n.TT * (1 + damping) + 1e-12 * n.aa,
                 det = aa * TT - n.aT * n.aT, step_a = (n.a * TT - n.T * n.aT) / det,
                 step_T = (n.T * aa - n.a * n.aT) / det, next_a = ln_rate + std::clamp(step_a, -1.0, 1.0),
                 next_T = std::max(ln_memory + std::clamp(step_T, -1.0, 1.0), least_ln_memory(interval)),
                 next = squares(values, interval, decay_of(next_a, next_T));
    bool const better = next < least, done = better && least - next < 1e-14 * (least + 1e-30);
    if (better)
      ln_rate = next_a, ln_memory = next_T, least = next, damping *= 0.2;
    else
      damping *= 5;
    if (done)
      break;
  }
  auto const found = decay_of(ln_rate, ln_memory);
  if (!(std::isfinite(found.rate) && std::isfinite(found.memory)))
    throw PhysicsError("the correlation of a transverse current does not die away: no viscosity fits it");
  return found;
}

} // namespace mesobridge::cg
