#include "sdpd/kernel/list.hpp"
#include "md/error.hpp"
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace mesobridge::sdpd {
namespace {

/// Calls f.template operator()<Kernel>() for every kernel of the list.
template <class F, std::size_t... k>
void for_each_kernel(F const& f, std::index_sequence<k...>) {
  (f.template operator()<std::variant_alternative_t<k, AnyKernel>>(), ...);
}
template <class F>
void for_each_kernel(F const& f) {
  for_each_kernel(f, std::make_index_sequence<std::variant_size_v<AnyKernel>>());
}

[[noreturn]] void refuse(std::string_view name, std::string_view what) {
  std::string known;
  for (auto const& each : kernel_names())
    known += (known.empty() ? "" : ", ") + each;
  throw InputError(fmt::format("{} '{}'; kernels: {}", what, name, known));
}

} // namespace

std::vector<std::string> kernel_names() {
  std::vector<std::string> names;
  for_each_kernel([&]<class Kernel>() { names.emplace_back(Kernel::name); });
  return names;
}

AnyKernel make_kernel(std::string_view name, double h, double scale) {
  std::optional<AnyKernel> found;
  for_each_kernel([&]<class Kernel>() {
    if (name == Kernel::name)
      found = Kernel(h, scale);
  });
  if (!found)
    refuse(name, "no kernel is named");
  return *found;
}

DensityCorrection glass_correction(std::string_view kernel, double neighbours) {
  struct Law {
    std::string_view kernel;
    double epsilon_100, a;
    double least, most; // neighbours
  };
  constexpr double any = std::numeric_limits<double>::infinity();
  constexpr std::array<Law, 5> laws{{{"wendland-c2", 0.0294, 0.977, 40, any},
                                     {"wendland-c4", 0.01342, 1.579, 40, any},
                                     {"wendland-c6", 0.0116, 2.236, 40, any},
                                     {"cubic", -0.018, 0, 50, 68},
                                     {"lucy", -0.038, 0, 50, 68}}};
  for (auto const& law : laws)
    if (law.kernel == kernel) {
      require(neighbours >= law.least && neighbours <= law.most, "neighbours", neighbours,
              fmt::format("must lie in {} ... {} for the glass correction of the kernel '{}'", law.least,
                          law.most, kernel));
      return {.scale = 1, .self = law.epsilon_100 * std::pow(neighbours / 100, -law.a)};
    }
  refuse(kernel, "there is no glass correction for the kernel");
}

double self_density(AnyKernel const& kernel, DensityCorrection const& correction) {
  double const W_0 = std::visit([](auto const& of) { return of.W(0.0); }, kernel); // with the scale
  return W_0 * (1 - correction.self / correction.scale);
}

} // namespace mesobridge::sdpd
