#pragma once
#include <cstdint>

namespace mesobridge::md {

/// A well-mixed function of a seed and a stream number (the SplitMix64 finaliser, Steele et al., OOPSLA
/// 2014): equal arguments give equal numbers on any number of ranks, neighbouring ones give unrelated
/// numbers.
inline std::uint64_t mix(std::uint64_t seed, std::uint64_t stream) {
  std::uint64_t z = seed + 0x9e3779b97f4a7c15u * (stream + 1);
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

/// A seed in the range that all of LAMMPS's generators take, 1 ... 900000000.
inline int lammps_seed(std::uint64_t seed, std::uint64_t stream) {
  return int(1 + mix(seed, stream) % 900000000);
}

} // namespace mesobridge::md
