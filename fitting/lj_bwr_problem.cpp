#include "fitting/lj_bwr_problem.hpp"
#include "fitting/lj_bwr_design.hpp"
#include <nlopt.hpp>

namespace mesobridge::fitting {

LjBwrProblem whiten(std::vector<LjBwrDatum> const& data, LjBwrPrior kind, LjRegion const& region,
                    double gamma) {
  auto prior = kind == LjBwrPrior::published ? published_prior(region, gamma) : wide_prior(region, gamma);
  Eigen::MatrixXd A(2 * data.size(), bwr::parameters);
  Eigen::VectorXd r(A.rows());
  for (std::size_t i = 0; i < data.size(); ++i) {
    auto const& datum = data[i];
    auto const rows = residual_rows(datum.rho, datum.T, gamma);
    Eigen::Matrix<double, 2, bwr::parameters> both;
    both << rows.U, rows.P;
    auto const L = datum.noise.triangularView<Eigen::Lower>();
    A.middleRows<2>(2 * i) = L.solve(both);
    r.segment<2>(2 * i) = L.solve(datum.residual - both * prior.centre);
  }
  prior.R.triangularView<Eigen::Upper>().solveInPlace<Eigen::OnTheRight>(A);
  LinearGaussian linear(A, r);
  return {gamma, std::move(prior), std::move(A), std::move(r), std::move(linear)};
}

double best_gamma(std::vector<LjBwrDatum> const& data, LjBwrPrior kind, LjRegion const& region,
                  WidthBounds widths) {
  auto evidence_at = [&](double gamma) {
    auto const problem = whiten(data, kind, region, gamma);
    return problem.linear.log_evidence(problem.linear.best_width(widths.low, widths.high));
  };
  nlopt::opt search(nlopt::LN_COBYLA, 1);
  search.set_max_objective([](unsigned, double const* gamma, double*,
                              void* f) { return (*static_cast<decltype(evidence_at)*>(f))(*gamma); },
                           &evidence_at);
  search.set_lower_bounds(2);
  search.set_upper_bounds(4);
  search.set_initial_step(0.2);
  search.set_xtol_abs(1e-3);
  search.set_maxeval(60);
  std::vector<double> gamma{lj_bwr_1993.gamma};
  double evidence = 0;
  search.optimize(gamma, evidence);
  return gamma[0];
}

} // namespace mesobridge::fitting
