#pragma once
#include "cg/blobs.hpp"
#include <random>

namespace mesobridge::tests {

/// Blobs without a memory in a cubic box: places anywhere, Maxwell's velocities, energies of a Gamma law.
class RandomBlobs {
 public:
  RandomBlobs(double edge, std::uint64_t seed) : edge_(edge), bits_(seed), place_(0, edge), energy_(40, 1) {}

  cg::BlobFrame frame(int number, int molecules) {
    cg::BlobFrame frame{
        .step = 10 * number, .time = 0.5 * number, .box = {{edge_, edge_, edge_}}, .blobs = {}};
    for (int m = 0; m < molecules; ++m)
      frame.blobs.push_back({.R = {place_(bits_), place_(bits_), place_(bits_)},
                             .P = {5 * normal_(bits_), 5 * normal_(bits_), 5 * normal_(bits_)},
                             .U_kin = energy_(bits_),
                             .U_pot = energy_(bits_),
                             .Phi = normal_(bits_)});
    return frame;
  }

 private:
  double edge_;
  std::mt19937_64 bits_;
  std::normal_distribution<double> normal_;
  std::uniform_real_distribution<double> place_;
  std::gamma_distribution<double> energy_;
};

} // namespace mesobridge::tests
