#include "fitting/fit_lj_bwr.hpp"
#include "fitting/eos/kolafa_nezbeda.hpp"
#include "fitting/held_out.hpp"
#include "fitting/lj_bwr_design.hpp"
#include "fitting/lj_bwr_problem.hpp"
#include "md/error.hpp"
#include <algorithm>
#include <limits>

namespace mesobridge::fitting {
namespace {

using Data = std::vector<LjBwrDatum>;
using Problem = LjBwrProblem;

WidthBounds width_bounds(LjBwrFitOptions const& options) {
  if (!options.prior_width)
    return options.prior == LjBwrPrior::published ? WidthBounds{2e-4, 0.5} : WidthBounds{1e-2, 1e6};
  double const width = *options.prior_width;
  require(width > 0 && std::isfinite(width), "prior width", width, "must be > 0");
  return {width, width};
}

LjRegion box_of(Data const& data) {
  auto const [rho_min, rho_max] = std::ranges::minmax(data, {}, &LjBwrDatum::rho);
  auto const [T_min, T_max] = std::ranges::minmax(data, {}, &LjBwrDatum::T);
  return {rho_min.rho, rho_max.rho, T_min.T, T_max.T};
}

double continuation_temperature(cg::StateGrid const& grid, LjBwrFitOptions const& options) {
  if (options.T_low)
    return *options.T_low;
  double coldest = std::numeric_limits<double>::infinity();
  for (auto const& point : grid.points)
    coldest = std::min(coldest, point.T);
  return std::max(lj_bwr_T_low, std::isfinite(coldest) ? 0.75 * coldest : 0);
}

/// Where the fit will be used, hence where it must be physical.
LjRegion region_to_check(LjRegion const& sampled, LjBwrFitOptions const& options, double T_low) {
  if (options.prior == LjBwrPrior::none)
    return sampled;
  return {0.01, lj_bwr_1993.rho_max, T_low, lj_bwr_1993.T_max};
}

void check_enough(Data const& data, LjBwrFitOptions const& options) {
  bool const free = options.prior == LjBwrPrior::none;
  require(data.size() >= (free ? 20u : 3u), "number of states in the grid", data.size(),
          free ? "must be at least 20 without the published prior (32 parameters, 2 data a state)"
               : "must be at least 3");
  auto const box = box_of(data);
  require(!free || (box.T_max > box.T_min && box.rho_max > box.rho_min), "grid", "one density or temperature",
          "must span several without the published prior");
  require(box.rho_max <= lj_bwr_1993.rho_max && box.T_max <= lj_bwr_1993.T_max, "grid",
          fmt::format("rho* up to {}, T* up to {}", box.rho_max, box.T_max),
          "must stay within rho* <= 1.3, T* <= 100");
  require(options.folds == 0 || (options.folds >= 2 && options.folds <= static_cast<int>(data.size())),
          "folds", options.folds, "must be 0 (leave one state out) or from 2 to the number of states");
}

/// The region becomes the model's domain.
LjBwrSet set_from(Problem const& problem, LinearPosterior const& posterior, LjRegion const& region) {
  Eigen::VectorXd const x =
      problem.prior.centre + problem.prior.R.triangularView<Eigen::Upper>().solve(posterior.mean);
  LjBwrSet set{.x = {},
               .gamma = problem.gamma,
               .T_low = region.T_min,
               .T_max = region.T_max,
               .rho_max = region.rho_max};
  Eigen::Map<Eigen::VectorXd>(set.x.data(), bwr::parameters) = x;
  return set;
}

/// The covariance R^-1 S S^T R^-T of x as L L^T, without forming it (it would lose half of the digits).
Eigen::MatrixXd covariance_factor(Problem const& problem, LinearPosterior const& posterior) {
  Eigen::MatrixXd const spread = problem.prior.R.triangularView<Eigen::Upper>().solve(posterior.spread);
  Eigen::HouseholderQR<Eigen::MatrixXd> const qr(spread.transpose());
  Eigen::MatrixXd const upper = qr.matrixQR().triangularView<Eigen::Upper>();
  return upper.transpose();
}

/// The groups of states that are left out together.
std::vector<std::vector<std::size_t>> held_out_groups(std::size_t states, int folds) {
  std::size_t const groups = folds == 0 ? states : static_cast<std::size_t>(folds);
  std::vector<std::vector<std::size_t>> members(groups);
  for (std::size_t i = 0; i < states; ++i)
    members[i % groups].push_back(i);
  return members;
}

/// The fit beside its data, state by state.
std::vector<LjBwrFitPoint> compare(Data const& data, Problem const& problem,
                                   LinearPosterior const& posterior) {
  Eigen::Map<Eigen::VectorXd const> const published(lj_bwr_1993.x.data(), bwr::parameters);
  Eigen::VectorXd const residual = problem.r - problem.A * posterior.mean;
  std::vector<LjBwrFitPoint> points;
  for (std::size_t i = 0; i < data.size(); ++i) {
    auto const& [rho, T, y, y_residual, L] = data[i];
    auto const rows = residual_rows(rho, T, lj_bwr_1993.gamma);
    Eigen::Vector2d const fitted = y - L * residual.segment<2>(2 * i);
    Eigen::Vector2d const se = L.rowwise().norm();
    Eigen::Matrix2d const of_fit = L * posterior.hat.block<2, 2>(2 * i, 2 * i) * L.transpose();
    LjBwrFitPoint point{};
    point.rho = rho, point.T = T;
    point.U = y(0), point.U_se = se(0), point.U_fit = fitted(0), point.U_fit_se = std::sqrt(of_fit(0, 0));
    point.P = y(1), point.P_se = se(1), point.P_fit = fitted(1), point.P_fit_se = std::sqrt(of_fit(1, 1));
    point.U_published = 1.5 * T + rows.U * published;
    point.P_published = rho * T + rows.P * published;
    point.U_deviation = (point.U - point.U_fit) / point.U_se;
    point.P_deviation = (point.P - point.P_fit) / point.P_se;
    points.push_back(point);
  }
  return points;
}

/// Predictions of each state by the fit without it (and its fold), at the same prior.
void hold_out_states(std::vector<LjBwrFitPoint>& points, Data const& data, Problem const& problem,
                     LinearPosterior const& posterior, int folds) {
  Eigen::VectorXd const residual = problem.r - problem.A * posterior.mean;
  for (auto const& group : held_out_groups(data.size(), folds)) {
    std::vector<Eigen::Index> rows;
    for (std::size_t i : group)
      rows.insert(rows.end(), {static_cast<Eigen::Index>(2 * i), static_cast<Eigen::Index>(2 * i + 1)});
    HeldOut const held = hold_out(posterior.hat, residual, rows);
    for (std::size_t k = 0; k < group.size(); ++k) {
      Eigen::Matrix2d const& L = data[group[k]].noise;
      Eigen::Vector2d const error = L * held.error.segment<2>(2 * k);
      Eigen::Matrix2d const covariance = L * held.covariance.block<2, 2>(2 * k, 2 * k) * L.transpose();
      LjBwrFitPoint& point = points[group[k]];
      point.U_held_out = point.U - error(0), point.U_held_out_se = std::sqrt(covariance(0, 0));
      point.P_held_out = point.P - error(1), point.P_held_out_se = std::sqrt(covariance(1, 1));
      point.U_held_out_deviation = error(0) / point.U_held_out_se;
      point.P_held_out_deviation = error(1) / point.P_held_out_se;
    }
  }
}

/// Narrows the prior by halves until the fit is physical over the region.
struct Physical {
  double width;
  int strengthened;
  LinearPosterior posterior;
  LjBwrSet set;
  LjStability stability;
};

Physical strengthen_until_stable(Problem const& problem, double width, LjRegion const& region) {
  constexpr int most = 40; // the prior's centre itself, to round-off
  for (int strengthened = 0;; ++strengthened, width /= 2) {
    auto posterior = problem.linear.posterior(width);
    auto const set = set_from(problem, posterior, region);
    auto const found = stability(set, region);
    if (found.stable())
      return {width, strengthened, std::move(posterior), set, found};
    if (strengthened == most)
      throw PhysicsError(fmt::format(
          "no prior width gives a stable LJ-BWR fit: c_v/k_B = {:.4g} at rho* = {:.4g}, T* = {:.4g}; "
          "{} states with c^2 <= 0",
          found.c_v_min, found.rho_at_c_v_min, found.T_at_c_v_min, found.unstable));
  }
}

struct State {
  double U, P;
};

/// `reference(rho, T)` returns a State.
template <class Reference>
LjBwrFit::Difference largest_difference(LjBwr const& eos, LjRegion const& region, Reference&& reference) {
  LjBwrFit::Difference largest{0, 0};
  for_each_state(region, 31, 31, [&](double rho, double T) {
    auto const fitted = eos.isochore(rho);
    auto const [U, P] = reference(rho, T);
    largest.P = std::max(largest.P, std::abs(fitted.pressure(T) - P) / std::max(std::abs(P), rho * T));
    largest.U = std::max(largest.U, std::abs(fitted.energy(T) - U) / std::max(std::abs(U), T));
  });
  return largest;
}

void summarise_held_out(LjBwrFit& fit) {
  double inside = 0, sum = 0;
  for (auto const& point : fit.points) {
    double const U = std::abs(point.U_held_out_deviation), P = std::abs(point.P_held_out_deviation);
    inside += U <= 3 && P <= 3;
    sum += U * U + P * P;
  }
  auto const states = static_cast<double>(fit.points.size());
  fit.held_out_fraction = inside / states;
  fit.rms_held_out_deviation = std::sqrt(sum / (2 * states));
}

} // namespace

LjBwrFit fit_lj_bwr(cg::StateGrid const& grid, LjBwrFitOptions const& options) {
  double const T_low = continuation_temperature(grid, options);
  Data const data = prepare_lj_bwr_data(grid, T_low, options.relative_error_floor);
  check_enough(data, options);
  LjRegion const sampled = box_of(data), region = region_to_check(sampled, options, T_low);
  auto const bounds = width_bounds(options);
  double const gamma =
      options.fit_gamma ? best_gamma(data, options.prior, region, bounds) : lj_bwr_1993.gamma;
  Problem const problem = whiten(data, options.prior, region, gamma);
  double const width = problem.linear.best_width(bounds.low, bounds.high);
  auto const chosen = strengthen_until_stable(problem, width, region);
  auto const [e_min, e_max] = std::ranges::minmax(data, {}, [](auto const& datum) { return datum.y(0); });
  LjBwrFit fit{.eos = LjBwr(chosen.set),
               .covariance_factor = covariance_factor(problem, chosen.posterior),
               .prior_width = chosen.width,
               .evidence_width = width,
               .strengthened = chosen.strengthened,
               .log_evidence = problem.linear.log_evidence(chosen.width),
               .condition = problem.linear.condition(),
               .condition_regularised = problem.linear.condition(chosen.width),
               .effective_parameters = chosen.posterior.effective_parameters,
               .chi_2 = (problem.r - problem.A * chosen.posterior.mean).squaredNorm(),
               .degrees_of_freedom =
                   2.0 * static_cast<double>(data.size()) - chosen.posterior.effective_parameters,
               .points = compare(data, problem, chosen.posterior),
               .held_out_fraction = 0,
               .rms_held_out_deviation = 0,
               .sampled = sampled,
               .e_min = e_min.y(0),
               .e_max = e_max.y(0),
               .checked = region,
               .stability = chosen.stability};
  hold_out_states(fit.points, data, problem, chosen.posterior, options.folds);
  summarise_held_out(fit);
  return fit;
}

LjBwrFit::Prediction LjBwrFit::predict(double rho, double T) const {
  require(T >= eos.set().T_low, "temperature of a prediction", T, "must be at least T_low");
  auto const rows = residual_rows(rho, T, eos.set().gamma);
  auto const isochore = eos.isochore(rho);
  return {.U = isochore.energy(T),
          .U_se = (rows.U * covariance_factor).norm(),
          .P = isochore.pressure(T),
          .P_se = (rows.P * covariance_factor).norm()};
}

LjBwrFit::Difference LjBwrFit::difference_from_published(double T_max) const {
  LjBwr const published(lj_bwr_1993);
  auto const region =
      LjRegion{sampled.rho_min, sampled.rho_max, sampled.T_min, std::min(sampled.T_max, T_max)};
  return largest_difference(eos, region, [&](double rho, double T) {
    auto const reference = published.isochore(rho);
    return State{reference.energy(T), reference.pressure(T)};
  });
}

LjBwrFit::Difference LjBwrFit::difference_from_kolafa_nezbeda() const {
  return largest_difference(eos, sampled, [](double rho, double T) {
    return State{1.5 * T + kolafa_nezbeda_energy(rho, T), kolafa_nezbeda_pressure(rho, T)};
  });
}

} // namespace mesobridge::fitting
