#pragma once
#include "fitting/fit.hpp"
#include <optional>

namespace mesobridge::fitting {

/// The free parameters of a problem as coordinates u in the unit box, which all stages of a fit share.
class FitCoordinates {
 public:
  /// Throws InputError unless lower < upper and lower <= start <= upper for every free parameter, and
  /// lower > 0 for logarithmic ones.
  explicit FitCoordinates(FitProblem const& problem, std::function<bool()> keep_going = nullptr);

  Eigen::Index size() const { return static_cast<Eigen::Index>(free_.size()); }
  std::vector<Eigen::Index> const& free() const { return free_; }
  /// The coordinates of linear parameters.
  std::vector<Eigen::Index> const& linear() const { return linear_; }
  /// One free parameter by its coordinate and back.
  double value(Eigen::Index coordinate, double u) const;
  double unit(Eigen::Index coordinate, double value) const;
  Eigen::VectorXd start() const;
  Eigen::VectorXd values(Eigen::VectorXd const& u) const; ///< all parameters
  Eigen::VectorXd slopes(Eigen::VectorXd const& u) const; ///< d(parameter)/du of the free ones

  /// Residuals, or nothing where the model has no answer, outside the box, or once the fit is to end: C
  /// libraries that call this must not be left by an exception.
  std::optional<Eigen::VectorXd> residuals(Eigen::VectorXd const& u) const;
  /// Those of a point that has them. Throws Interrupted once the fit is to end.
  Eigen::VectorXd known_residuals(Eigen::VectorXd const& u) const;
  void throw_if_stopped() const;
  /// Constraints, or nothing where they cannot be told; empty when there are none.
  std::optional<Eigen::VectorXd> constraints(Eigen::VectorXd const& u) const;
  /// Whether the point lies in the box, the model has an answer and the constraints are positive.
  bool feasible(Eigen::VectorXd const& u) const;
  /// Residuals where feasible.
  std::optional<Eigen::VectorXd> feasible_residuals(Eigen::VectorXd const& u) const;
  /// d(residuals)/du by central differences, one-sided at the edge of what is feasible.
  /// Throws PhysicsError when neither side is, Interrupted once the fit is to end.
  Eigen::MatrixXd jacobian(Eigen::VectorXd const& u, Eigen::VectorXd const& residuals) const;

  int evaluations() const { return evaluations_; }
  std::function<bool()> const& keep_going() const { return keep_going_; }

 private:
  bool stopped() const;
  [[noreturn]] void refuse_edge(Eigen::Index coordinate, Eigen::VectorXd const& u) const;

  FitProblem const& problem_;
  std::function<bool()> keep_going_;
  std::vector<Eigen::Index> free_, linear_;
  mutable int evaluations_ = 0;
  mutable bool stopped_ = false;
};

} // namespace mesobridge::fitting
