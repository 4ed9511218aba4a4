#include "cg/entropy.hpp"
#include "md/error.hpp"
#include <algorithm>
#include <cmath>

namespace mesobridge::cg {
namespace {

constexpr double fewest_in_bin = 20;
constexpr int most_iterations = 20000;
constexpr double converged = 1e-10;

/// Counts of every set in every bin: number set * bins + bin.
Sums counts_of(std::span<EnergySamples const> samples, std::size_t block, double low, double width,
               std::size_t bins) {
  Sums counts(samples.size() * bins, 0.0);
  for (std::size_t k = 0; k < samples.size(); ++k)
    for (double U : samples[k].U[block]) {
      double const place = (U - low) / width;
      if (place >= 0 && place < double(bins))
        counts[k * bins + std::size_t(place)] += 1;
    }
  return counts;
}

struct Solution {
  std::vector<double> ln_states; ///< ln of the density of states; only where something was seen
  int iterations = 0;
};

/// The self-consistent equations of Ferrenberg and Swendsen (cg/README.md, Eq. (C14)).
Solution solve(Sums const& counts, std::span<EnergySamples const> samples, std::vector<double> const& U) {
  std::size_t const sets = samples.size(), bins = U.size();
  std::vector<double> f(sets, 0.0), in_set(sets, 0.0), in_bin(bins, 0.0);
  for (std::size_t k = 0; k < sets; ++k)
    for (std::size_t b = 0; b < bins; ++b)
      in_set[k] += counts[k * bins + b], in_bin[b] += counts[k * bins + b];
  Solution result{.ln_states = std::vector<double>(bins, 0.0), .iterations = 0};
  for (double change = 1; change > converged; ++result.iterations) {
    if (result.iterations == most_iterations)
      throw PhysicsError(
          "WHAM did not converge: the energies of neighbouring temperatures do not overlap. Put "
          "temperatures between them");
    for (std::size_t b = 0; b < bins; ++b) {
      double top = -1e300, sum = 0;
      for (std::size_t k = 0; k < sets; ++k)
        top = std::max(top, f[k] - samples[k].beta * U[b]);
      for (std::size_t k = 0; k < sets; ++k)
        sum += in_set[k] * std::exp(f[k] - samples[k].beta * U[b] - top);
      result.ln_states[b] = in_bin[b] > 0 ? std::log(in_bin[b]) - std::log(sum) - top : 0;
    }
    std::vector<double> next;
    for (std::size_t k = 0; k < sets; ++k) {
      double top = -1e300, sum = 0;
      for (std::size_t b = 0; b < bins; ++b)
        if (in_bin[b] > 0)
          top = std::max(top, result.ln_states[b] - samples[k].beta * U[b]);
      for (std::size_t b = 0; b < bins; ++b)
        if (in_bin[b] > 0)
          sum += std::exp(result.ln_states[b] - samples[k].beta * U[b] - top);
      next.push_back(-std::log(sum) - top);
    }
    change = 0; // one of them is arbitrary: the first stays 0
    for (std::size_t k = 0; k < sets; ++k) {
      change = std::max(change, std::abs(next[k] - next[0] - f[k]));
      f[k] = next[k] - next[0];
    }
  }
  return result;
}

/// Equal bins that hold all energies.
struct EnergyBins {
  double low, width;
};

EnergyBins bins_of(std::span<EnergySamples const> samples, std::size_t bins) {
  double low = 1e300, high = -1e300;
  for (auto const& set : samples)
    for (auto const& block : set.U)
      for (double U : block)
        low = std::min(low, U), high = std::max(high, U);
  return {low, (high - low) * (1 + 1e-12) / double(bins)};
}

} // namespace

WhamEntropy wham(std::span<EnergySamples const> samples, std::size_t bins) {
  require(bins >= 2, "bins of WHAM", bins, "at least 2 are needed");
  auto const [low, width] = bins_of(samples, bins);
  std::vector<double> U(bins);
  for (std::size_t b = 0; b < bins; ++b)
    U[b] = low + (double(b) + 0.5) * width;
  std::vector<Sums> blocks;
  Sums seen(bins, 0.0);
  for (std::size_t block = 0; block < samples.front().U.size(); ++block) {
    blocks.push_back(counts_of(samples, block, low, width, bins));
    for (std::size_t k = 0; k < blocks.back().size(); ++k)
      seen[k % bins] += blocks.back()[k];
  }
  auto const reference = std::size_t(std::max_element(seen.begin(), seen.end()) - seen.begin());
  WhamEntropy result;
  result.U_reference = U[reference];
  auto const S = jackknife(blocks, [&](Sums const& counts) {
    auto solution = solve(counts, samples, U);
    result.iterations = std::max(result.iterations, solution.iterations);
    double const zero = solution.ln_states[reference];
    for (double& value : solution.ln_states)
      value -= zero;
    return solution.ln_states;
  });
  for (std::size_t b = 0; b < bins; ++b)
    if (seen[b] >= fewest_in_bin) {
      result.U.push_back(U[b]);
      result.S.push_back(S[b]);
    }
  return result;
}

KineticTemperature kinetic_temperature(std::span<EnergySamples const> samples, int atoms, std::size_t bins) {
  auto const [low, width] = bins_of(samples, bins);
  enum : std::size_t { count, energy, kinetic, inverse, numbers };
  std::vector<Sums> blocks;
  Sums seen(bins, 0.0);
  for (std::size_t block = 0; block < samples.front().U.size(); ++block) {
    Sums sums(bins * numbers, 0.0);
    for (auto const& set : samples)
      for (std::size_t i = 0; i < set.U[block].size(); ++i) {
        auto const bin = std::min(bins - 1, std::size_t((set.U[block][i] - low) / width));
        double* const s = &sums[bin * numbers];
        s[count] += 1, s[energy] += set.U[block][i], s[kinetic] += set.U_kin[block][i];
        s[inverse] += 1 / set.U_kin[block][i];
      }
    for (std::size_t b = 0; b < bins; ++b)
      seen[b] += sums[b * numbers];
    blocks.push_back(std::move(sums));
  }
  auto const estimates = jackknife(blocks, [&](Sums const& s) {
    double const factor = (3 * atoms - 3) / 2.0 - 1;
    std::vector<double> result;
    for (std::size_t b = 0; b < bins; ++b) {
      double const* const in = &s[b * numbers];
      double const n = std::max(1.0, in[count]);
      result.insert(result.end(), {in[energy] / n, in[inverse] > 0 ? n / (factor * in[inverse]) : 0,
                                   2 * in[kinetic] / (3 * n * atoms)});
    }
    return result;
  });
  KineticTemperature result;
  for (std::size_t b = 0; b < bins; ++b)
    if (seen[b] >= 100) {
      result.U.push_back(estimates[3 * b].mean);
      result.T_exact.push_back(estimates[3 * b + 1]);
      result.T_equipartition.push_back(estimates[3 * b + 2]);
    }
  return result;
}

} // namespace mesobridge::cg
