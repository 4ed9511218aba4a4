#pragma once
#include <string>

namespace mesobridge::tests {

/// A small scene of soft particles, in Lennard-Jones units; tables are texts, "key = value" a line.
struct SoftScene {
  std::string method = "dpde"; ///< or dpd, without internal energies
  int N = 216;
  std::string run = "steps = 64\n";
  std::string potential = "name = \"soft\"\na = 25\ncutoff = 1\n"; ///< empty: none
  std::string friction = "gamma_par = 4.5\ncutoff = 1\n";

  std::string text() const {
    return "title = \"small\"\nunits = \"lj\"\n[method]\nname = \"" + method +
           "\"\n[fluid]\nrho = 3\nT = 1\n[particles]\nN = " + std::to_string(N) + "\nmass = 1\n" +
           (potential.empty() ? "" : "[potential]\n" + potential) + "[friction]\n" + friction +
           (method == "dpde" ? "[internal_energy]\nheat_capacity = 60\n" : "") +
           "[scheme]\ndt = 0.01\n[run]\n" + run;
  }
};

} // namespace mesobridge::tests
