#include "fitting/quadrature.hpp"
#include "md/error.hpp"
#include <exception>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_integration.h>
#include <memory>

namespace mesobridge::fitting {
namespace {

/// The integrand behind GSL's C interface, through which no exception may pass.
struct Integrand {
  std::function<double(double)> const& f;
  std::exception_ptr error;

  static double call(double x, void* self) {
    auto& integrand = *static_cast<Integrand*>(self);
    if (integrand.error)
      return 0; // the rest of the rule's points do not matter any more
    try {
      return integrand.f(x);
    } catch (...) {
      integrand.error = std::current_exception();
      return 0;
    }
  }
};

} // namespace

double integral(std::function<double(double)> const& f, double a, double b) {
  if (a == b)
    return 0;
  constexpr std::size_t intervals = 200;
  constexpr double tolerance = 1e-12, worst = 1e-9;
  std::unique_ptr<gsl_integration_workspace, decltype(&gsl_integration_workspace_free)> const workspace(
      gsl_integration_workspace_alloc(intervals), gsl_integration_workspace_free);
  Integrand integrand{f, nullptr};
  gsl_function function{.function = Integrand::call, .params = &integrand};
  double value = 0, error = 0;
  auto* const handler = gsl_set_error_handler_off();
  gsl_integration_qag(&function, a, b, 0, tolerance, intervals, GSL_INTEG_GAUSS31, workspace.get(), &value,
                      &error);
  gsl_set_error_handler(handler);
  if (integrand.error)
    std::rethrow_exception(integrand.error);
  // GSL also complains when round-off keeps it from proving the last digits.
  if (!(error <= worst * std::abs(value)))
    throw PhysicsError(
        fmt::format("the integral from {} to {} is {} with an error of {}", a, b, value, error));
  return value;
}

} // namespace mesobridge::fitting
