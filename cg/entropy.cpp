#include "cg/entropy.hpp"
#include "cg/density_fit.hpp"
#include "cg/regression.hpp"
#include "md/error.hpp"
#include <algorithm>
#include <cmath>
#include <gsl/gsl_statistics_double.h>

namespace mesobridge::cg {
namespace {

std::vector<double> all_energies(std::span<EnergySamples const> samples) {
  std::vector<double> all;
  for (auto const& set : samples)
    for (auto const& block : set.U)
      all.insert(all.end(), block.begin(), block.end());
  std::sort(all.begin(), all.end());
  require(all.size() >= 100, "samples of the energy of a molecule", all.size(), "at least 100 are needed");
  return all;
}

/// About the least energy of the molecule, if it lies far from 0: a molecule of constant heat capacity has
/// the mean energy U_0 + C T, whose variance is C T^2 (cg/README.md, Eq. (C57)). Energies that are counted
/// from near there already stay as they are. `sorted` are all energies.
double energy_zero(std::span<EnergySamples const> samples, std::vector<double> const& sorted) {
  double zero = 0, mean = 0, count = 0;
  for (auto const& set : samples) {
    std::vector<double> U;
    for (auto const& block : set.U)
      U.insert(U.end(), block.begin(), block.end());
    double const n = double(U.size()), of_set = gsl_stats_mean(U.data(), 1, U.size());
    zero += n * (of_set - set.beta * gsl_stats_variance(U.data(), 1, U.size()));
    mean += n * of_set, count += n;
  }
  zero /= count, mean /= count;
  double const lowest = sorted.front(), middle = sorted[sorted.size() / 2];
  bool const counted_from_zero = lowest > 0 && zero < mean / 2;
  return counted_from_zero ? 0 : std::min(zero, lowest - (middle - lowest) / 5);
}

std::size_t common_blocks(std::span<EnergySamples const> samples) {
  require(!samples.empty(), "sets of samples", samples.size(), "at least one is needed");
  std::size_t const blocks = samples.front().U.size();
  require(blocks >= 4, "blocks of samples", blocks, "at least 4 are needed");
  for (auto const& set : samples)
    require(set.U.size() == blocks, "blocks of a set of samples", set.U.size(), "all sets need as many");
  return blocks;
}

/// The inverse temperatures without one block; without none for a block beyond the last.
std::vector<double> betas_without(std::span<EnergySamples const> samples, std::size_t block) {
  std::vector<double> betas;
  for (auto const& set : samples)
    betas.push_back(block < set.beta_without.size() ? set.beta_without[block] : set.beta);
  return betas;
}

} // namespace

std::size_t EnergySamples::count() const {
  std::size_t total = 0;
  for (auto const& block : U)
    total += block.size();
  return total;
}

Estimate EntropyFit::estimate(std::function<double(EntropyCurve const&)> const& number) const {
  std::vector<double> of_rests;
  for (auto const& other : without)
    of_rests.push_back(number(other));
  return jackknifed(number(curve), of_rests);
}

EntropyFit fit_entropy(std::span<EnergySamples const> samples, EntropyRoute route, int atoms,
                       EntropySettings const& settings) {
  std::size_t const blocks = common_blocks(samples);
  require(settings.order >= 1 && settings.order <= 6, "order of the entropy curve", settings.order,
          "must be 1 ... 6");
  require(settings.tail >= 0 && settings.tail < 0.25, "part of the samples beyond the ends", settings.tail,
          "must be in [0, 0.25)");
  auto const all = all_energies(samples);
  auto const quantile = [&](double part) { return all[std::size_t(part * double(all.size() - 1))]; };
  double const zero = energy_zero(samples, all);
  EntropyCurve::Basis const basis{
      .U_ref = quantile(0.5),
      .width = std::max(1e-9, std::log((quantile(0.84) - zero) / (quantile(0.16) - zero)) / 2),
      .order = settings.order,
      .U_0 = zero};
  double const low = quantile(settings.tail), high = quantile(1 - settings.tail);
  std::vector<Sums> sums;
  std::function<std::vector<double>(std::size_t, Sums const&, std::vector<double> const&)> solve;
  DensityFit const density(basis, all.front(), all.back());
  if (route == EntropyRoute::density) {
    for (std::size_t block = 0; block < blocks; ++block)
      sums.push_back(density.sums(samples, block));
    solve = [&](std::size_t block, Sums const& s, std::vector<double> const& start) {
      return density.solve(s, betas_without(samples, block), start);
    };
  } else {
    for (std::size_t block = 0; block < blocks; ++block)
      sums.push_back(kinetic_sums(basis, samples, block, atoms));
    solve = [&](std::size_t, Sums const& s, std::vector<double> const&) {
      return solve_regression(s, basis.order);
    };
  }
  auto const rests = without_each(sums);
  auto const theta = solve(blocks, rests.back(), {});
  EntropyFit fit{.curve = EntropyCurve(basis, theta, low, high), .without = {}, .samples = all.size()};
  for (std::size_t block = 0; block < blocks; ++block)
    fit.without.emplace_back(basis, solve(block, rests[block], theta), low, high);
  return fit;
}

namespace {

/// Of fits without each block, the last one with all.
Estimate estimate(std::vector<std::vector<double>> const& fits,
                  std::function<double(std::vector<double> const&)> const& number) {
  std::vector<double> values;
  for (auto const& fit : fits)
    values.push_back(number(fit));
  return jackknifed(values.back(), std::span(values).first(values.size() - 1));
}

} // namespace

Equipartition::Equipartition(std::span<EnergySamples const> samples, int atoms) {
  std::size_t const blocks = common_blocks(samples);
  auto const all = all_energies(samples);
  U_ref_ = all[all.size() / 2];
  width_ = std::max(1e-9, (all[all.size() * 84 / 100] - all[all.size() * 16 / 100]) / 2);
  std::vector<Sums> parabola, line;
  for (std::size_t block = 0; block < blocks; ++block) {
    Sums of_parabola(3 * 3 + 3, 0.0), of_line(2 * 2 + 2, 0.0);
    for (auto const& set : samples)
      for (std::size_t i = 0; i < set.U[block].size(); ++i) {
        double const x = (set.U[block][i] - U_ref_) / width_, T = 2 * set.U_kin[block][i] / (3.0 * atoms);
        add_sample(of_parabola, {1, x, x * x}, T);
        add_sample(of_line, {1, x}, T);
      }
    parabola.push_back(std::move(of_parabola));
    line.push_back(std::move(of_line));
  }
  for (auto const& sums : without_each(parabola))
    coefficients_.push_back(solve_regression(sums, 3));
  for (auto const& sums : without_each(line))
    lines_.push_back(solve_regression(sums, 2));
}

Estimate Equipartition::T(double U) const {
  double const x = (U - U_ref_) / width_;
  return estimate(coefficients_, [&](auto const& c) { return c[0] + x * (c[1] + x * c[2]); });
}

Estimate Equipartition::C(double U) const {
  double const x = (U - U_ref_) / width_;
  return estimate(coefficients_, [&](auto const& c) { return width_ / (c[1] + 2 * x * c[2]); });
}

Estimate Equipartition::slope_C() const {
  return estimate(lines_, [&](auto const& c) { return width_ / c[1]; });
}

} // namespace mesobridge::cg
