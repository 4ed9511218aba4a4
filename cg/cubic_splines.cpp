#include "cg/cubic_splines.hpp"
#include <algorithm>

namespace mesobridge::cg {

CubicSplines::CubicSplines(double first, double end, std::size_t intervals)
    : workspace_(gsl_bspline_alloc(4, intervals + 1), gsl_bspline_free),
      values_(gsl_vector_alloc(gsl_bspline_ncoeffs(workspace_.get())), gsl_vector_free), first_(first),
      end_(end) {
  gsl_bspline_knots_uniform(first, end, workspace_.get());
}

std::span<double const> CubicSplines::operator()(double r) const {
  gsl_bspline_eval(std::clamp(r, first_, end_), values_.get(), workspace_.get());
  return {values_->data, size()};
}

} // namespace mesobridge::cg
