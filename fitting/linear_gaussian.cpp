#include "fitting/linear_gaussian.hpp"
#include "md/error.hpp"
#include <limits>

namespace mesobridge::fitting {

LinearGaussian::LinearGaussian(Eigen::MatrixXd const& A, Eigen::VectorXd const& r) : parameters_(A.cols()) {
  require(A.allFinite(), "design matrix", "an entry", "must be finite");
  require(r.allFinite(), "data", "an entry", "must be finite");
  require(A.rows() == r.size() && r.size() > 0, "data", r.size(),
          "must be as many as rows of the design matrix");
  Eigen::JacobiSVD<Eigen::MatrixXd> const svd(A, Eigen::ComputeThinU | Eigen::ComputeFullV);
  left_ = svd.matrixU();
  right_ = svd.matrixV();
  singular_ = svd.singularValues();
  projected_ = left_.transpose() * r;
  outside_ = std::max(0.0, r.squaredNorm() - projected_.squaredNorm());
}

double LinearGaussian::log_evidence(double w) const {
  Eigen::ArrayXd const variance = 1 + (w * singular_.array()).square();
  return -0.5 * (variance.log().sum() + (projected_.array().square() / variance).sum() + outside_);
}

double LinearGaussian::best_width(double low, double high) const {
  int const steps = 1 + static_cast<int>(std::log(high / low) / 0.015);
  double best = low, best_evidence = -std::numeric_limits<double>::infinity();
  for (int i = 0; i <= steps; ++i) {
    double const w = low * std::pow(high / low, double(i) / steps), evidence = log_evidence(w);
    if (evidence > best_evidence) {
      best_evidence = evidence;
      best = w;
    }
  }
  return best;
}

LinearPosterior LinearGaussian::posterior(double w) const {
  Eigen::ArrayXd const s = singular_.array(), share = (w * s).square() / (1 + (w * s).square());
  Eigen::VectorXd deviation = Eigen::VectorXd::Constant(parameters_, w);
  deviation.head(s.size()) = w / (1 + (w * s).square()).sqrt();
  auto const used = right_.leftCols(s.size());
  return {.mean = used * (w * w * s / (1 + (w * s).square())).matrix().asDiagonal() * projected_,
          .spread = right_ * deviation.asDiagonal(),
          .hat = left_ * share.matrix().asDiagonal() * left_.transpose(),
          .effective_parameters = share.sum()};
}

double LinearGaussian::condition() const {
  double const smallest = singular_.size() < parameters_ ? 0 : singular_.minCoeff();
  return smallest > 0 ? singular_.maxCoeff() / smallest : std::numeric_limits<double>::infinity();
}

double LinearGaussian::condition(double w) const {
  double const smallest = singular_.size() < parameters_ ? 0 : singular_.minCoeff();
  return std::hypot(singular_.maxCoeff(), 1 / w) / std::hypot(smallest, 1 / w);
}

} // namespace mesobridge::fitting
