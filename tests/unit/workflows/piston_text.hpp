#pragma once
#include <fmt/format.h>
#include <string>

namespace mesobridge::tests {

/// What differs between scenes with a piston along z: 7 x 7 x `length` particles at 1150 kg/m^3 and 500 K.
/// Texts are lines of their sections.
struct PistonText {
  std::string eos = "argon";
  double K = 100, v_P = 500; ///< v_P [m/s]
  int length = 20;           ///< of the lattice along z
  std::string box = "", eta = "2e-3 Pa*s", scheme = "dt = 0.02", run = "steps = 100";
};

inline std::string piston_text(PistonText const& of) {
  return fmt::format(R"(title = "a piston"
units = "SI"
[fluid]
eos = "{}"
rho = "1150 kg/m^3"
T = "500 K"
{}
[particles]
N = {}
K = {}
density = "plain"
[box]
lattice = [7, 7, {}]
z = "walls"
piston = "{} m/s"
{}
[transport]
eta = "{}"
[scheme]
{}
[run]
{}
)",
                     of.eos, of.eos == "ideal-gas" ? "m0 = \"1e-25 kg\"" : "", 49 * of.length, of.K,
                     of.length, of.v_P, of.box, of.eta, of.scheme, of.run);
}

} // namespace mesobridge::tests
