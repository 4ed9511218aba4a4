#include "fitting/fit_eos.hpp"
#include "fitting/data_summary.hpp"
#include "fitting/eos_problem.hpp"
#include "md/error.hpp"
#include <algorithm>

namespace mesobridge::fitting {
namespace {

Parameter& named(EosFamily& family, std::string const& name) {
  std::vector<std::string> names;
  for (auto& parameter : family.parameters) {
    if (parameter.name == name || parameter.key == name)
      return parameter;
    names.push_back(parameter.name);
  }
  throw InputError(
      fmt::format("{} has no parameter '{}'; its parameters: {}", family.name, name, fmt::join(names, ", ")));
}

/// Gives a parameter a start value; bounds that do not hold it are widened around it, unless they are the
/// user's.
void start_at(Parameter& parameter, double value) {
  parameter.start = value;
  if (value <= parameter.lower)
    parameter.lower = parameter.logarithmic ? 0.5 * value : value - 0.5 * std::abs(value);
  if (value >= parameter.upper)
    parameter.upper = parameter.logarithmic ? 2 * value : value + 0.5 * std::abs(value);
}

void apply(EosFitOptions const& options, EosFamily& family) {
  if (options.from) {
    auto const values = family.values_of(*options.from);
    for (Eigen::Index i = 0; i < values.size(); ++i)
      start_at(family.parameters[static_cast<std::size_t>(i)], values[i]);
  }
  for (auto const& [name, value] : options.start)
    start_at(named(family, name), value);
  for (auto const& name : options.free)
    named(family, name).free = true;
  for (auto const& [name, bounds] : options.bounds) {
    auto& parameter = named(family, name);
    parameter.free = true;
    std::tie(parameter.lower, parameter.upper) = bounds;
    if (parameter.start < bounds.first || parameter.start > bounds.second) {
      require(!options.start.contains(parameter.name) && !options.start.contains(parameter.key),
              fmt::format("start of {}", parameter.name), parameter.start, "must be within its bounds");
      parameter.start = parameter.logarithmic && bounds.first > 0 ? std::sqrt(bounds.first * bounds.second)
                                                                  : 0.5 * (bounds.first + bounds.second);
    }
  }
  for (auto const& [name, value] : options.fixed) {
    auto& parameter = named(family, name);
    require(!options.bounds.contains(parameter.name) && !options.bounds.contains(parameter.key), name, value,
            "is both fixed and bounded: choose one");
    parameter.start = value;
    parameter.free = false;
  }
}

EosRegion region_of(DataSummary const& data, EosFitOptions const& options) {
  if (!options.region)
    return {data.rho_min, data.rho_max, data.T_min.value_or(0), data.T_max.value_or(0)};
  auto const& r = *options.region;
  require(r.rho_min > 0 && r.rho_max >= r.rho_min && std::isfinite(r.rho_max), "densities of the region",
          fmt::format("{}:{}", r.rho_min, r.rho_max), "must be > 0 and in order");
  require(r.T_min > 0 && r.T_max >= r.T_min && std::isfinite(r.T_max), "temperatures of the region",
          fmt::format("{}:{}", r.T_min, r.T_max), "must be > 0 and in order");
  return r;
}

/// Fits, renews the noise of uncertain given quantities by the fit, and fits again until neither moves.
FitOutcome fit_with_noise(EosProblem& problem, FitProblem& search, FitOptions options) {
  FitOutcome outcome = fit(search, options);
  constexpr int most = 20;
  constexpr double tolerance = 1e-3; // of a standard error
  for (int pass = 0; problem.renew_noise(outcome.values); ++pass) {
    if (pass == most)
      throw PhysicsError("the errors of the given quantities and the fit do not settle");
    for (auto const i : outcome.free)
      search.parameters[static_cast<std::size_t>(i)].start = outcome.values[i];
    options.global_evaluations = 0;
    FitOutcome next = fit(search, options);
    next.starts = outcome.starts, next.starts_at_best = outcome.starts_at_best;
    double moved = 0;
    for (auto const i : next.free)
      moved = std::max(moved, std::abs(next.values[i] - outcome.values[i]) / next.se(i));
    outcome = std::move(next);
    if (moved < tolerance)
      break;
  }
  return outcome;
}

FittedObservation beside_fit(EosProblem const& problem, FitOutcome const& outcome,
                             Observation const& observation, std::size_t index) {
  FittedObservation fitted{observation, problem.reached(observation, outcome.values), {}};
  auto const se = problem.standard_errors(index);
  auto const predicted = problem.predictions(observation, outcome.values);
  for (Eigen::Index k = 0; k < predicted.size(); ++k) {
    auto const& datum = observation.measured[static_cast<std::size_t>(k)];
    auto const value = [&](Eigen::VectorXd const& values) {
      return problem.predictions(observation, values)[k];
    };
    fitted.data.push_back({datum.quantity, datum.value, se[k], predicted[k], outcome.se_of(value)});
  }
  return fitted;
}

ValidRange box_of(std::vector<FittedObservation> const& observations) {
  auto const extremes = [&](double ReachedState::*member) {
    auto const [low, high] =
        std::ranges::minmax(observations, {}, [&](FittedObservation const& o) { return o.state.*member; });
    return std::pair(low.state.*member, high.state.*member);
  };
  auto const [rho_min, rho_max] = extremes(&ReachedState::rho);
  auto const [T_min, T_max] = extremes(&ReachedState::T);
  auto const [e_min, e_max] = extremes(&ReachedState::e);
  return {rho_min, rho_max, T_min, T_max, e_min, e_max};
}

} // namespace

EosModel EosFit::model(std::string data_hash, std::map<std::string, std::string> provenance) const {
  // The energy offset is the last parameter and no part of the model: the leading rows of L are its
  // covariance.
  std::vector<std::string> fitted;
  for (auto const i : outcome.free)
    if (i + 1 < outcome.values.size())
      fitted.push_back(outcome.parameters[static_cast<std::size_t>(i)].key);
  auto const n = static_cast<Eigen::Index>(fitted.size());
  return {.eos = eos,
          .covariance_factor = Eigen::MatrixXd(outcome.covariance_factor.topLeftCorner(n, n)),
          .valid = valid,
          .data_hash = std::move(data_hash),
          .provenance = std::move(provenance),
          .fitted = std::move(fitted)};
}

cg::Estimate EosFit::estimate(Observation const& observation, Quantity quantity) const {
  auto const value = [&](Eigen::VectorXd const& values) {
    return predicted(family, observation, quantity, values);
  };
  return {value(outcome.values), outcome.se_of(value), 0};
}

double EosFit::value(Observation const& observation, Quantity quantity) const {
  return predicted(family, observation, quantity, outcome.values);
}

EosFit fit_eos(EosFamily family, std::vector<Observation> data, EosFitOptions const& options) {
  require(!data.empty(), "data", "no observation", "at least one is needed");
  apply(options, family);
  auto const region = region_of(summarise(data), options);
  EosProblem problem(family, data, region);
  FitProblem search{family.parameters,
                    [&](Eigen::VectorXd const& values) { return problem.residuals(values); },
                    [&](Eigen::VectorXd const& values) { return problem.sound_speeds_squared(values); }};
  auto outcome = fit_with_noise(problem, search, options.search);
  std::optional<Bootstrap> drawn;
  if (options.bootstrap > 0)
    drawn = bootstrap(search, outcome, options.bootstrap, options.search.seed, options.search.keep_going);
  std::vector<FittedObservation> observations;
  for (std::size_t i = 0; i < data.size(); ++i)
    observations.push_back(beside_fit(problem, outcome, data[i], i));
  auto const c_2 = problem.sound_speeds_squared(outcome.values);
  auto const valid = box_of(observations);
  return {.family = family,
          .eos = family.build(outcome.values),
          .outcome = outcome,
          .bootstrap = std::move(drawn),
          .observations = std::move(observations),
          .region = region,
          .c_2_min = c_2.size() > 0 ? 1e6 * c_2.minCoeff() : 0,
          .valid = valid,
          .energy_offset = outcome.values[outcome.values.size() - 1]};
}

} // namespace mesobridge::fitting
