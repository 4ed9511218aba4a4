#include "workflows/scene/keys.hpp"
#include "md/error.hpp"
#include "sdpd/kernel/list.hpp"
#include "sdpd/scheme/list.hpp"
#include "workflows/scene/quantities.hpp"
#include <algorithm>
#include <sstream>
#include <toml++/toml.h>

namespace mesobridge::workflows {

namespace {

constexpr Range positive{.min = 0, .open = true};
constexpr Range not_negative{.min = 0};
constexpr Range at_least_one{.min = 1};

std::vector<std::string> const sdpd_only{"sdpd"}, pair_methods{"dpde", "dpd"};

/// Builds one line of the table: what is not said stays at SceneKey's default.
struct Line {
  SceneKey key;
  Line(std::string section, std::string name, std::function<Slot(Scene&)> slot, std::string meaning) {
    key.section = std::move(section);
    key.name = std::move(name);
    key.slot = std::move(slot);
    key.meaning = std::move(meaning);
  }
  Line of(std::vector<std::string> methods) && { return key.methods = std::move(methods), std::move(*this); }
  Line required() && { return key.required = true, std::move(*this); }
  Line choices(std::vector<std::string> c) && { return key.choices = std::move(c), std::move(*this); }
  Line in(Range range) && { return key.range = range, std::move(*this); }
  Line quantity(Dimension dimension, Range range) && {
    key.dimension = dimension;
    key.range = range;
    return std::move(*this);
  }
  operator SceneKey() && { return std::move(key); }
};

std::string type_name(SceneKey const& key) {
  struct Namer {
    std::string operator()(std::string*) const { return "a text"; }
    std::string operator()(std::optional<std::string>*) const { return "a text"; }
    std::string operator()(std::int64_t*) const { return "an integer"; }
    std::string operator()(double*) const { return "a number"; }
    std::string operator()(std::optional<double>*) const { return "a number"; }
    std::string operator()(std::vector<std::string>*) const { return "a list of texts"; }
    std::string operator()(TimeStep*) const { return "a number"; }
    std::string operator()(UnitSystem*) const { return "a text"; }
  };
  Scene scene;
  return std::visit(Namer{}, key.slot(scene));
}

std::string pair_scheme_summaries() {
  std::vector<std::string> words;
  for (auto const& scheme : sdpd::pair_schemes())
    words.push_back(scheme.name + ": " + scheme.summary);
  return fmt::format("{}", fmt::join(words, "; "));
}

std::string conservative_summaries() {
  std::vector<std::string> words;
  for (auto const& integrator : sdpd::conservative_integrators())
    words.push_back(integrator.name + ": " + integrator.summary);
  return fmt::format("{}", fmt::join(words, "; "));
}

std::string quoted(std::string const& text) {
  std::ostringstream out;
  out << toml::toml_formatter(toml::value<std::string>(text), toml::format_flags::none); // in double quotes
  return out.str();
}

} // namespace

bool Range::contains(double value) const {
  return std::isfinite(value) && (open ? value > min : value >= min) && value <= max;
}

std::string Range::text() const {
  bool const below = std::isfinite(min), above = std::isfinite(max);
  if (below && above)
    return open ? fmt::format("> {} and <= {}", min, max) : fmt::format("from {} to {}", min, max);
  if (below)
    return fmt::format("{} {}", open ? ">" : ">=", min);
  return above ? fmt::format("<= {}", max) : "";
}

bool SceneKey::belongs_to(std::string const& method) const {
  return methods.empty() || std::ranges::find(methods, method) != methods.end();
}

bool SceneKey::is_list() const {
  Scene scene;
  return std::holds_alternative<std::vector<std::string>*>(slot(scene));
}

std::string SceneKey::allowed(UnitSystem units) const {
  if (!choices.empty()) {
    std::vector<std::string> words;
    for (auto const& choice : choices)
      words.push_back("\"" + choice + "\"");
    return fmt::format("{} {}", is_list() ? "a list of some of" : "one of", fmt::join(words, ", "));
  }
  Scene scene;
  bool const time_step = std::holds_alternative<TimeStep*>(slot(scene));
  auto text = type_name(*this);
  if (auto const limits = range.text(); !limits.empty())
    text += " " + limits;
  if (!dimension || units == UnitSystem::lj)
    return text;
  auto const with_unit = fmt::format("text with a unit ({})", allowed_units(*dimension));
  return time_step ? text + ", or such a number as " + with_unit + ", or \"auto\""
                   : text + " as " + with_unit;
}

std::vector<SceneKey> const& scene_keys() {
  static std::vector<SceneKey> const keys{
      Line(
          "", "title", [](Scene& s) { return &s.title; }, "a name for people")
          .required(),
      Line(
          "", "units", [](Scene& s) { return &s.units; },
          "SI: quantities are texts with a unit; lj: plain numbers in Lennard-Jones units")
          .choices({"SI", "lj"}),

      Line(
          "method", "name", [](Scene& s) { return &s.method.name; },
          "sdpd: particles of fluid with an equation of state; dpde: soft particles with internal energies; "
          "dpd: "
          "soft particles at a set temperature")
          .choices({"sdpd", "dpde", "dpd"}),

      Line(
          "fluid", "eos", [](Scene& s) { return &s.fluid.eos; },
          "a name of `eos list` (argon, tin, lj ...), or the path of a fitted model, seen from the scene's "
          "folder")
          .required()
          .of(sdpd_only),
      Line(
          "fluid", "rho", [](Scene& s) { return &s.fluid.rho; }, "mean density")
          .required()
          .quantity(Dimension::density, positive),
      Line(
          "fluid", "T", [](Scene& s) { return &s.fluid.T; }, "temperature")
          .required()
          .quantity(Dimension::temperature, positive),
      Line(
          "fluid", "m0", [](Scene& s) { return &s.fluid.m0; }, "mass of one molecule; ideal-gas only")
          .quantity(Dimension::mass, positive)
          .of(sdpd_only),
      Line(
          "fluid", "centre_of_mass", [](Scene& s) { return &s.fluid.centre_of_mass; },
          "free: the particles' equation of state is the bulk's less what their moving centres of mass "
          "carry, "
          "so that totals do not depend on K; bulk: it is the bulk's")
          .choices({"free", "bulk"})
          .of(sdpd_only),

      Line(
          "particles", "N", [](Scene& s) { return &s.particles.N; }, "how many particles")
          .required()
          .in(at_least_one),
      Line(
          "particles", "K", [](Scene& s) { return &s.particles.K; }, "size: molecules in one particle")
          .required()
          .in(at_least_one)
          .of(sdpd_only),
      Line(
          "particles", "kernel", [](Scene& s) { return &s.particles.kernel; }, "smoothing kernel")
          .choices(sdpd::kernel_names())
          .of(sdpd_only),
      Line(
          "particles", "h_factor", [](Scene& s) { return &s.particles.h_factor; },
          "support of the kernel in mean spacings, h = h_factor (m/rho)^(1/3)")
          .in({.min = 1, .max = 10})
          .of(sdpd_only),
      Line(
          "particles", "disorder", [](Scene& s) { return &s.particles.disorder; },
          "standard deviation of the initial displacements from a cubic lattice, in its spacings")
          .in({.min = 0, .max = 0.5}),
      Line(
          "particles", "density", [](Scene& s) { return &s.particles.density; },
          "constants c, eps of rho_i = c sum_j m_j W_ij - eps m_i W_ii(0): 1 and 0 (plain); those of a "
          "glass; "
          "given by the next two keys; or calibrated: found by a short run of this fluid and size, so that "
          "its "
          "mean density and pressure are those of the equation of state (calibrated-response: so that its "
          "mean "
          "density is, and follows a compression; for fluids almost without pressure), and written into the "
          "next two keys. It is not repeated when they are there")
          .choices({"plain", "glass", "given", "calibrated", "calibrated-response"})
          .of(sdpd_only),
      Line(
          "particles", "density_scale", [](Scene& s) { return &s.particles.density_scale; },
          "c; with density = given or calibrated")
          .in({.min = 0, .open = true, .max = 10})
          .of(sdpd_only),
      Line(
          "particles", "density_self", [](Scene& s) { return &s.particles.density_self; },
          "eps, between -c and c; with density = given or calibrated")
          .in({.min = -10, .max = 10})
          .of(sdpd_only),
      Line(
          "particles", "calibration_steps", [](Scene& s) { return &s.particles.calibration_steps; },
          "steps of a calibration, of at most about 1000 particles")
          .in({.min = 200, .max = 1e9})
          .of(sdpd_only),

      Line(
          "particles", "mass", [](Scene& s) { return &s.particles.mass; }, "mass of one particle")
          .required()
          .quantity(Dimension::mass, positive)
          .of(pair_methods),

      Line(
          "potential", "name", [](Scene& s) { return &s.potential.name; },
          "potential between two particles: none; soft, the force a (1 - r/cutoff); lj, cut and shifted; "
          "wca; "
          "exp-6 (Buckingham), which refuses pairs inside its maximum; table, a CSV file")
          .choices({"none", "soft", "lj", "wca", "exp-6", "table"})
          .of(pair_methods),
      Line(
          "potential", "a", [](Scene& s) { return &s.potential.a; }, "largest force; soft")
          .quantity(Dimension::force, not_negative)
          .of(pair_methods),
      Line(
          "potential", "epsilon", [](Scene& s) { return &s.potential.epsilon; },
          "depth of the minimum; lj, wca (before its shift), exp-6")
          .quantity(Dimension::energy, positive)
          .of(pair_methods),
      Line(
          "potential", "sigma", [](Scene& s) { return &s.potential.sigma; }, "where it is zero; lj, wca")
          .quantity(Dimension::length, positive)
          .of(pair_methods),
      Line(
          "potential", "r_m", [](Scene& s) { return &s.potential.r_m; }, "distance of the minimum; exp-6")
          .quantity(Dimension::length, positive)
          .of(pair_methods),
      Line(
          "potential", "alpha", [](Scene& s) { return &s.potential.alpha; }, "steepness; exp-6")
          .in({.min = 7, .open = true, .max = 100})
          .of(pair_methods),
      Line(
          "potential", "cutoff", [](Scene& s) { return &s.potential.cutoff; },
          "where the potential ends and is shifted to zero; soft, lj, exp-6")
          .quantity(Dimension::length, positive)
          .of(pair_methods),
      Line(
          "potential", "file", [](Scene& s) { return &s.potential.file; },
          "CSV with columns r,u and perhaps the force f (SI: r_m,u_J,f_N); table")
          .of(pair_methods),

      Line(
          "friction", "gamma_par", [](Scene& s) { return &s.friction.gamma_par; },
          "friction along the line of centres at contact: gamma (1 - r/cutoff)^exponent, at the set "
          "temperature")
          .quantity(Dimension::friction, not_negative)
          .of(pair_methods),
      Line(
          "friction", "gamma_perp", [](Scene& s) { return &s.friction.gamma_perp; },
          "the same across the line of centres")
          .quantity(Dimension::friction, not_negative)
          .of(pair_methods),
      Line(
          "friction", "cutoff", [](Scene& s) { return &s.friction.cutoff; },
          "where the friction ends; the reduced unit of length")
          .quantity(Dimension::length, positive)
          .of(pair_methods),
      Line(
          "friction", "exponent", [](Scene& s) { return &s.friction.exponent; },
          "of the weight; 2 is customary")
          .in({.min = 0, .open = true, .max = 20})
          .of(pair_methods),
      Line(
          "friction", "file", [](Scene& s) { return &s.friction.file; },
          "CSV with columns r,gamma_par and perhaps gamma_perp (SI: r_m,gamma_par_kg_s,gamma_perp_kg_s), in "
          "place of the above")
          .of(pair_methods),

      Line(
          "internal_energy", "heat_capacity", [](Scene& s) { return &s.internal_energy.heat_capacity; },
          "of a particle, in k_B, constant")
          .in(positive)
          .of({"dpde"}),
      Line(
          "internal_energy", "model", [](Scene& s) { return &s.internal_energy.model; },
          "or the path of a model file with a table of C(T) or S(eps)")
          .of({"dpde"}),

      Line(
          "transport", "eta", [](Scene& s) { return &s.transport.eta; }, "shear viscosity")
          .required()
          .quantity(Dimension::viscosity, positive)
          .of(sdpd_only),
      Line(
          "transport", "zeta", [](Scene& s) { return &s.transport.zeta; },
          "bulk viscosity, less than 5 eta / 3")
          .quantity(Dimension::viscosity, not_negative)
          .of(sdpd_only),
      Line(
          "transport", "kappa", [](Scene& s) { return &s.transport.kappa; },
          "thermal conductivity; 0: particles exchange heat by friction alone")
          .quantity(Dimension::conductivity, not_negative)
          .of(sdpd_only),

      Line(
          "scheme", "name", [](Scene& s) { return &s.scheme.name; },
          "what is done with the fluctuation and dissipation of a pair: " + pair_scheme_summaries())
          .choices(sdpd::pair_scheme_names()),
      Line(
          "scheme", "dt", [](Scene& s) { return &s.scheme.dt; },
          "time step: a plain number is in the reduced time unit of size K (theory, Eq. (2.20)); \"auto\": "
          "found "
          "by a short study for the wanted drift or bias")
          .required()
          .quantity(Dimension::time, positive),
      Line(
          "scheme", "drift", [](Scene& s) { return &s.scheme.drift; },
          "with dt = \"auto\": wanted rate of the relative energy error, such as \"1e-6/ps\" (a plain number "
          "per unit of time when units = \"lj\")"),
      Line(
          "scheme", "bias", [](Scene& s) { return &s.scheme.bias; },
          "with dt = \"auto\": wanted bias of T_kin, T_int and P, such as \"0.5%\""),
      Line(
          "scheme", "dt_chosen_for", [](Scene& s) { return &s.scheme.dt_chosen_for; },
          "written by the program: the wish that dt was chosen for"),
      Line(
          "scheme", "splitting", [](Scene& s) { return &s.scheme.splitting; },
          "a conservative step, then fluctuation and dissipation (lie-trotter), or half of the latter on "
          "either side (strang)")
          .choices({"lie-trotter", "strang"}),
      Line(
          "scheme", "conservative", [](Scene& s) { return &s.scheme.conservative; },
          "integrator of the conservative forces: " + conservative_summaries())
          .choices(sdpd::conservative_names()),
      Line(
          "scheme", "fluctuate_every", [](Scene& s) { return &s.scheme.fluctuate_every; },
          "conservative steps for one of fluctuation and dissipation (multiple time steps)")
          .in({.min = 1, .max = 1e6}),
      Line(
          "scheme", "energy", [](Scene& s) { return &s.scheme.energy; },
          "free, or kept: what the time step loses is given back to the internal energies")
          .choices({"free", "kept"}),

      Line(
          "scheme", "noise", [](Scene& s) { return &s.scheme.noise; },
          "on, or off: viscous smoothed particle hydrodynamics, which starts at rest")
          .choices({"on", "off"})
          .of(sdpd_only),

      Line(
          "run", "equilibrate", [](Scene& s) { return &s.run.equilibrate; }, "steps before the first sample")
          .in(not_negative),
      Line(
          "run", "thermostat", [](Scene& s) { return &s.run.thermostat; },
          "of the equilibration: momenta and heat set now and then (rescale), or a Langevin bath for the "
          "first "
          "half of its steps (langevin)")
          .choices({"rescale", "langevin"}),
      Line(
          "run", "bath_rate", [](Scene& s) { return &s.run.bath_rate; },
          "rate at which the Langevin bath takes hold, per reduced time unit of size K")
          .in(positive),
      Line(
          "run", "steps", [](Scene& s) { return &s.run.steps; }, "steps that are sampled")
          .required()
          .in(at_least_one),
      Line(
          "run", "sample_every", [](Scene& s) { return &s.run.sample_every; }, "steps between samples")
          .in(at_least_one),
      Line(
          "run", "instant_every", [](Scene& s) { return &s.run.instant_every; },
          "steps between the instants whose particles' energies, densities and pressures make the "
          "distributions; "
          "0: 40 instants")
          .in(not_negative),
      Line(
          "run", "trajectory_every", [](Scene& s) { return &s.run.trajectory_every; },
          "steps between frames of trajectory.h5 (H5MD, for MDAnalysis and VMD); 0: none")
          .in(not_negative),
      Line(
          "run", "vtkhdf_every", [](Scene& s) { return &s.run.vtkhdf_every; },
          "steps between frames of trajectory.vtkhdf (for ParaView 5.12 and later); 0: none")
          .in(not_negative),
      Line(
          "run", "xyz_every", [](Scene& s) { return &s.run.xyz_every; },
          "steps between frames of trajectory.xyz (extended XYZ, for OVITO and ASE); 0: none")
          .in(not_negative),
      Line(
          "run", "checkpoint_every", [](Scene& s) { return &s.run.checkpoint_every; },
          "steps between checkpoints; 0: only when interrupted")
          .in(not_negative),
      Line(
          "run", "seed", [](Scene& s) { return &s.run.seed; }, "seed of all random numbers")
          .in(not_negative),

      Line(
          "profile", "axis", [](Scene& s) { return &s.profile.axis; },
          "direction of the profile: its slices are perpendicular to it")
          .choices({"x", "y", "z"}),
      Line(
          "profile", "bins", [](Scene& s) { return &s.profile.bins; }, "slices of equal width")
          .in({.min = 1, .max = 1e6}),
      Line(
          "profile", "every", [](Scene& s) { return &s.profile.every; },
          "steps between profiles, of one instant each, under `profile` of run.h5; 0: none")
          .in(not_negative),
      Line(
          "profile", "quantities", [](Scene& s) { return &s.profile.quantities; },
          "means over the particles of a slice: rho (dpde, dpd: mass per volume), velocity, T_kin (of the "
          "motion "
          "about that velocity), T_int (not dpd), P_internal (of the particles' own pressures, sdpd), P "
          "(with what "
          "the moving particles carry, sdpd). []: all that the method has")
          .choices(names_of(profile_quantities())),
      Line(
          "histogram", "bins", [](Scene& s) { return &s.histogram.bins; }, "of equal width")
          .in({.min = 1, .max = 1e6}),
      Line(
          "histogram", "every", [](Scene& s) { return &s.histogram.every; },
          "steps between histograms over all particles, of one instant each, under `histogram` of run.h5; 0: "
          "none")
          .in(not_negative),
      Line(
          "histogram", "reach", [](Scene& s) { return &s.histogram.reach; },
          "bins reach from the mean of the first histogram's particles so many of their standard deviations "
          "either "
          "way; what lies beyond is counted as well")
          .in({.min = 0, .open = true, .max = 1e6}),
      Line(
          "histogram", "quantities", [](Scene& s) { return &s.histogram.quantities; },
          "of the particles: eps and T (not dpd), rho and P (sdpd). []: all that the method has")
          .choices(names_of(histogram_quantities())),

      Line(
          "output", "directory", [](Scene& s) { return &s.output.directory; },
          "where to write if -o is not given; default out/ and the scene's name"),
  };
  return keys;
}

std::optional<std::string> value_text(SceneKey const& key, Scene const& scene) {
  if (!key.belongs_to(scene.method.name))
    return std::nullopt;
  struct Writer {
    SceneKey const& key;
    bool si;
    using Text = std::optional<std::string>;
    Text number(double value) const {
      return key.dimension && si ? quoted(quantity_text(value, *key.dimension)) : fmt::format("{}", value);
    }
    Text operator()(std::string const* text) const { return quoted(*text); }
    Text operator()(std::optional<std::string> const* text) const {
      return *text ? Text(quoted(**text)) : Text();
    }
    Text operator()(std::int64_t const* value) const { return fmt::format("{}", *value); }
    Text operator()(double const* value) const { return number(*value); }
    Text operator()(std::optional<double> const* value) const { return *value ? number(**value) : Text(); }
    Text operator()(std::vector<std::string> const* texts) const {
      std::vector<std::string> words;
      for (auto const& text : *texts)
        words.push_back(quoted(text));
      return fmt::format("[{}]", fmt::join(words, ", "));
    }
    Text operator()(TimeStep const* dt) const {
      if (dt->automatic)
        return "\"auto\"";
      return dt->reduced ? fmt::format("{}", dt->value) : number(dt->value);
    }
    Text operator()(UnitSystem const* units) const { return *units == UnitSystem::SI ? "\"SI\"" : "\"lj\""; }
  };
  auto copy = scene; // slots point into a scene that may be written to
  return std::visit(Writer{key, scene.units == UnitSystem::SI}, key.slot(copy));
}

std::string resolved_toml(Scene const& scene) {
  std::string text, section;
  for (auto const& key : scene_keys()) {
    auto const value = value_text(key, scene);
    if (!value)
      continue;
    if (key.section != section) {
      section = key.section;
      text += "\n[" + section + "]\n";
    }
    text += key.name + " = " + *value + "\n";
  }
  return text;
}

std::string scene_keys_text() {
  std::string text = "Keys of a scene (* must be given):\n", section;
  for (auto const& key : scene_keys()) {
    if (key.section != section) {
      section = key.section;
      text += "\n[" + section + "]\n";
    }
    text += fmt::format("{}{:<17} {}\n", key.required ? '*' : ' ', key.name, key.meaning);
    text += fmt::format("{:<19}{}", "", key.allowed(UnitSystem::SI));
    Scene fresh;
    if (!key.methods.empty())
      fresh.method.name = key.methods.front();
    auto const value = key.required ? std::nullopt : value_text(key, fresh);
    if (!key.methods.empty())
      text += fmt::format("; for {}", fmt::join(key.methods, ", "));
    text += (value ? "; default " + *value : "") + "\n";
  }
  return text;
}

} // namespace mesobridge::workflows
