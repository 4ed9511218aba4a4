#include "workflows/scene/keys.hpp"
#include "md/error.hpp"
#include "sdpd/kernel/list.hpp"
#include <sstream>
#include <toml++/toml.h>

namespace mesobridge::workflows {

namespace {

constexpr Range positive{.min = 0, .open = true};
constexpr Range not_negative{.min = 0};
constexpr Range at_least_one{.min = 1};

/// Builds one line of the table: what is not said stays at SceneKey's default.
struct Line {
  SceneKey key;
  Line(std::string section, std::string name, std::function<Slot(Scene&)> slot, std::string meaning) {
    key.section = std::move(section);
    key.name = std::move(name);
    key.slot = std::move(slot);
    key.meaning = std::move(meaning);
  }
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
    std::string operator()(TimeStep*) const { return "a number"; }
    std::string operator()(UnitSystem*) const { return "a text"; }
  };
  Scene scene;
  return std::visit(Namer{}, key.slot(scene));
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

std::string SceneKey::allowed(UnitSystem units) const {
  if (!choices.empty()) {
    std::vector<std::string> words;
    for (auto const& choice : choices)
      words.push_back("\"" + choice + "\"");
    return fmt::format("one of {}", fmt::join(words, ", "));
  }
  Scene scene;
  bool const time_step = std::holds_alternative<TimeStep*>(slot(scene));
  auto text = type_name(*this);
  if (auto const limits = range.text(); !limits.empty())
    text += " " + limits;
  if (!dimension || units == UnitSystem::lj)
    return text;
  auto const with_unit = fmt::format("text with a unit ({})", allowed_units(*dimension));
  return time_step ? text + ", or such a number as " + with_unit : text + " as " + with_unit;
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
          "fluid", "eos", [](Scene& s) { return &s.fluid.eos; },
          "a name of `eos list` (argon, tin, lj ...), or the path of a fitted model, seen from the scene's "
          "folder")
          .required(),
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
          .quantity(Dimension::mass, positive),
      Line(
          "fluid", "centre_of_mass", [](Scene& s) { return &s.fluid.centre_of_mass; },
          "free: the particles' equation of state is the bulk's less what their moving centres of mass "
          "carry, "
          "so that totals do not depend on K; bulk: it is the bulk's")
          .choices({"free", "bulk"}),

      Line(
          "particles", "N", [](Scene& s) { return &s.particles.N; }, "how many particles")
          .required()
          .in(at_least_one),
      Line(
          "particles", "K", [](Scene& s) { return &s.particles.K; }, "size: molecules in one particle")
          .required()
          .in(at_least_one),
      Line(
          "particles", "kernel", [](Scene& s) { return &s.particles.kernel; }, "smoothing kernel")
          .choices(sdpd::kernel_names()),
      Line(
          "particles", "h_factor", [](Scene& s) { return &s.particles.h_factor; },
          "support of the kernel in mean spacings, h = h_factor (m/rho)^(1/3)")
          .in({.min = 1, .max = 10}),
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
          .choices({"plain", "glass", "given", "calibrated", "calibrated-response"}),
      Line(
          "particles", "density_scale", [](Scene& s) { return &s.particles.density_scale; },
          "c; with density = given or calibrated")
          .in({.min = 0, .open = true, .max = 10}),
      Line(
          "particles", "density_self", [](Scene& s) { return &s.particles.density_self; },
          "eps, between -c and c; with density = given or calibrated")
          .in({.min = -10, .max = 10}),
      Line(
          "particles", "calibration_steps", [](Scene& s) { return &s.particles.calibration_steps; },
          "steps of a calibration, of at most about 1000 particles")
          .in({.min = 200, .max = 1e9}),

      Line(
          "transport", "eta", [](Scene& s) { return &s.transport.eta; }, "shear viscosity")
          .required()
          .quantity(Dimension::viscosity, positive),
      Line(
          "transport", "zeta", [](Scene& s) { return &s.transport.zeta; },
          "bulk viscosity, less than 5 eta / 3")
          .quantity(Dimension::viscosity, not_negative),
      Line(
          "transport", "kappa", [](Scene& s) { return &s.transport.kappa; },
          "thermal conductivity; 0: particles exchange heat by friction alone")
          .quantity(Dimension::conductivity, not_negative),

      Line(
          "scheme", "name", [](Scene& s) { return &s.scheme.name; },
          "what is done with the fluctuation and dissipation of a pair: made (ssa), not made when an energy "
          "leaves "
          "the equation of state (ams), put to a Metropolis test too (ems), or "
          "all pairs at once, for short time steps (ser)")
          .choices({"ssa", "ams", "ems", "ser"}),
      Line(
          "scheme", "dt", [](Scene& s) { return &s.scheme.dt; },
          "time step: a plain number is in the reduced time unit of size K (theory, Eq. (2.20))")
          .required()
          .quantity(Dimension::time, positive),
      Line(
          "scheme", "splitting", [](Scene& s) { return &s.scheme.splitting; },
          "a conservative step, then fluctuation and dissipation (lie-trotter), or half of the latter on "
          "either side (strang)")
          .choices({"lie-trotter", "strang"}),
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
          .choices({"on", "off"}),

      Line(
          "run", "equilibrate", [](Scene& s) { return &s.run.equilibrate; }, "steps before the first sample")
          .in(not_negative),
      Line(
          "run", "steps", [](Scene& s) { return &s.run.steps; }, "steps that are sampled")
          .required()
          .in(at_least_one),
      Line(
          "run", "sample_every", [](Scene& s) { return &s.run.sample_every; }, "steps between samples")
          .in(at_least_one),
      Line(
          "run", "trajectory_every", [](Scene& s) { return &s.run.trajectory_every; },
          "steps between trajectory frames; 0: none")
          .in(not_negative),
      Line(
          "run", "checkpoint_every", [](Scene& s) { return &s.run.checkpoint_every; },
          "steps between checkpoints; 0: only when interrupted")
          .in(not_negative),
      Line(
          "run", "seed", [](Scene& s) { return &s.run.seed; }, "seed of all random numbers")
          .in(not_negative),

      Line(
          "output", "directory", [](Scene& s) { return &s.output.directory; },
          "where to write if -o is not given; default out/ and the scene's name"),
  };
  return keys;
}

std::optional<std::string> value_text(SceneKey const& key, Scene const& scene) {
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
    Text operator()(TimeStep const* dt) const {
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
    auto const value = key.required ? std::nullopt : value_text(key, Scene{});
    text += (value ? "; default " + *value : "") + "\n";
  }
  return text;
}

} // namespace mesobridge::workflows
