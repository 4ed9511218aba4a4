#pragma once
#include "fuzz/kinds/reaction_text.hpp"
#include "sdpd/scheme/list.hpp"
#include <regex>

namespace mesobridge::fuzz {

/// A scene that does not stay at equilibrium: pistons, walls at rest and open faces, of every method, scheme
/// and kind of material, in a small box and a few steps, of a second at most. Mostly sensible, so that it
/// runs; sometimes with a time step, a piston or a state that cannot end well. One that reacts is an SDPD
/// fluid and smaller.
class DrivenScene {
 public:
  explicit DrivenScene(Random& random, bool reacts = false)
      : random_(random), across_(reacts ? 7 : 7 + random.below(2)),
        along_(reacts ? 8 + random.below(8) : 10 + random.below(15)), axis_(random.below(3)),
        has_regions_(random.chance(reacts ? 0.5 : 0.35)), reacts_(reacts) {}

  std::string text() {
    if (reacts_)
      return continuum();
    auto const method = random_.of<std::string>({"sdpd", "sdpd", "sdpd", "dpde", "dpd"});
    return method == "sdpd" ? continuum() : soft(method);
  }

 private:
  struct Material {
    std::string keys;
    double rho, T; ///< a usual state
  };

  double between(double low, double high) { return fuzz::between(random_, low, high); }
  double any_between(double low, double high) { return fuzz::any_between(random_, low, high); }

  std::string continuum() {
    auto material = random_.of<Material>({{"eos = \"argon\"", 1150, 500},
                                          {"eos = \"ideal-gas\"\nm0 = \"39.948 u\"", 1150, 1000},
                                          {"eos = \"ideal-gas\"\nm0 = \"39.948 u\"", 1.6, 300},
                                          {"eos = \"tin\"", 7000, 600},
                                          {"eos = \"nitromethane\"", 1140, 300},
                                          {"eos = \"nitromethane-products\"", 1600, 3500},
                                          {"eos = \"pbx-9502-products\"", 1900, 3000},
                                          {"eos = \"water\"", 997, 300}});
    if (reacts_ && material.keys.find("argon") != std::string::npos &&
        random_.chance(0.8)) // argon cannot react
      material = {"eos = \"nitromethane\"", 1700, 2500};
    std::optional<ReactionText> reaction;
    if (reacts_)
      reaction.emplace(random_);
    if (reaction && reaction->product() == "ideal-gas" && material.keys.find("m0") == std::string::npos)
      material.keys += "\nm0 = \"39.948 u\"";
    double const rho = material.rho * (random_.chance(0.8) ? between(0.95, 1.1) : between(0.3, 1.6));
    double const K = any_between(5, 5000);
    std::string text =
        fmt::format("title = \"driven\"\nunits = \"SI\"\n[fluid]\n{}\nrho = \"{:.6g} kg/m^3\"\n"
                    "T = \"{:.6g} K\"\n[particles]\nK = {:.4g}\ndensity = \"{}\"\n",
                    material.keys, rho, material.T * between(0.8, 1.5), K,
                    random_.of<std::string>({"plain", "plain", "glass"}));
    bool const quiet = random_.chance(0.1);
    text += particles() + box("{:.6g} m/s", any_between(50, 1e4), "{:.6g} s", any_between(1e-14, 1e-11));
    text += fmt::format("[transport]\neta = \"{:.4g} Pa*s\"\n", any_between(1e-5, 1e-2));
    if (random_.chance(0.3))
      text += fmt::format("kappa = \"{:.4g} W/(m*K)\"\n", any_between(1e-3, 1));
    if (reaction)
      text += reaction->text();
    return text + scheme("sdpd", quiet, any_between(0.002, 0.08)) + run() +
           regions(rho, " kg/m^3", any_between(50, 1e4), " m/s");
  }

  std::string soft(std::string const& method) {
    std::string text = fmt::format(
        "title = \"driven\"\nunits = \"lj\"\n[method]\nname = \"{}\"\n[fluid]\nrho = {:.4g}\nT = {:.4g}\n",
        method, between(2, 5), between(0.5, 2));
    text += "[particles]\nmass = 1\n" + particles() +
            box("{:.6g}", any_between(0.05, 50), "{:.6g}", any_between(0.01, 5));
    text += random_.of<std::string>({"[potential]\nname = \"soft\"\na = 25\ncutoff = 1\n",
                                     "[potential]\nname = \"lj\"\nepsilon = 1\nsigma = 0.5\ncutoff = 1\n",
                                     "[potential]\nname = \"wca\"\nepsilon = 1\nsigma = 0.6\n", ""});
    text += fmt::format("[friction]\ngamma_par = {:.4g}\ngamma_perp = {:.4g}\ncutoff = 1\n",
                        any_between(0.5, 50), random_.chance(0.5) ? 0 : any_between(0.1, 10));
    if (method == "dpde")
      text += fmt::format("[internal_energy]\nheat_capacity = {:.4g}\n", any_between(3, 1000));
    if (method == "dpde" && random_.chance(0.3))
      text += fmt::format("[conduction]\nkappa = {:.4g}\n", any_between(0.01, 5));
    return text + scheme(method, false, any_between(0.001, 0.04)) + run() +
           regions(3, "", any_between(0.05, 50), "");
  }

  std::string particles() {
    return fmt::format("N = {}\ndisorder = {}\n", across_ * across_ * along_,
                       random_.of<std::string>({"0", "0.1", "0.25"}));
  }

  std::string box(fmt::format_string<double&> velocity, double v, fmt::format_string<double&> time,
                  double ramp) {
    std::array<std::size_t, 3> lattice{across_, across_, across_};
    lattice.at(axis_) = along_;
    std::array<std::string, 3> faces{"periodic", "periodic", "periodic"};
    faces.at(axis_) = random_.chance(0.75) ? "walls" : "open";
    for (std::size_t d = 0; d < 3; ++d)
      if (d != axis_ && random_.chance(0.3))
        faces.at(d) = random_.chance(0.5) ? "open" : "walls";
    std::string text = fmt::format("[box]\nlattice = [{}, {}, {}]\nx = \"{}\"\ny = \"{}\"\nz = \"{}\"\n",
                                   lattice[0], lattice[1], lattice[2], faces[0], faces[1], faces[2]);
    auto const quote = [&](std::string const& value) {
      return value.find(' ') == std::string::npos ? value : '"' + value + '"';
    };
    if (faces.at(axis_) == "walls" && random_.chance(0.85)) {
      double along = random_.chance(0.8) ? v : -v;
      text += fmt::format("moving = \"{}\"\n", "xyz"[axis_]);
      if (double none = 0, later = 2 * ramp; random_.chance(0.2))
        return text + fmt::format("piston_times = [{}, {}, {}]\npiston_velocities = [{}, {}, {}]\n",
                                  quote(fmt::format(time, none)), quote(fmt::format(time, ramp)),
                                  quote(fmt::format(time, later)), quote(fmt::format(velocity, none)),
                                  quote(fmt::format(velocity, along)), quote(fmt::format(velocity, none)));
      text += "piston = " + quote(fmt::format(velocity, along)) + "\n";
      if (double none = 0; random_.chance(0.6))
        text +=
            "ramp = " + quote(random_.chance(0.3) ? fmt::format(time, none) : fmt::format(time, ramp)) + "\n";
    }
    return text;
  }

  std::string scheme(std::string const& method, bool quiet, double dt) {
    using Names = std::vector<std::string>;
    Names const suited = method == "sdpd"
                             ? Names{"ssa", "ams", "ems", "ser", "ser-implicit", "hybrid", "entropy"}
                         : method == "dpde" ? Names{"ssa", "ams", "ems", "ser", "ser-implicit", "hybrid"}
                                            : Names{"ssa", "ser", "hybrid", "lowe-andersen"};
    auto const name = random_.of(random_.chance(0.95) ? suited : sdpd::pair_integrator_names());
    std::string text =
        fmt::format("[scheme]\nname = \"{}\"\ndt = {:.4g}\nsplitting = \"{}\"\nconservative = \"{}\"\n", name,
                    dt, random_.of<std::string>({"lie-trotter", "strang"}),
                    random_.of<std::string>({"verlet", "verlet", "mclachlan", "position-verlet"}));
    if (random_.chance(0.2))
      text += "fluctuate_every = 3\n";
    if (method != "dpd" && random_.chance(0.15))
      text += "energy = \"kept\"\n";
    return text + (quiet ? "noise = \"off\"\n" : "");
  }

  std::string run() {
    std::string const measured =
        reacts_ && random_.chance(0.3) ? "[series]\nevery = 4\n[histogram]\nevery = 32\n" : "";
    return measured +
           fmt::format(
               "[run]\nequilibrate = {}\nsteps = {}\nsample_every = 2\ncheckpoint_every = 0\nseed = {}\n"
               "[profile]\naxis = \"{}\"\nbins = 10\nevery = 20\n",
               has_regions_ ? "0" : random_.of<std::string>({"0", "20", "60"}), 64 + 20 * random_.below(6),
               1 + random_.below(1000), "xyz"[axis_]);
  }

  /// Parts of the box that begin otherwise: other densities, in motion, or vacuum.
  std::string regions(double rho, std::string const& of_density, double v, std::string const& of_velocity) {
    std::string text;
    auto const quote = [](double value, std::string const& unit) {
      return unit.empty() ? fmt::format("{:.4g}", value) : fmt::format("\"{:.4g}{}\"", value, unit);
    };
    for (std::size_t k = 0; has_regions_ && k < 1 + random_.below(2); ++k) {
      text +=
          fmt::format("[[region]]\nshape = \"slab\"\naxis = \"{}\"\nfrom = \"{:.4g} %\"\nto = \"{:.4g} %\"\n",
                      "xyz"[axis_], between(-10, 60), between(40, 110));
      if (random_.chance(0.3)) {
        text += "fill = \"vacuum\"\n";
        continue;
      }
      if (random_.chance(0.7))
        text += "rho = " + quote(rho * any_between(0.3, 1.5), of_density) + "\n";
      if (random_.chance(0.7))
        text += fmt::format("velocity = [{0}, {0}, {0}]\n", quote(random_.chance(0.5) ? v : -v, of_velocity));
      text += fmt::format("lattice = \"{}\"\n", random_.of<std::string>({"cubic", "fcc", "random"}));
      if (reacts_ && random_.chance(0.7))
        text += fmt::format("progress = {}\n", ReactionText::progress(random_));
    }
    return text;
  }

  Random& random_;
  std::size_t across_, along_, axis_;
  bool has_regions_, reacts_;
};

/// What is wrong with the end of a run of such a scene, by its status and what it printed, or nothing: it
/// ends well, or by 2 with the key, or by 3 with the key of a state that its model does not have or step,
/// time step and cause (and the particle, where it is one that ends it; no time step while it comes to
/// equilibrium), or where nothing drives it with the files of a whole run whose state is not the one asked
/// for.
inline std::string fault_of_driven(int status, std::string const& printed) {
  static std::regex const key(R"([a-z_]+\.([0-9]+\.)?[A-Za-z_0-9]+ = )"),
      cause(R"(((particle \d+ at )?step \d+ \(dt = [0-9.e+-]+ reduced\): .{20})"
            R"(|step \d+: while the system came to equilibrium, .{20})"
            R"(|files of the run are written into .*, but its state is not the scene's))");
  if (status == 3 && !std::regex_search(printed, cause) && !std::regex_search(printed, key))
    return "ends with 3 and does not say where and why";
  if (status == 2 && !std::regex_search(printed, key))
    return "refuses and names no key";
  return status == 0 || status == 2 || status == 3 ? "" : fmt::format("ends with status {}", status);
}

} // namespace mesobridge::fuzz
