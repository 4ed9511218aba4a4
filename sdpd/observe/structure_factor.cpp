#include "sdpd/observe/structure_factor.hpp"
#include "md/error.hpp"
#include "sdpd/observe/measurement.hpp"
#include <algorithm>
#include <complex>
#include <numbers>

namespace mesobridge::sdpd {
namespace {

using Phases = std::vector<std::complex<double>>; ///< one a particle

/// exp(2 pi i n x/L) of each particle for n = 0 ... largest.
class PhaseTable {
 public:
  PhaseTable(std::span<Vec3 const> q, Box const& box, int axis, double k_max)
      : edge_(component(box.edge, axis)), periodic_(box.periodic[static_cast<unsigned>(axis)]) {
    double const unit = 2 * std::numbers::pi / edge_;
    largest_ = periodic_ ? static_cast<int>(k_max / unit) : 0;
    for (int n = 0; n <= largest_; ++n) {
      auto& phases = of_.emplace_back();
      phases.reserve(q.size());
      for (auto const& at : q)
        phases.push_back(std::polar(1.0, n * unit * component(at, axis)));
    }
  }

  int largest() const { return largest_; }
  double k(int n) const { return 2 * std::numbers::pi * n / edge_; }
  /// The factor of particle j at n, which may be negative.
  std::complex<double> at(int n, std::size_t j) const {
    auto const& phase = of_[static_cast<std::size_t>(std::abs(n))][j];
    return n < 0 ? std::conj(phase) : phase;
  }

 private:
  double edge_;
  bool periodic_;
  int largest_ = 0;
  std::vector<Phases> of_;
};

double squared_sum(Phases const& in_plane, PhaseTable const& z, int n) {
  double real = 0, imaginary = 0;
  for (std::size_t j = 0; j < in_plane.size(); ++j) {
    auto const a = in_plane[j], b = z.at(n, j);
    real += a.real() * b.real() - a.imag() * b.imag();
    imaginary += a.real() * b.imag() + a.imag() * b.real();
  }
  return real * real + imaginary * imaginary;
}

/// Of two opposite vectors the one that counts.
bool is_of_the_half(int x, int y, int z) {
  return z > 0 || (z == 0 && (y > 0 || (y == 0 && x > 0)));
}

} // namespace

std::vector<Scattered> structure_factor(std::span<Vec3 const> q, Box const& box, double k_min, double k_max) {
  PhaseTable const x(q, box, 0, k_max), y(q, box, 1, k_max), z(q, box, 2, k_max);
  std::vector<Scattered> all;
  Phases in_plane(q.size());
  for (int n_x = -x.largest(); n_x <= x.largest(); ++n_x)
    for (int n_y = -y.largest(); n_y <= y.largest(); ++n_y) {
      double const across = std::hypot(x.k(n_x), y.k(n_y));
      if (across > k_max)
        continue;
      for (std::size_t j = 0; j < q.size(); ++j)
        in_plane[j] = x.at(n_x, j) * y.at(n_y, j);
      for (int n_z = 0; n_z <= z.largest(); ++n_z)
        if (double const k = std::hypot(across, z.k(n_z));
            k >= k_min && k <= k_max && is_of_the_half(n_x, n_y, n_z))
          all.push_back({k, squared_sum(in_plane, z, n_z) / static_cast<double>(q.size())});
    }
  require(!all.empty(), "wave vectors of the box for a structure factor", all.size(),
          fmt::format("must be some with {} <= k <= {}", k_min, k_max));
  return all;
}

StructurePeak structure_peak(std::span<Vec3 const> q, Box const& box) {
  constexpr double from = 5, to = 8;
  constexpr std::size_t shells = 12;
  double const spacing = std::cbrt(box.volume() / static_cast<double>(q.size()));
  std::array<double, shells> sum{}, count{};
  StructurePeak peak;
  for (auto const& [k, S] : structure_factor(q, box, from / spacing, to / spacing)) {
    auto const shell =
        std::min(static_cast<std::size_t>(shells * (k * spacing - from) / (to - from)), shells - 1);
    sum[shell] += S, ++count[shell];
    peak.largest = std::max(peak.largest, S);
  }
  for (std::size_t s = 0; s < shells; ++s)
    if (count[s] > 0)
      peak.shell = std::max(peak.shell, sum[s] / count[s]);
  return peak;
}

double lattice_order(std::span<Vec3 const> q, Box const& box) {
  double const count = static_cast<double>(q.size()), spacing = std::cbrt(box.volume() / count);
  double largest = 0;
  for (int axis = 0; axis < 3; ++axis) {
    if (!box.periodic[static_cast<unsigned>(axis)])
      continue;
    double const edge = component(box.edge, axis);
    double const k = 2 * std::numbers::pi * std::round(edge / spacing) / edge;
    std::complex<double> sum;
    for (auto const& at : q)
      sum += std::polar(1.0, k * component(at, axis));
    largest = std::max(largest, std::norm(sum) / (count * count));
  }
  return largest;
}

Measurement structure_factor() {
  static constexpr std::array<std::string_view, 2> components{"_peak", "_largest"};
  return {.name = "structure_factor",
          .meaning =
              "its first peak: the largest mean of a shell, and of one wave vector (N in a crystal); costs "
              "the square of N",
          .components = components,
          .exists = without_walls,
          .values = [](System const& system) -> std::vector<double> {
            auto const peak = structure_peak(system.particles.q, system.box);
            return {peak.shell, peak.largest};
          },
          .by_name_only = true,
          .fills_box = true};
}

} // namespace mesobridge::sdpd
