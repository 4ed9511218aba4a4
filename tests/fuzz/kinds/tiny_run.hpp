#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace mesobridge::fuzz {

/// A run of a few milliseconds that writes every file that a run can write.
inline std::vector<std::string> tiny_run(std::vector<std::string> const& more) {
  std::vector<std::string> words{"run", "scene.toml", "-o", "out", "--quiet", "--threads", "1"};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

inline constexpr char const* tiny_scene = R"(title = "tiny"
units = "SI"

[fluid]
eos = "ideal-gas"
m0 = "39.948 u"
rho = "1150 kg/m^3"
T = "1000 K"

[particles]
N = 216
K = 50
kernel = "wendland-c2"
density = "plain"

[transport]
eta = "2e-4 Pa*s"
zeta = "0 Pa*s"

[scheme]
name = "ssa"
dt = 0.05

[run]
equilibrate = 32
steps = 320
sample_every = 5
instant_every = 20
trajectory_every = 80
vtkhdf_every = 80
xyz_every = 160
checkpoint_every = 100

[profile]
every = 80

[histogram]
every = 80
)";

} // namespace mesobridge::fuzz
