#include "md/error.hpp"
#include "workflows/coarse/friction_output.hpp"
#include <cmath>

namespace mesobridge::workflows {

double interval_of(HeldData const& data) {
  std::size_t const n = data.frames_of_each, whole = data.whole_configurations();
  require(n >= 2 && data.steps.size() >= n, "frames of a configuration", std::min(n, data.steps.size()),
          "a whole one has at least 2");
  double const interval = (data.times[n - 1] - data.times[0]) / double(n - 1);
  for (std::size_t k = 1; k < whole * n; ++k)
    if (double const apart = data.times[k] - data.times[k - 1]; k % n != 0)
      require(std::abs(apart - interval) < 1e-6 * interval, "interval of frames", apart,
              fmt::format("must be {:g} within all configurations", interval));
  return interval;
}

std::vector<cg::HeldConfiguration> configurations_of(HeldData const& data) {
  require(data.head.atoms >= 2, "atoms of a molecule", data.head.atoms,
          "must be at least 2: an atom that is held does not move");
  std::size_t const each = data.frames_of_each * data.molecules(), molecules = data.molecules();
  double const freedoms = 3 * double(data.head.atoms - 1);
  std::vector<cg::HeldConfiguration> all;
  for (std::size_t c = 0; c < data.whole_configurations(); ++c) {
    cg::HeldConfiguration one{.box = data.boxes[c], .R = {}, .F = {}};
    auto const part = [](auto const& values, std::size_t first, std::size_t count) {
      return std::vector(values.begin() + std::ptrdiff_t(first),
                         values.begin() + std::ptrdiff_t(first + count));
    };
    one.R = part(data.R, c * molecules, molecules), one.F = part(data.F, c * each, each);
    for (std::size_t k = c * each; k < (c + 1) * each; ++k)
      one.kT += 2 * data.U_kin[k] / (freedoms * double(each));
    all.push_back(std::move(one));
  }
  return all;
}

} // namespace mesobridge::workflows
