#include "sdpd/friction/friction_shape.hpp"
#include <gsl/gsl_interp.h>
#include <memory>

namespace mesobridge::sdpd {
namespace {

void check(std::vector<double> const& r, std::vector<double> const& gamma, char const* name) {
  require(gamma.size() == r.size() && r.size() >= 3, "points of the table", gamma.size(),
          "must be at least 3, as many as distances");
  for (std::size_t k = 0; k < r.size(); ++k) {
    require(gamma[k] >= 0 && std::isfinite(gamma[k]), name, gamma[k], "must be >= 0 and finite");
    require(std::isfinite(r[k]) && (k == 0 ? r[k] >= 0 : r[k] > r[k - 1]), "distance in the table", r[k],
            "must be >= 0, finite and larger than the one before");
  }
}

class Interpolated {
 public:
  Interpolated(std::vector<double> const& r, std::vector<double> const& values)
      : r_(r), values_(values),
        interpolation_(gsl_interp_alloc(gsl_interp_steffen, r.size()), gsl_interp_free) {
    gsl_interp_init(interpolation_.get(), r.data(), values.data(), r.size());
  }
  double operator()(double r) const {
    double const inside = std::min(std::max(r, r_.front()), r_.back());
    return gsl_interp_eval(interpolation_.get(), r_.data(), values_.data(), inside, nullptr);
  }

 private:
  std::vector<double> const &r_, &values_;
  std::unique_ptr<gsl_interp, decltype(&gsl_interp_free)> interpolation_;
};

UniformTable tabulate(std::vector<double> const& r, std::vector<double> const& par,
                      std::vector<double> const& perp) {
  check(r, par, "weight along the line of centres");
  std::vector<double> const across = perp.empty() ? std::vector<double>(r.size(), 0.0) : perp;
  check(r, across, "weight across the line of centres");
  Interpolated const par_at(r, par), perp_at(r, across);
  return UniformTable(r.front(), r.back(), [&](double at, double width) {
    double const par_0 = par_at(at), perp_0 = perp_at(at);
    return Row{par_0, par_at(at + width) - par_0, perp_0, perp_at(at + width) - perp_0};
  });
}

} // namespace

TabulatedFriction::TabulatedFriction(std::vector<double> const& r, std::vector<double> const& par,
                                     std::vector<double> const& perp)
    : has_across_(std::ranges::any_of(perp, [](double gamma) { return gamma > 0; })),
      table_(tabulate(r, par, perp)) {}

} // namespace mesobridge::sdpd
