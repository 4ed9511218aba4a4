#include "sdpd/setup/realised_viscosity.hpp"
#include "md/error.hpp"
#include "sdpd/method/mean_field_viscosity.hpp"
#include "sdpd/setup/viscosity_floor.hpp"
#include <algorithm>

namespace mesobridge::sdpd {
namespace {

constexpr double amplitude = 0.5;                    ///< of the flow, over the thermal velocity
constexpr std::uint32_t waves_edge = 16;             ///< mean distances between particles
constexpr double short_run = 40, long_run = 200;     ///< in relaxation times of the wave, and at least
constexpr double least_short = 60, least_long = 200; ///< reduced: glassy fluids remember for longer
constexpr double equilibrium_time = 30;              ///< reduced, at least
constexpr double near = 0.1;                         ///< of the asked one, from which on runs are long
constexpr double enough = 0.025;                     ///< of the asked one
constexpr std::size_t most_trials = 16;
constexpr double farthest = 2.5; ///< factor between the friction of one trial and the next

/// Of the trials: periodic, without a lattice that could carry stress, with the heat of the flow taken out.
SimulationSettings trial_settings(SimulationSettings settings) {
  settings.lattice = viscosity_lattice(settings);
  settings.faces = {}, settings.body_force = {}, settings.layout = {};
  settings.bath_rate = 0, settings.melted = true;
  settings.scheme.keep_energy = true;
  return settings;
}

/// A line through trials, weighted by their errors.
class Line {
 public:
  void add(ViscosityTrial const& one) {
    constexpr double rough = 0.03; // errors of few independent samples are rough themselves
    double const w = 1 / (std::pow(one.realised.se, 2) + std::pow(rough * one.realised.mean, 2));
    weight_ += w, x_ += w * one.pairs, y_ += w * one.realised.mean;
    xx_ += w * one.pairs * one.pairs, xy_ += w * one.pairs * one.realised.mean;
  }
  /// The friction that has so much by it; by the slope one from the last trial where all have about the same.
  double pairs_of(double viscosity, ViscosityTrial const& last) const {
    constexpr double apart = 0.03, flattest = 0.5, steepest = 2;
    double const x = x_ / weight_, y = y_ / weight_, spread = xx_ / weight_ - x * x;
    if (!(spread > apart * apart * last.pairs * last.pairs))
      return last.pairs + viscosity - last.realised.mean;
    return x + (viscosity - y) / std::clamp((xy_ / weight_ - x * y) / spread, flattest, steepest);
  }

 private:
  double weight_ = 0, x_ = 0, y_ = 0, xx_ = 0, xy_ = 0;
};

class Search {
 public:
  Search(SimulationSettings const& settings, std::function<bool()> const& keep_going,
         std::function<void(ViscosityTrial const&)> const& on_trial)
      : settings_(trial_settings(settings)), keep_going_(keep_going), on_trial_(on_trial),
        asked_(settings.as<Sdpd>().eta) {}

  RealisedViscosity run() {
    equilibrate_fluid();
    double pairs = std::max(asked_, least_pairs());
    bool is_long = false;
    while (found_.trials.size() < most_trials) {
      auto const now = measure(pairs, is_long, 1);
      found_.trials.push_back({pairs, now.viscosity});
      if (on_trial_)
        on_trial_(found_.trials.back());
      double const off = now.viscosity.mean / asked_ - 1;
      if (is_long && std::abs(off) <= enough)
        return finished(pairs, now);
      is_long = is_long || std::abs(off) <= near;
      pairs = next(found_.trials.back());
    }
    throw PhysicsError(
        fmt::format("{} trials have not led to the viscosity {:.4g}: the last one had {:.4g} ± "
                    "{:.2g} with {:.4g} of its pairs",
                    most_trials, asked_, found_.trials.back().realised.mean, found_.trials.back().realised.se,
                    found_.trials.back().pairs));
  }

 private:
  void equilibrate_fluid() {
    double const time = std::max(equilibrium_time, 10 * relaxation_time(settings_));
    start_ = state_before_waves(settings_, time, keep_going_);
    found_.particles = settings_.particle_count(), found_.steps = start_.step;
  }

  /// (S14) asks for zeta < 5 eta/3.
  double least_pairs() const { return 0.6 * (1 + 1e-6) * settings_.as<Sdpd>().zeta; }

  MeasuredViscosity measure(double pairs, bool is_long, int waves) {
    settings_.as<Sdpd>().eta = pairs;
    ViscosityWave const wave{
        .waves = waves, .amplitude = amplitude, .expected = expected(pairs), .start = start_};
    double const relaxation = relaxation_time(settings_, wave),
                 time = is_long ? std::max(long_run * relaxation, least_long)
                                : std::max(short_run * relaxation, least_short);
    auto settings = settings_;
    settings.seed += found_.trials.size(); // noise of each trial's own
    auto const found = measure_viscosity(settings, time, keep_going_, wave);
    found_.steps += found.steps;
    return found;
  }

  /// By the trial of the nearest friction.
  double expected(double pairs) const {
    auto const mean_field = mean_field_viscosity(settings_).sum();
    if (found_.trials.empty())
      return mean_field;
    auto const& nearest = *std::ranges::min_element(
        found_.trials, {}, [&](ViscosityTrial const& one) { return std::abs(std::log(one.pairs / pairs)); });
    return nearest.realised.mean;
  }

  /// By the line through the trials about the last one, whose slope is one where friction is all; at the
  /// least viscosity where the fluid has had more than it is asked for in all trials.
  double next(ViscosityTrial const& last) const {
    constexpr double about = 0.7;
    if (std::ranges::all_of(found_.trials, [&](auto const& one) { return one.realised.mean > asked_; })) {
      auto const floor = viscosity_floor(found_.trials, least_pairs());
      refuse(floor);
      if (floor.between)
        return std::max(floor.pairs, least_pairs());
    }
    Line line;
    for (auto const& one : found_.trials)
      if (std::abs(std::log(one.pairs / last.pairs)) < about)
        line.add(one);
    double const target = line.pairs_of(asked_, last);
    return std::max(std::clamp(target, last.pairs / farthest, last.pairs * farthest), least_pairs());
  }

  void refuse(ViscosityFloor const& floor) const {
    auto const& [least, se, n_eff] = floor.realised;
    if (!(least > asked_ + 2 * se))
      return;
    auto const bulk =
        fmt::format("; less friction of pairs than {:.3g} does not go with the bulk viscosity {:.3g}",
                    least_pairs(), settings_.as<Sdpd>().zeta);
    bool const bounded = floor.pairs > 0 && floor.pairs <= least_pairs();
    throw InputError(fmt::format(
        "viscosity = {:.4g}: must be > {:.3g} ± {:.1g}, the least that this fluid has by {} trials: "
        "{:.3g} of it is the friction of pairs, the rest is carried by the motion of particles and "
        "the forces between them{}. Smaller particles (K) or more neighbours have less",
        asked_, least, se, found_.trials.size(), floor.pairs, bounded ? bulk : ""));
  }

  SimulationSettings with_pairs(double pairs) const {
    auto settings = settings_;
    settings.as<Sdpd>().eta = pairs;
    return settings;
  }

  RealisedViscosity finished(double pairs, MeasuredViscosity const& now) {
    found_.pairs = pairs, found_.realised = realised_by_line(found_.trials, pairs);
    found_.T_kin = now.T_kin, found_.amplitude = now.amplitude;
    found_.of_half_wave = measure(pairs, true, 2).viscosity;
    found_.kinetic = mean_field_viscosity(with_pairs(pairs)).kinetic;
    found_.wavelength = settings_.lattice[2];
    return std::move(found_);
  }

  SimulationSettings settings_;
  std::function<bool()> const& keep_going_;
  std::function<void(ViscosityTrial const&)> const& on_trial_;
  double asked_;
  Checkpoint start_;
  RealisedViscosity found_;
};

} // namespace

std::array<std::uint32_t, 3> viscosity_lattice(SimulationSettings const& settings) {
  constexpr double widest_skin = 0.7;
  auto const across =
      static_cast<std::uint32_t>(std::max(8.0, std::ceil(2 * (settings.range() + widest_skin))));
  return {across, across, std::max(waves_edge, across)};
}

double least_viscosity_without_structure(SimulationSettings const& settings) {
  auto const [friction, kinetic] = mean_field_viscosity(settings);
  double const zeta = settings.as<Sdpd>().zeta;
  double const product = kinetic * (friction + 0.3 * zeta); // the same for any friction
  double const best = std::max(std::sqrt(product) - 0.3 * zeta, 0.6 * zeta);
  return best + product / (best + 0.3 * zeta);
}

void check_realised_viscosity(SimulationSettings const& settings) {
  constexpr double surely = 0.8; // (S55) is right to a tenth
  require_one_species(settings, "realised viscosity");
  double const asked = settings.as<Sdpd>().eta, least = least_viscosity_without_structure(settings);
  require(asked > surely * least, "viscosity", fmt::format("{:.4g}", asked),
          fmt::format("must be > {:.3g}: so much have the friction of pairs and the motion of particles "
                      "together at least, in a fluid without structure; larger particles (K) carry less",
                      surely * least));
}

double steps_of_realised_viscosity(SimulationSettings const& settings) {
  auto const at = trial_settings(settings);
  double const relaxation = relaxation_time(at, {.expected = settings.as<Sdpd>().eta});
  constexpr double begin = 1.25, short_ones = 2, long_ones = 2.25; // as they usually are
  double const time = equilibrium_time + begin * (short_ones * std::max(short_run * relaxation, least_short) +
                                                  long_ones * std::max(long_run * relaxation, least_long));
  return time / settings.dt;
}

RealisedViscosity realise_viscosity(SimulationSettings settings, std::function<bool()> const& keep_going,
                                    std::function<void(ViscosityTrial const&)> const& on_trial) {
  check(settings);
  check_realised_viscosity(settings);
  return Search(settings, keep_going, on_trial).run();
}

} // namespace mesobridge::sdpd
