#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace mesobridge::workflows {

enum class UnitSystem { SI, lj };

/// A time step: in the reduced time unit of size K (theory sheet, Eq. (2.20)) or in seconds.
struct TimeStep {
  double value = 0;
  bool reduced = true;

  bool operator==(TimeStep const&) const = default;
};

/// An equilibrium SDPD run as its scene file describes it. Quantities are in SI, or in Lennard-Jones units
/// when `units` says so. Plain data: what the keys mean, allow and default to stands in scene/keys.cpp.
struct Scene {
  std::string title;
  UnitSystem units = UnitSystem::SI;
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
    std::string kernel = "cubic";
    double h_factor = 2.5;
    double disorder = 0.15;
    std::string density = "plain";
    std::optional<double> density_scale, density_self;
    std::int64_t calibration_steps = 3000;
    bool operator==(Particles const&) const = default;
  } particles;
  struct Transport {
    double eta = 0, zeta = 0, kappa = 0;
    bool operator==(Transport const&) const = default;
  } transport;
  struct Scheme {
    std::string name = "ssa";
    TimeStep dt;
    std::string splitting = "lie-trotter";
    std::int64_t fluctuate_every = 1;
    std::string energy = "free";
    std::string noise = "on";
    bool operator==(Scheme const&) const = default;
  } scheme;
  struct Run {
    std::int64_t equilibrate = 0, steps = 0, sample_every = 10, trajectory_every = 0, checkpoint_every = 1000;
    std::int64_t seed = 1;
    bool operator==(Run const&) const = default;
  } run;
  struct Output {
    std::optional<std::string> directory;
    bool operator==(Output const&) const = default;
  } output;

  bool operator==(Scene const&) const = default;
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
