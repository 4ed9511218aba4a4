#pragma once
#include <string>

namespace mesobridge::tests {

/// A small scene of an SDPD fluid; tables and further keys are texts, "key = value" a line.
struct SdpdScene {
  std::string fluid = "eos = \"argon\"\nrho = \"1150 kg/m^3\"\nT = \"1000 K\"\n";
  int N = 1000, K = 50;
  std::string particles = ""; ///< further keys of its table
  std::string tables = "";    ///< whole ones, between [particles] and [transport]
  std::string eta = "2e-3 Pa*s";
  std::string scheme = "dt = 0.05\n";
  std::string run = "steps = 1000\n"; ///< and tables behind it

  std::string text() const {
    return "title = \"small\"\n[fluid]\n" + fluid + "[particles]\nN = " + std::to_string(N) +
           "\nK = " + std::to_string(K) + "\n" + particles + tables + "[transport]\neta = \"" + eta +
           "\"\n[scheme]\n" + scheme + "[run]\n" + run;
  }
};

/// 343 particles of the thesis's ideal gas.
inline SdpdScene ideal_gas_scene(std::string const& run) {
  return {.fluid = "eos = \"ideal-gas\"\nrho = \"1150 kg/m^3\"\nT = \"1000 K\"\nm0 = \"1e-25 kg\"\n",
          .N = 343,
          .K = 100,
          .run = run};
}

/// 512 particles of nitromethane that burns, from behind the front of its detonation on.
inline SdpdScene burning_scene(std::string const& run) {
  return {.fluid = "eos = \"nitromethane\"\nrho = \"1700 kg/m^3\"\nT = \"2500 K\"\n",
          .N = 512,
          .K = 100,
          .particles = "density = \"plain\"\n",
          .tables = "[reaction]\nproduct = \"nitromethane-products\"\nheat_per_molecule = \"4.78e-19 J\"\n"
                    "kinetics = \"second-order\"\nZ = \"1e15 1/s\"\nE_a = \"3e-19 J\"\nprogress = 0.3\n",
          .eta = "1e-2 Pa*s",
          .scheme = "dt = 0.01\n",
          .run = run};
}

} // namespace mesobridge::tests
