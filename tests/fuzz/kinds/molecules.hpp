#pragma once
#include "md/vec3.hpp"
#include <filesystem>
#include <random>
#include <vector>

namespace mesobridge::fuzz {

/// A few frames of bonded tetramers in a cube, as trajectories hold them, and the mapping for them.
struct Molecules {
  static constexpr int atoms = 4, molecules = 8, frames = 4;
  static constexpr double edge = 9;

  std::vector<Vec3> q, v; ///< frame by frame

  Molecules() {
    std::mt19937_64 bits(7);
    std::normal_distribution<double> normal;
    std::uniform_real_distribution<double> place(0, edge);
    for (int m = 0; m < molecules * frames; ++m) {
      Vec3 at{place(bits), place(bits), place(bits)};
      for (int a = 0; a < atoms; ++a) {
        q.push_back(at), v.push_back({normal(bits), normal(bits), normal(bits)});
        at += Vec3{0.6 + 0.1 * normal(bits), 0.6 + 0.1 * normal(bits), 0.5};
      }
    }
  }

  static void write_mapping(std::filesystem::path const& file);
};

} // namespace mesobridge::fuzz
