#include "sdpd/setup/trial.hpp"
#include "cg/diffusion.hpp"
#include "md/error.hpp"
#include "md/processor_clock.hpp"
#include "sdpd/observe/energy_walk.hpp"
#include "sdpd/observe/runaway.hpp"
#include "sdpd/scheme/list.hpp"
#include "sdpd/setup/equilibration.hpp"
#include <algorithm>
#include <cmath>

namespace mesobridge::sdpd {
namespace {

constexpr std::int64_t instants = 64; ///< at which the particles are looked at one by one
constexpr std::size_t stored_energies = 200;
constexpr std::size_t least_samples = 32; ///< that energy_drift takes
constexpr double most_heating = 0.02;     ///< in the set temperature, for what a drift is measured from
constexpr double walk_lag = 3; ///< reduced time: the bounded part of the energy error has forgotten itself
/// For a drift from a part of the samples: its error comes from eight segments, which must not remember each
/// other.
constexpr double least_time = 8 * 2 * walk_lag;
constexpr double longest_lag = 8;             ///< reduced time over which displacements are followed
constexpr double least_lags = 4;              ///< of them in a trial that tells its self-diffusion
constexpr std::size_t most_moves = 1U << 20U; ///< particles times frames that are remembered: 48 MB

/// A trial on its way.
class TrialRun {
 public:
  TrialRun(Trial const& trial, Checkpoint const& start)
      : trial_(trial), settings_(trial.settings), simulation_(settings_), sampler_(settings_.features()) {
    simulation_.begin_from(start);
    counts_at_start_ = simulation_.pair_counts();
  }

  TrialResult carry_out(std::function<bool(std::uint64_t)> const& keep_going) {
    try {
      advance(trial_.settle, keep_going, [] {});
      sample(keep_going);
    } catch (PhysicsError const& error) {
      return failed(error.what());
    }
    return result();
  }

 private:
  template <class F>
  void advance(std::int64_t steps, std::function<bool(std::uint64_t)> const& keep_going,
               F const& after_each) {
    for (std::int64_t k = 0; k < steps; ++k) {
      simulation_.advance(1);
      ++done_;
      if (done_ % 64 == 0 && !keep_going(done_))
        throw Interrupted("the study was stopped; what was finished is stored");
      after_each();
    }
  }

  void sample(std::function<bool(std::uint64_t)> const& keep_going) {
    std::int64_t const every_instant = std::max<std::int64_t>(1, trial_.steps / instants);
    std::int64_t k = 0;
    take_sample(0);
    heat_capacity_ = simulation_.heat_capacity();
    md::ProcessorClock const clock;
    advance(trial_.steps, keep_going, [&] {
      ++k;
      if (k % trial_.sample_every == 0)
        take_sample(static_cast<double>(k) * settings_.dt);
      if (k % every_instant == 0)
        take_instant();
    });
    seconds_ = clock.seconds();
  }

  void take_sample(double time) {
    auto const now = simulation_.observe();
    refuse_runaway(now, settings_.dt);
    sampler_.sample(now, time);
    follow_motion(time);
  }

  void follow_motion(double time) {
    std::size_t const n = simulation_.size();
    if (!settings_.noise || (motion_.frames() + 1) * n > most_moves)
      return;
    auto const now = simulation_.snapshot();
    motion_.molecules = n;
    motion_.times.push_back(time), motion_.boxes.push_back(simulation_.box());
    motion_.R.insert(motion_.R.end(), now.q.begin(), now.q.end());
    motion_.P.insert(motion_.P.end(), now.p.begin(), now.p.end());
  }

  cg::Estimate self_diffusion() const {
    constexpr std::size_t least_frames_of_lag = 8;
    bool const moves = conservative_integrator(settings_.scheme.conservative).moves();
    if (!moves || motion_.frames() < least_frames_of_lag || motion_.times.back() < least_lags * longest_lag ||
        longest_lag < least_frames_of_lag * motion_.interval())
      return {};
    // In a small box particles may go so far between two samples that their ways are not known.
    try {
      return cg::diffusion(motion_, {.longest = longest_lag}).D;
    } catch (InputError const&) {
      return {};
    }
  }

  void take_instant() {
    auto const now = simulation_.snapshot();
    sampler_.sample(moments(now));
    double const K = settings_.K();
    auto& values = ++instants_taken_ <= instants / 2 ? first_ : second_;
    for (double const eps : now.eps)
      values.push_back(eps * K);
  }

  std::vector<double> histogram(std::vector<double> const& values) const {
    auto const& bins = trial_.bins;
    if (!settings_.features().energies)
      return {};
    return cg::histogram(values, bins.lower, bins.upper, bins.count).density;
  }

  TrialResult failed(std::string failure) const {
    TrialResult found{.failure = std::move(failure), .dt = settings_.dt};
    if (!sampler_.energies().empty())
      add_energies(found);
    return found;
  }

  TrialResult result() const {
    auto const equilibrium = sampler_.result();
    double const K = settings_.K();
    auto in = [](cg::Estimate const& e, double unit) {
      return cg::Estimate{e.mean * unit, e.se * unit, e.n_eff};
    };
    auto const counts = simulation_.pair_counts();
    double const pairs = std::max(1.0, static_cast<double>(counts.proposed - counts_at_start_.proposed));
    TrialResult found{
        .failure = {},
        .dt = settings_.dt,
        .T_kin = equilibrium.T_kin,
        .T_int = equilibrium.T_int,
        .P = equilibrium.P,
        .D = self_diffusion(),
        .eps_mean = in(equilibrium.eps.mean, K),
        .eps_variance = in(equilibrium.eps.variance, K * K),
        .rejected_out_of_domain =
            static_cast<double>(counts.out_of_domain - counts_at_start_.out_of_domain) / pairs,
        .rejected_metropolis = static_cast<double>(counts.metropolis - counts_at_start_.metropolis) / pairs,
        .us_per_particle_step =
            seconds_ * 1e6 / (static_cast<double>(trial_.steps) * static_cast<double>(simulation_.size())),
        .bins = trial_.bins,
        .first_half = histogram(first_),
        .second_half = histogram(second_)};
    add_energies(found);
    return found;
  }

  /// Adds what the energies in time say.
  void add_energies(TrialResult& found) const {
    double const E_0 = sampler_.energies()[0];
    found.settled = static_cast<double>(trial_.settle) * settings_.dt;
    found.E_0 = E_0, found.heat_capacity = heat_capacity_;
    if (settings_.features().energies) // DPD's thermostat keeps no energy that could drift
      add_drift(found);
    std::size_t const every = std::max<std::size_t>(1, sampler_.times().size() / stored_energies);
    for (std::size_t k = 0; k < sampler_.times().size(); k += every) {
      found.times.push_back(sampler_.times()[k]);
      found.energies.push_back((sampler_.energies()[k] - E_0) / std::abs(E_0));
    }
  }

  void add_drift(TrialResult& found) const {
    std::size_t const samples =
        samples_before_heating(sampler_.energies(), most_heating * heat_capacity_ / settings_.K());
    auto const times = sampler_.times().first(samples), energies = sampler_.energies().first(samples);
    bool const cut = found.failed() || samples < sampler_.times().size();
    found.drift_unknown = samples < least_samples || (cut && times.back() < least_time);
    if (found.drift_unknown)
      return;
    auto const drift = energy_drift(times, energies);
    found.drift_of_mean = {energies[0] < 0 ? -drift.rate : drift.rate, drift.se};
    found.drift_of_walk = walk(times, energies);
  }

  Drift walk(std::span<double const> times, std::span<double const> energies) const {
    bool const conserved = !settings_.features().energies || settings_.scheme.keep_energy ||
                           !conservative_integrator(settings_.scheme.conservative).moves();
    if (conserved || pair_integrator(settings_.scheme.pairs).short_steps_only ||
        !enough_for_energy_walk(times, walk_lag))
      return {};
    return drift_from_energy_walk(times, energies, walk_lag, 1 / settings_.K(), 1);
  }

  Trial const& trial_;
  SimulationSettings const& settings_;
  Simulation simulation_;
  PairCounts counts_at_start_;
  EquilibriumSampler sampler_;
  cg::BlobSeries motion_{.atoms = 1, .mass = 1, .free_atoms = true}; ///< its temperature is not asked for
  std::vector<double> first_, second_;
  std::int64_t instants_taken_ = 0;
  std::uint64_t done_ = 0;
  double heat_capacity_ = 0, seconds_ = 0;
};

} // namespace

Drift TrialResult::drift() const {
  if (!(drift_of_walk.se > 0) || drift_of_mean.se < drift_of_walk.se)
    return drift_of_mean;
  double const apart = std::abs(drift_of_walk.rate - drift_of_mean.rate);
  return apart > 4 * std::hypot(drift_of_walk.se, drift_of_mean.se) ? drift_of_mean : drift_of_walk;
}

std::vector<double> TrialResult::histogram() const {
  std::vector<double> mean(first_half.size());
  for (std::size_t b = 0; b < mean.size(); ++b)
    mean[b] = 0.5 * (first_half[b] + second_half[b]);
  return mean;
}

Checkpoint equilibrated_start(SimulationSettings settings, double dt, double time,
                              std::function<bool()> const& keep_going) {
  settings.dt = dt;
  bool const exact = settings.noise && settings.features().energies;
  settings.scheme = {.pairs = exact ? "ems" : "ssa"};
  Simulation simulation(settings);
  equilibrate(simulation, static_cast<std::uint64_t>(std::ceil(time / dt)), keep_going);
  return simulation.checkpoint();
}

TrialResult run_trial(Trial const& trial, Checkpoint const& start,
                      std::function<bool(std::uint64_t)> const& keep_going) {
  return TrialRun(trial, start).carry_out(keep_going);
}

} // namespace mesobridge::sdpd
