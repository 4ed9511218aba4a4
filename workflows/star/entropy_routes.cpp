#include "cg/too_short.hpp"
#include "workflows/report/number_text.hpp"
#include "workflows/star/blob_analysis.hpp"
#include "workflows/summary.hpp"
#include <algorithm>
#include <cmath>
#include <numeric>

namespace mesobridge::workflows {

namespace {

constexpr std::size_t fewest_blocks = 8, most_blocks = 40, groups_of_molecules = 40;
constexpr double taus_in_block = 6;
constexpr std::size_t grid_points = 31, bins_of_wham = 60;

void require_kind(BlobData const& data, std::string const& kind) {
  if (data.head.kind != kind)
    throw InputError(fmt::format("a file of kind '{}' was given where '{}' is needed", data.head.kind, kind));
}

/// The melt as one set of samples at its measured temperature, in blocks of time.
cg::EnergySamples melt_samples(BlobData const& data) {
  auto const molecules = std::size_t(data.head.molecules);
  std::vector<double> U;
  for (std::size_t k = 0; k < data.U_kin.size(); ++k)
    U.push_back(data.U(k));
  double const interval = (data.times.back() - data.times.front()) / double(data.frames() - 1);
  double const tau = cg::memory_time(U, molecules, interval).tau;
  double const possible = interval * double(data.frames()) / (taus_in_block * tau);
  if (possible < double(fewest_blocks))
    throw cg::TooShort(fmt::format("the melt's run of {:.4g} time units is too short for errors of S(U): the "
                                   "energies forget in {:.3g}, so at least {:.4g} are needed",
                                   interval * double(data.frames()), tau,
                                   taus_in_block * tau * double(fewest_blocks)),
                       taus_in_block * tau * double(fewest_blocks));
  auto const blocks = cg::time_blocks(data.frames(), std::min(most_blocks, std::size_t(possible)));
  cg::EnergySamples samples{.beta = 0, .U = {}, .U_kin = {}, .beta_without = {}};
  std::vector<double> P2, count;
  for (auto const& [first, last] : blocks) {
    auto const begin = std::ptrdiff_t(first * molecules), end = std::ptrdiff_t(last * molecules);
    samples.U.emplace_back(U.begin() + begin, U.begin() + end);
    samples.U_kin.emplace_back(data.U_kin.begin() + begin, data.U_kin.begin() + end);
    P2.push_back(std::accumulate(data.P.begin() + begin, data.P.begin() + end, 0.0,
                                 [](double sum, Vec3 const& p) { return sum + norm2(p) / 3; }));
    count.push_back(double(end - begin));
  }
  double const all_P2 = std::accumulate(P2.begin(), P2.end(), 0.0),
               all = std::accumulate(count.begin(), count.end(), 0.0);
  double const mass = data.head.mass * (1 - 1 / double(molecules)); // the total momentum is zero
  samples.beta = mass * all / all_P2;
  for (std::size_t block = 0; block < blocks.size(); ++block)
    samples.beta_without.push_back(mass * (all - count[block]) / (all_P2 - P2[block]));
  return samples;
}

/// Isolated molecules, one set a level. They are independent of each other, so groups of them are the blocks.
std::vector<cg::EnergySamples> vacuum_samples(BlobData const& data) {
  std::vector<double> levels = data.head.set;
  std::sort(levels.begin(), levels.end());
  levels.erase(std::unique(levels.begin(), levels.end()), levels.end());
  auto const molecules = std::size_t(data.head.molecules);
  std::size_t const groups = std::min(groups_of_molecules, molecules / levels.size());
  require(groups >= 4, "isolated molecules at each level", molecules / levels.size(),
          "at least 4 are needed for errors");
  std::vector<cg::EnergySamples> sets;
  for (double level : levels)
    sets.push_back({.beta = 1 / level,
                    .U = std::vector<std::vector<double>>(groups, std::vector<double>{}),
                    .U_kin = std::vector<std::vector<double>>(groups, std::vector<double>{}),
                    .beta_without = {}});
  std::vector<std::size_t> seen(levels.size(), 0);
  for (std::size_t m = 0; m < molecules; ++m) {
    auto const level =
        std::size_t(std::lower_bound(levels.begin(), levels.end(), data.head.set[m]) - levels.begin());
    std::size_t const group = seen[level]++ % groups;
    for (std::size_t frame = 0; frame < data.frames(); ++frame) {
      std::size_t const k = frame * molecules + m;
      sets[level].U[group].push_back(data.U(k));
      sets[level].U_kin[group].push_back(data.U_kin[k]);
    }
  }
  return sets;
}

double mean_energy(cg::EnergySamples const& samples) {
  double sum = 0;
  for (auto const& block : samples.U)
    sum += std::accumulate(block.begin(), block.end(), 0.0);
  return sum / double(samples.count());
}

class Routes {
 public:
  explicit Routes(EntropyInputs const& inputs) : order_(inputs.order) {}

  void add(std::string const& name, std::span<cg::EnergySamples const> samples, cg::EntropyRoute route,
           int atoms) {
    auto const fit = [&](std::size_t order) {
      return cg::fit_entropy(samples, route, atoms, {.order = order});
    };
    auto const C = [&](cg::EntropyCurve const& curve) { return curve.C(result.U_mean); };
    EntropyRoutes::Curve curve{.name = name, .fit = fit(order_), .C = {}, .C_bias = 0};
    curve.C = curve.fit.estimate(C);
    curve.C_bias = C(fit(order_ + 1).curve) - C(curve.fit.curve);
    result.curves.push_back(std::move(curve));
  }

  EntropyRoutes result;

 private:
  std::size_t order_;
};

std::vector<double> grid_of(cg::EntropyCurve const& curve) {
  std::vector<double> U;
  for (std::size_t k = 0; k < grid_points; ++k)
    U.push_back(std::lerp(curve.U_low(), curve.U_high(), double(k) / (grid_points - 1)));
  return U;
}

cg::Estimate variance_C(cg::EnergySamples const& samples) {
  std::vector<cg::Sums> blocks;
  double const mean = mean_energy(samples);
  for (auto const& block : samples.U) {
    cg::Sums sums(3, 0.0);
    for (double U : block)
      sums[0] += 1, sums[1] += U - mean, sums[2] += (U - mean) * (U - mean);
    blocks.push_back(std::move(sums));
  }
  double const beta = samples.beta;
  return cg::jackknife(blocks, [&](cg::Sums const& s) {
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
  using Route = cg::EntropyRoute;
  if (!inputs.melt && !inputs.vacuum)
    throw InputError("neither --melt nor --vacuum was given: at least one is needed");
  Routes routes(inputs);
  auto& result = routes.result;
  std::vector<cg::EnergySamples> vacuum;
  if (inputs.vacuum) {
    require_kind(*inputs.vacuum, "vacuum canonical");
    vacuum = vacuum_samples(*inputs.vacuum);
    result.U_mean = mean_energy(vacuum[vacuum.size() / 2]);
  }
  if (inputs.melt) {
    require_kind(*inputs.melt, "melt");
    std::vector<cg::EnergySamples> const melt{melt_samples(*inputs.melt)};
    result.U_mean = mean_energy(melt[0]);
    result.C_from_variance = variance_C(melt[0]);
    routes.add("melt", melt, Route::density, inputs.melt->head.atoms);
    routes.add("melt_kinetic", melt, Route::kinetic, inputs.melt->head.atoms);
  }
  if (inputs.vacuum) {
    int const atoms = inputs.vacuum->head.atoms;
    routes.add("vacuum", vacuum, Route::density, atoms);
    routes.add("vacuum_kinetic", vacuum, Route::kinetic, atoms);
    result.wham = cg::wham(vacuum, bins_of_wham);
    result.kinetic_bins = cg::kinetic_temperature(vacuum, atoms, bins_of_wham / 3);
    result.equipartition.emplace(vacuum, atoms);
    result.equipartition_from = "canonical samples at each energy";
  }
  if (inputs.microcanonical) {
    require_kind(*inputs.microcanonical, "vacuum microcanonical");
    result.equipartition.emplace(vacuum_samples(*inputs.microcanonical), inputs.microcanonical->head.atoms);
    result.equipartition_from = "runs at constant energy";
  }
  result.U = grid_of(result.curves.front().fit.curve);
  return std::move(routes.result);
}

Json entropy_json(EntropyRoutes const& routes) {
  Json json{{"U_mean", routes.U_mean}};
  for (auto const& curve : routes.curves) {
    put(json, "heat_capacity_" + curve.name, curve.C);
    json["heat_capacity_" + curve.name + "_bias"] = curve.C_bias;
  }
  if (routes.C_from_variance)
    put(json, "heat_capacity_melt_from_variance", *routes.C_from_variance);
  if (routes.equipartition) {
    put(json, "heat_capacity_vacuum_equipartition", routes.equipartition->slope_C());
    put(json, "heat_capacity_vacuum_equipartition_at_U_mean", routes.equipartition->C(routes.U_mean));
    put(json, "T_equipartition_at_U_mean", routes.equipartition->T(routes.U_mean));
    json["equipartition_from"] = routes.equipartition_from;
  }
  json["curves"] = Json::object();
  for (auto const& curve : routes.curves) {
    Json columns{{"U", routes.U}};
    for (char const* key : {"S", "S_se", "T", "T_se", "C", "C_se"})
      columns[key] = Json::array();
    auto const put_at = [&](char const* key, cg::Estimate const& estimate) {
      columns[key].push_back(estimate.mean);
      columns[std::string(key) + "_se"].push_back(estimate.se);
    };
    for (double U : routes.U) {
      put_at("S", curve.fit.estimate([&](auto const& c) { return c.S(U) - c.S(routes.U_mean); }));
      put_at("T", curve.fit.estimate([&](auto const& c) { return c.T(U); }));
      put_at("C", curve.fit.estimate([&](auto const& c) { return c.C(U); }));
    }
    columns["U_low"] = curve.fit.curve.U_low();
    columns["U_high"] = curve.fit.curve.U_high();
    columns["samples"] = curve.fit.samples;
    columns["method"] = fmt::format("S = sum of theta_j y^j, y = ln(U/{:.6g})/{:.4g}, {} terms",
                                    curve.fit.curve.basis().U_ref, curve.fit.curve.basis().width,
                                    curve.fit.curve.theta().size());
    json["curves"][curve.name] = std::move(columns);
  }
  if (routes.kinetic_bins) {
    Json bins{{"U", routes.kinetic_bins->U}};
    for (char const* key : {"T_exact", "T_exact_se", "T_equipartition", "T_equipartition_se"})
      bins[key] = Json::array();
    for (std::size_t k = 0; k < routes.kinetic_bins->U.size(); ++k) {
      bins["T_exact"].push_back(routes.kinetic_bins->T_exact[k].mean);
      bins["T_exact_se"].push_back(routes.kinetic_bins->T_exact[k].se);
      bins["T_equipartition"].push_back(routes.kinetic_bins->T_equipartition[k].mean);
      bins["T_equipartition_se"].push_back(routes.kinetic_bins->T_equipartition[k].se);
    }
    json["vacuum_bins"] = std::move(bins);
  }
  if (routes.wham) {
    Json bins{{"U", routes.wham->U}, {"S", Json::array()}, {"S_se", Json::array()}};
    for (auto const& S : routes.wham->S) {
      bins["S"].push_back(S.mean);
      bins["S_se"].push_back(S.se);
    }
    bins["U_reference"] = routes.wham->U_reference;
    json["wham"] = std::move(bins);
  }
  return json;
}

std::string entropy_text(EntropyRoutes const& routes) {
  std::string text = fmt::format("at U = {:.5g}        C                   T\n", routes.U_mean);
  auto const line = [&](std::string const& name, cg::Estimate const& C, cg::Estimate const& T) {
    text += fmt::format("{:<20} {:<19} {}\n", name, with_error_text(C), with_error_text(T));
  };
  for (auto const& curve : routes.curves)
    line(curve.name, curve.C, curve.fit.estimate([&](auto const& c) { return c.T(routes.U_mean); }));
  if (routes.equipartition)
    line("equipartition", routes.equipartition->C(routes.U_mean), routes.equipartition->T(routes.U_mean));
  if (routes.C_from_variance)
    text += fmt::format("{:<20} {}\n", "beta^2 Var(U), melt", with_error_text(*routes.C_from_variance));
  return text;
}

} // namespace mesobridge::workflows
