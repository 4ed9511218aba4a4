#include "sdpd/observe/list.hpp"

namespace mesobridge::sdpd {

std::vector<Measurement> observed_sums();

std::vector<Measurement> const& measurements() {
  static auto const all = observed_sums();
  return all;
}

} // namespace mesobridge::sdpd
