#include "sdpd/observe/radial_distribution.hpp"
#include "md/error.hpp"
#include <algorithm>
#include <numbers>

namespace mesobridge::sdpd {

RadialDistribution::RadialDistribution(Box const& box, double r_max, std::size_t bins)
    : box_(box), width_(r_max / static_cast<double>(bins)), counts_(bins) {
  double const shortest = box.narrowest();
  require(r_max > 0 && r_max <= shortest / 2, "r_max of g(r)", r_max, "must be > 0 and at most half an edge");
}

void RadialDistribution::add(std::span<Vec3 const> q) {
  for (std::size_t i = 0; i < q.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      double const r = norm(box_.minimum_image(q[i] - q[j]));
      auto const bin = static_cast<std::size_t>(r / width_);
      if (bin < counts_.size())
        counts_[bin] += 1;
    }
  particles_ = static_cast<double>(q.size());
  instants_ += 1;
}

std::vector<double> RadialDistribution::g() const {
  require(instants_ > 0, "instants of g(r)", instants_, "must be > 0");
  double const pairs = instants_ * particles_ * (particles_ - 1) / 2;
  std::vector<double> g(counts_.size());
  for (std::size_t bin = 0; bin < g.size(); ++bin) {
    double const inner = width_ * static_cast<double>(bin), outer = inner + width_;
    double const shell =
        4 * std::numbers::pi / 3 * (outer * outer * outer - inner * inner * inner) / box_.volume();
    g[bin] = counts_[bin] / (pairs * shell);
  }
  return g;
}

double RadialDistribution::neighbours_within(double r) const {
  require(instants_ > 0, "instants of g(r)", instants_, "must be > 0");
  double sum = 0;
  for (std::size_t bin = 0; bin < counts_.size() && centre(bin) < r; ++bin)
    sum += counts_[bin];
  return 2 * sum / (instants_ * particles_);
}

} // namespace mesobridge::sdpd
