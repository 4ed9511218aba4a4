#include "cg/entropy_routes.hpp"
#include "cg/jackknife.hpp"
#include "cg/too_short.hpp"
#include <algorithm>
#include <cmath>
#include <numeric>

namespace mesobridge::cg {

namespace {

constexpr std::size_t fewest_blocks = 8, most_blocks = 40, groups_of_molecules = 40;
constexpr double taus_in_block = 6;
constexpr std::size_t grid_points = 31, bins_of_wham = 60;

/// The melt as one set of samples at its measured temperature, in blocks of time.
EnergySamples melt_samples(BlobSeries const& melt) {
  auto const molecules = melt.molecules;
  double const interval = melt.interval();
  double const tau = memory_time(melt.U, molecules, interval).tau;
  double const possible = interval * double(melt.frames()) / (taus_in_block * tau);
  if (possible < double(fewest_blocks))
    throw TooShort(fmt::format("the melt's run of {:.4g} time units is too short for errors of S(U): the "
                               "energies forget in {:.3g}, so at least {:.4g} are needed",
                               interval * double(melt.frames()), tau,
                               taus_in_block * tau * double(fewest_blocks)),
                   taus_in_block * tau * double(fewest_blocks));
  auto const blocks = time_blocks(melt.frames(), std::min(most_blocks, std::size_t(possible)));
  EnergySamples samples{.beta = 0, .U = {}, .U_kin = {}, .beta_without = {}};
  double const freedoms = 3 * (melt.free_atoms ? melt.atoms : 1);
  std::vector<double> kT, count; // sums over the molecules of each block
  for (auto const& [first, last] : blocks) {
    auto const begin = std::ptrdiff_t(first * molecules), end = std::ptrdiff_t(last * molecules);
    samples.U.emplace_back(melt.U.begin() + begin, melt.U.begin() + end);
    samples.U_kin.emplace_back(melt.U_kin.begin() + begin, melt.U_kin.begin() + end);
    double twice =
        2 * std::accumulate(melt.P.begin() + begin, melt.P.begin() + end, 0.0,
                            [&](double sum, Vec3 const& p) { return sum + norm2(p) / (2 * melt.mass); });
    if (melt.free_atoms)
      twice += 2 * std::accumulate(samples.U_kin.back().begin(), samples.U_kin.back().end(), 0.0);
    kT.push_back(twice / freedoms);
    count.push_back(double(end - begin));
  }
  double const all_kT = std::accumulate(kT.begin(), kT.end(), 0.0),
               all = std::accumulate(count.begin(), count.end(), 0.0),
               own = 1 - 3 / (freedoms * double(molecules)); // the total momentum is zero
  samples.beta = own * all / all_kT;
  for (std::size_t block = 0; block < blocks.size(); ++block)
    samples.beta_without.push_back(own * (all - count[block]) / (all_kT - kT[block]));
  return samples;
}

/// Isolated molecules, one set a level. They are independent of each other, so groups of them are the blocks.
std::vector<EnergySamples> vacuum_samples(LevelSeries const& isolated) {
  auto const& blobs = isolated.blobs;
  require(!isolated.set.empty() && isolated.set.size() == blobs.molecules,
          "levels of the isolated molecules (settings/set)", isolated.set.size(),
          fmt::format("must be one for each of {} molecules", blobs.molecules));
  std::vector<double> levels = isolated.set;
  std::sort(levels.begin(), levels.end());
  levels.erase(std::unique(levels.begin(), levels.end()), levels.end());
  auto const molecules = blobs.molecules;
  std::size_t const groups = std::min(groups_of_molecules, molecules / levels.size());
  require(groups >= 4, "isolated molecules at each level", molecules / levels.size(),
          "at least 4 are needed for errors");
  std::vector<EnergySamples> sets;
  for (double level : levels)
    sets.push_back({.beta = 1 / level,
                    .U = std::vector<std::vector<double>>(groups, std::vector<double>{}),
                    .U_kin = std::vector<std::vector<double>>(groups, std::vector<double>{}),
                    .beta_without = {}});
  std::vector<std::size_t> seen(levels.size(), 0);
  for (std::size_t m = 0; m < molecules; ++m) {
    auto const level =
        std::size_t(std::lower_bound(levels.begin(), levels.end(), isolated.set[m]) - levels.begin());
    std::size_t const group = seen[level]++ % groups;
    for (std::size_t frame = 0; frame < blobs.frames(); ++frame) {
      std::size_t const k = frame * molecules + m;
      sets[level].U[group].push_back(blobs.U[k]);
      sets[level].U_kin[group].push_back(blobs.U_kin[k]);
    }
  }
  return sets;
}

double mean_energy(EnergySamples const& samples) {
  double sum = 0;
  for (auto const& block : samples.U)
    sum += std::accumulate(block.begin(), block.end(), 0.0);
  return sum / double(samples.count());
}

class Routes {
 public:
  explicit Routes(EntropyInputs const& inputs) : order_(inputs.order) {}

  void add(std::string const& name, std::span<EnergySamples const> samples, EntropyRoute route, int atoms) {
    auto const fit = [&](std::size_t order) { return fit_entropy(samples, route, atoms, {.order = order}); };
    auto const C = [&](EntropyCurve const& curve) { return curve.C(result.U_mean); };
    EntropyRoutes::Curve curve{.name = name, .fit = fit(order_), .C = {}, .C_bias = 0};
    curve.C = curve.fit.estimate(C);
    curve.C_bias = C(fit(order_ + 1).curve) - C(curve.fit.curve);
    result.curves.push_back(std::move(curve));
  }

  EntropyRoutes result;

 private:
  std::size_t order_;
};

std::vector<double> grid_of(EntropyCurve const& curve) {
  std::vector<double> U;
  for (std::size_t k = 0; k < grid_points; ++k)
    U.push_back(std::lerp(curve.U_low(), curve.U_high(), double(k) / (grid_points - 1)));
  return U;
}

Estimate variance_C(EnergySamples const& samples) {
  std::vector<Sums> blocks;
  double const mean = mean_energy(samples);
  for (auto const& block : samples.U) {
    Sums sums(3, 0.0);
    for (double U : block)
      sums[0] += 1, sums[1] += U - mean, sums[2] += (U - mean) * (U - mean);
    blocks.push_back(std::move(sums));
  }
  double const beta = samples.beta;
  return jackknife(blocks, [&](Sums const& s) {
    double const off = s[1] / s[0];
    return std::vector<double>{beta * beta * (s[2] / s[0] - off * off)};
  })[0];
}

} // namespace

EntropyRoutes::Curve const* EntropyRoutes::curve(std::string const& name) const {
  for (auto const& curve : curves)
    if (curve.name == name)
      return &curve;
  return nullptr;
}

EntropyRoutes entropy_routes(EntropyInputs const& inputs) {
  using Route = EntropyRoute;
  Routes routes(inputs);
  auto& result = routes.result;
  std::vector<EnergySamples> vacuum;
  if (inputs.vacuum) {
    vacuum = vacuum_samples(*inputs.vacuum);
    result.U_mean = mean_energy(vacuum[vacuum.size() / 2]);
  }
  if (inputs.melt) {
    std::vector<EnergySamples> const melt{melt_samples(*inputs.melt)};
    result.U_mean = mean_energy(melt[0]);
    result.C_from_variance = variance_C(melt[0]);
    routes.add("melt", melt, Route::density, inputs.melt->atoms);
    routes.add("melt_kinetic", melt, Route::kinetic, inputs.melt->atoms);
  }
  if (inputs.vacuum) {
    int const atoms = inputs.vacuum->blobs.atoms;
    routes.add("vacuum", vacuum, Route::density, atoms);
    routes.add("vacuum_kinetic", vacuum, Route::kinetic, atoms);
    result.wham = wham(vacuum, bins_of_wham);
    result.kinetic_bins = kinetic_temperature(vacuum, atoms, bins_of_wham / 3);
    result.equipartition.emplace(vacuum, atoms);
    result.equipartition_from = "canonical samples at each energy";
  }
  if (inputs.microcanonical) {
    result.equipartition.emplace(vacuum_samples(*inputs.microcanonical), inputs.microcanonical->blobs.atoms);
    result.equipartition_from = "runs at constant energy";
  }
  result.U = grid_of(result.curves.front().fit.curve);
  return std::move(routes.result);
}

} // namespace mesobridge::cg
