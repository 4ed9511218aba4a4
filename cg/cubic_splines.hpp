#pragma once
#include <gsl/gsl_bspline.h>
#include <memory>
#include <span>

namespace mesobridge::cg {

/// Cubic B-splines over [first, end], with as many equal intervals between their knots as are asked for.
class CubicSplines {
 public:
  CubicSplines(double first, double end, std::size_t intervals);

  std::size_t size() const { return values_->size; } ///< intervals + 3
  double first() const { return first_; }
  double end() const { return end_; }
  /// All at r, beyond first and end as there; they stand until the next call.
  std::span<double const> operator()(double r) const;

 private:
  std::unique_ptr<gsl_bspline_workspace, decltype(&gsl_bspline_free)> workspace_;
  std::unique_ptr<gsl_vector, decltype(&gsl_vector_free)> values_;
  double first_, end_;
};

} // namespace mesobridge::cg
