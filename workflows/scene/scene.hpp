#pragma once
#include "sdpd/state/particles.hpp"
#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace mesobridge::workflows {

enum class UnitSystem { SI, lj };

/// A time step: in the reduced time unit of size K (sdpd/README.md, Eq. (S1)) or in that of the scene's
/// units, seconds or Lennard-Jones times, or one that is still to be found.
struct TimeStep {
  double value = 0;
  bool reduced = true;
  bool automatic = false; ///< the value is not known yet

  bool operator==(TimeStep const&) const = default;
};

/// A place along an axis of the box: a length, or a share of the box's edge in per cent.
struct Coordinate {
  double value = 0;
  bool is_share = false;

  double of(double edge) const { return is_share ? value / 100 * edge : value; }
  bool operator==(Coordinate const&) const = default;
};

/// Numbers by the names of the parameters that some law is made of.
class ParameterValues {
 public:
  std::optional<double>& operator[](std::string_view name) {
    return values_.try_emplace(std::string(name)).first->second;
  }
  std::optional<double> operator[](std::string_view name) const {
    auto const found = values_.find(name);
    return found == values_.end() ? std::nullopt : found->second;
  }
  bool operator==(ParameterValues const& other) const {
    auto const holds = [](ParameterValues const& a, ParameterValues const& b) {
      return std::ranges::all_of(a.values_,
                                 [&](auto const& entry) { return b[entry.first] == entry.second; });
    };
    return holds(*this, other) && holds(other, *this);
  }

 private:
  std::map<std::string, std::optional<double>, std::less<>> values_;
};

/// A run of SDPD, DPDE or DPD as its scene file describes it. Quantities are in SI, or in
/// Lennard-Jones units when `units` says so. Plain data: what the keys mean, allow and default to stands in
/// scene/keys/.
struct Scene {
  std::string title;
  UnitSystem units = UnitSystem::SI;
  struct Method {
    std::string name = "sdpd";
    bool operator==(Method const&) const = default;
  } method;
  struct Fluid {
    std::string eos; ///< a name of `eos list`, or the path of a fitted model
    double rho = 0, T = 0;
    std::optional<double> m0;
    std::string centre_of_mass = "free";
    bool operator==(Fluid const&) const = default;
  } fluid;
  struct Particles {
    std::int64_t N = 0;
    double K = 0;
    std::string kernel = "wendland-c4"; ///< does not let particles pair; costs what the cubic one does
    double h_factor = 2.5;
    double disorder = 0.15;
    std::string start = "lattice";
    std::optional<std::string> model; ///< dpd, dpde: a file that says what follows and how two interact
    std::optional<double> mass;       ///< dpd, dpde
    std::string density = "auto";
    std::optional<double> density_scale, density_self;
    std::int64_t calibration_steps = 0; ///< 0: by the length of the run
    std::string density_sum = "auto";
    bool operator==(Particles const&) const = default;
  } particles;
  struct Box {
    std::vector<std::int64_t> lattice; ///< particles along x, y, z; empty: as cubic as N allows
    std::vector<double> size;          ///< edges, in place of N
    std::string x = "periodic", y = "periodic", z = "periodic";
    std::optional<double> piston, ramp; ///< velocity of the lower wall, and the time until it has it
    std::vector<double> piston_times, piston_velocities; ///< a table in place of both
    std::optional<std::string> piston_file;              ///< the same in a file
    std::optional<std::string> moving; ///< the axis whose walls move, where several have walls
    std::string slip = "free", wall_heat = "bath";
    std::optional<double> wall_temperature, wall_friction, slide, slide_ramp, body_force;
    std::int64_t waves = 0;          ///< of the body force, in the length of the box
    std::optional<std::string> flow; ///< the axis along which the upper wall slides and the body force acts
    bool operator==(Box const&) const = default;
  } box;
  struct Region { ///< a part of the box that starts otherwise than [fluid] says
    std::string name, shape, part = "inside", fill = "fluid", axis = "z", lattice = "cubic";
    std::vector<Coordinate> from, to, centre;
    std::optional<double> radius;
    std::optional<std::string> eos;
    std::optional<double> K, rho, T, mass, heat_capacity; ///< those of the fluid if not given
    std::optional<double> progress;
    std::vector<double> velocity, velocity_gradient;
    bool operator==(Region const&) const = default;
  };
  std::vector<Region> regions; ///< each takes from those before it, and all from the fluid
  struct Transport {
    double eta = 0, zeta = 0, kappa = 0;
    std::string eta_means = "pair";
    std::optional<double> eta_pairs; ///< that trials have found for eta_means = "realised"

    double friction() const { return eta_pairs.value_or(eta); } ///< the viscosity of the friction of pairs
    bool operator==(Transport const&) const = default;
  } transport;
  struct Reaction {                     ///< sdpd
    std::optional<std::string> product; ///< as fluid.eos, which is the reactant; without it nothing reacts
    std::optional<double> heat, heat_per_molecule; ///< one of the two
    std::string volumes = "additive";
    std::string kinetics = "second-order";
    ParameterValues parameters; ///< see sdpd::kinetics()
    std::string weights = "kernel", integrator = "midpoint";
    double progress = 0; ///< at the start
    bool operator==(Reaction const&) const = default;
  } reaction;
  struct Potential { ///< dpd, dpde
    std::string name = "none";
    ParameterValues parameters; ///< see sdpd::potentials()
    std::optional<std::string> file;
    bool operator==(Potential const&) const = default;
  } potential;
  struct Friction { ///< dpd, dpde
    std::optional<double> gamma_par;
    double gamma_perp = 0;
    std::optional<double> cutoff, exponent;
    std::optional<std::string> file;
    bool operator==(Friction const&) const = default;
  } friction;
  struct Conduction {                ///< dpde; the file, or the others
    std::optional<double> kappa = 0; ///< nothing: that of particles.model
    std::optional<double> cutoff, exponent;
    std::optional<std::string> file;
    bool operator==(Conduction const&) const = default;
  } conduction;
  struct InternalEnergy { ///< dpde; one of the two, or particles.model
    std::optional<double> heat_capacity;
    std::optional<std::string> model;
    bool operator==(InternalEnergy const&) const = default;
  } internal_energy;
  struct Scheme {
    std::string name = "ssa";
    TimeStep dt;
    std::string splitting = "lie-trotter";
    std::string conservative = "verlet";
    std::int64_t fluctuate_every = 1;
    std::string energy = "free";
    std::optional<std::string> drift, bias, dynamics; ///< tolerances for an automatic time step
    std::optional<std::string> dt_chosen_for;         ///< the tolerance that a chosen time step keeps
    /// Of the excess (S92), that trials of the time step have shown, and its standard error.
    std::optional<double> diffusion_share, diffusion_share_se;
    bool operator==(Scheme const&) const = default;
  } scheme;
  struct Run {
    std::int64_t equilibrate = 0, steps = 0, sample_every = 10, instant_every = 0, trajectory_every = 0,
                 vtkhdf_every = 0, xyz_every = 0, checkpoint_every = 1000;
    double checkpoint_minutes = 10;
    std::int64_t seed = 1;
    std::string thermostat = "rescale";
    double bath_rate = 1;
    bool operator==(Run const&) const = default;
  } run;
  struct Profile { ///< across the box, into run.h5
    std::string axis = "x";
    std::int64_t bins = 20, every = 0;
    std::vector<std::string> quantities; ///< empty: all that the method has
    bool operator==(Profile const&) const = default;
  } profile;
  struct Histogram { ///< of single particles' quantities, into run.h5
    std::int64_t bins = 50, every = 0;
    double reach = 8;
    std::vector<std::string> quantities; ///< empty: all that the method has
    bool operator==(Histogram const&) const = default;
  } histogram;
  struct Series { ///< of measurements beside those of every run, into run.h5
    std::int64_t every = 0;
    std::vector<std::string> quantities; ///< empty: all that the method has
    bool operator==(Series const&) const = default;
  } series;
  struct Film {                          ///< pictures of the particles of a slab, into run.h5 and the report
    std::optional<std::string> quantity; ///< whose value is the colour; none: no film
    std::int64_t every = 0;              ///< 0: six frames
    std::optional<std::string> axis;     ///< along which one looks
    std::optional<double> thickness;
    bool operator==(Film const&) const = default;
  } film;
  struct Output {
    std::optional<std::string> directory;
    bool operator==(Output const&) const = default;
  } output;

  std::vector<std::string> notes = {}; ///< what the reader of the scene is to know, such as names of before

  bool operator==(Scene const&) const = default;

  sdpd::Features features() const; ///< of the method's particles
  bool noise() const;              ///< whether the method's particles fluctuate
};

/// Reads and checks a scene file; each override is "section.key=value" and wins over the file.
/// Throws InputError that names file, line, key, value, what is allowed and, for a misspelt key, the nearest
/// one.
Scene load_scene(std::filesystem::path const& file, std::vector<std::string> const& overrides = {});

/// The same from text; `file` is only the name in messages and the folder that model paths start from.
Scene parse_scene(std::string const& text, std::filesystem::path const& file,
                  std::vector<std::string> const& overrides = {});

/// The scene as TOML with every key written out; reads back as the same scene.
std::string resolved_toml(Scene const& scene);

/// What every key means, allows and defaults to.
std::string scene_keys_text();

} // namespace mesobridge::workflows
