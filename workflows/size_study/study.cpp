#include "workflows/size_study/study.hpp"
#include "fitting/eos/evaluate.hpp"
#include "sdpd/observe/canonical_energy.hpp"
#include "sdpd/observe/radial_distribution.hpp"
#include "sdpd/setup/equilibration.hpp"
#include "workflows/interrupt.hpp"
#include "workflows/job_pool.hpp"
#include "workflows/size_study/parts.hpp"
#include "workflows/version.hpp"
#include <algorithm>
#include <mutex>
#include <span>

namespace mesobridge::workflows {

namespace {

constexpr double state_rho = 1150, state_T = 1000;
constexpr double shock_compression = 1.34; // a shocked state: this factor in density and in temperature
constexpr std::uint32_t side = 10;
constexpr std::uint64_t instants = 20;

/// Steps of one calibration, and of one run.
struct Effort {
  std::vector<double> sizes;
  std::uint64_t calibrate, settle, sample;
  double settle_per_size; ///< at least this time (reduced) for each atom of a particle
};

Effort effort_of(md::Preset preset) {
  std::vector<double> const all{5, 10, 25, 50, 100, 250, 500, 1000, 2500, 5000, 10000, 25000};
  switch (preset) {
  case md::Preset::quick:
    return {{5, 10, 100, 1000, 25000}, 1600, 500, 1200, 0.08};
  case md::Preset::standard:
    return {all, 10000, 4000, 20000, 0.16};
  case md::Preset::paper:
    break;
  }
  return {all, 50000, 50000, 500000, 0.4};
}

/// Small particles are fast and have small heat capacities: they need short steps.
double time_step(double K) {
  return K < 50 ? 0.03 : K < 1000 ? 0.06 : K < 10000 ? 0.1 : 0.2;
}

/// SSA leads an energy below zero now and then where particles are small (Gamma-distributed energies come
/// near zero); EMS does not, and its equilibrium is exact.
sdpd::PairScheme scheme_of(double K) {
  return K < 50 ? sdpd::PairScheme::ems : sdpd::PairScheme::ssa;
}

sdpd::SimulationSettings fluid(std::string const& kernel, double K, std::uint64_t seed) {
  return {.eos = fitting::material("argon").eos,
          .rho = state_rho,
          .T = state_T,
          .K = K,
          .lattice = {side, side, side},
          .disorder = 0.15,
          .kernel = kernel,
          .eta = 2e-3,
          .dt = time_step(K),
          .scheme = {.pairs = scheme_of(K)},
          .seed = seed};
}

fitting::EosState eos_state(sdpd::SimulationSettings const& s) {
  return std::visit([&](auto const& eos) { return fitting::state_from_temperature(eos, s.rho, s.T); }, s.eos);
}

cg::Estimate scaled(cg::Estimate const& e, double factor) {
  return {e.mean * factor, e.se * factor, e.n_eff};
}

/// A structure that still settles sets energy free, which friction passes on to the internal energies: in
/// between it warms the motion. Counted in k_BT that energy goes as K. At K = 25000 the motion is too warm by
/// 2 per cent after 250 units of time and by 0.3 or less after 2000; with the kernel Wendland C2 such
/// particles crystallise on the way.
std::uint64_t settling_steps(Effort const& effort, double K) {
  return std::max(effort.settle, static_cast<std::uint64_t>(effort.settle_per_size * K / time_step(K)));
}

/// Kinetic and internal energy of a particle that the invariant measure gives, at densities that were met.
class ExpectedEnergy {
 public:
  ExpectedEnergy(sdpd::SimulationSettings const& settings, std::size_t particles)
      : internal_(settings), kinetic_(1.5 * (1 - 1 / static_cast<double>(particles)) / settings.K) {}
  void add(std::span<double const> rho) {
    for (double const one : rho)
      sum_ += internal_(one);
    count_ += rho.size();
  }
  double mean() const { return kinetic_ + sum_ / static_cast<double>(count_); }

 private:
  sdpd::CanonicalEnergy internal_;
  double kinetic_, sum_ = 0;
  std::size_t count_ = 0;
};

FluidRun run_fluid(sdpd::SimulationSettings const& settings, Treatment treatment, Effort const& effort) {
  sdpd::Simulation simulation(settings);
  auto const keep_going = [] { return !interrupt_requested(); };
  sdpd::equilibrate(simulation, settling_steps(effort, settings.K), keep_going);
  auto const eos = eos_state(settings);
  auto const units = settings.units();
  constexpr std::uint64_t every = 3;
  FluidRun result{.kernel = settings.kernel,
                  .K = settings.K,
                  .treatment = treatment,
                  .constants = settings.density_correction};
  std::vector<double> P, rho, T_kin, T_int;
  std::uint64_t const samples = effort.sample / every,
                      between = std::max<std::uint64_t>(1, samples / instants);
  double energy = 0;
  ExpectedEnergy expected(settings, simulation.size());
  for (std::uint64_t k = 0; k < samples; ++k) {
    simulation.advance(every);
    throw_if_interrupted();
    auto const now = simulation.observe();
    P.push_back(now.P), rho.push_back(now.rho), T_kin.push_back(now.T_kin), T_int.push_back(now.T_int);
    energy += now.energy() / static_cast<double>(samples * simulation.size());
    if (k % between != 0)
      continue;
    auto const particles = simulation.snapshot();
    expected.add(particles.rho);
    for (std::size_t i = 0; i < particles.rho.size(); ++i)
      result.rho_i.push_back(particles.rho[i] * units.density),
          result.P_i.push_back(particles.P[i] * units.pressure() / 1e9);
  }
  result.P = scaled(cg::estimate_mean(P), units.pressure() / eos.P);
  result.rho = cg::estimate_mean(rho);
  result.T_kin = cg::estimate_mean(T_kin), result.T_int = cg::estimate_mean(T_int);
  result.energy = energy * units.specific_energy() / eos.e;
  result.energy_expected = expected.mean() * units.specific_energy() / eos.e;
  return result;
}

Structure find_structure(std::string const& kernel, double K, std::uint64_t seed, Effort const& effort) {
  constexpr double r_max = 4;
  constexpr std::size_t bins = 100;
  auto const settings = fluid(kernel, K, seed);
  sdpd::Simulation simulation(settings);
  sdpd::equilibrate(simulation, settling_steps(effort, K), [] { return !interrupt_requested(); });
  sdpd::RadialDistribution g(simulation.box(), r_max, bins);
  for (std::uint64_t k = 0; k < instants; ++k) {
    simulation.advance(effort.sample / (2 * instants));
    throw_if_interrupted();
    g.add(simulation.snapshot().q);
  }
  Structure structure{.kernel = kernel, .r = {}, .g = g.g(), .pairs = g.neighbours_within(0.5)};
  for (std::size_t bin = 0; bin < bins; ++bin)
    structure.r.push_back(g.centre(bin));
  return structure;
}

/// The state behind a shock, where the support of the kernel stays as wide as it is ahead, and the fluid is
/// stiffer.
sdpd::SimulationSettings shocked(sdpd::SimulationSettings settings) {
  settings.rho *= shock_compression, settings.T *= shock_compression;
  settings.h_factor *= std::cbrt(shock_compression);
  settings.dt *= 0.5;
  return settings;
}

/// All work as jobs that fill their own places.
class Study {
 public:
  Study(md::Preset preset, std::uint64_t seed, std::filesystem::path directory)
      : effort_(effort_of(preset)), seed_(seed), directory_(std::move(directory)),
        identity_(fmt::format("preset {}, seed {}, {}, {}, {}, {}, {}", static_cast<int>(preset), seed,
                              effort_.calibrate, effort_.settle, effort_.sample, effort_.settle_per_size,
                              git_commit())) {
    result_.sizes = effort_.sizes;
    result_.P_eos = eos_state(fluid("cubic", 5, seed)).P;
    result_.particles = std::size_t{side} * side * side;
    std::size_t const cases = kernels.size() * effort_.sizes.size();
    result_.calibrations.resize(cases), result_.runs.resize(cases * treatments.size());
    result_.structures.resize(structure_kernels.size());
    result_.elsewhere.resize(2 * kernels.size() * 2);
  }

  SizeStudy run(int threads, Context const& context) {
    std::vector<std::function<void()>> first, second;
    // The largest particles, which settle longest, begin.
    for (std::size_t k = result_.calibrations.size(); k-- > 0;)
      first.push_back([this, k] { calibrate(k); });
    for (std::size_t k = 0; k < structure_kernels.size(); ++k)
      first.push_back([this, k] {
        result_.structures[k] = part(fmt::format("structure-{}", k), [&] {
          return find_structure(structure_kernels[k], effort_.sizes.back(), seed_, effort_);
        });
      });
    for (std::size_t k = result_.runs.size(); k-- > 0;)
      second.push_back([this, k] { run_case(k); });
    for (std::size_t k = 0; k < kernels.size(); ++k)
      add_elsewhere(k, second);
    auto progress = context.progress("Table 5.1", static_cast<double>(first.size() + second.size()));
    carry_out(first, threads, progress);
    carry_out(second, threads, progress);
    progress.finish();
    return std::move(result_);
  }

 private:
  static constexpr std::array<char const*, 2> kernels{"cubic", "wendland-c2"};
  static constexpr std::array<char const*, 3> structure_kernels{"lucy", "cubic", "wendland-c2"};

  template <class Make>
  auto part(std::string const& name, Make const& make) const -> decltype(make()) {
    return stored_or_made(directory_ / (name + ".json"), identity_, make);
  }

  void carry_out(std::vector<std::function<void()>> const& jobs, int threads, Progress& progress) {
    std::vector<std::function<void()>> counted;
    for (auto const& job : jobs)
      counted.push_back([&, job] {
        job();
        std::lock_guard const lock(mutex_);
        progress.update(++done_);
      });
    run_jobs(counted, threads);
  }

  std::size_t sizes() const { return effort_.sizes.size(); }
  sdpd::SimulationSettings settings_of_case(std::size_t c) const {
    return fluid(kernels[c / sizes()], effort_.sizes[c % sizes()], seed_);
  }

  void calibrate(std::size_t c) {
    auto const settings = settings_of_case(c);
    result_.calibrations[c] = part(fmt::format("calibration-{}", c), [&] {
      auto const found = sdpd::calibrate_density(settings, sdpd::ScaleCondition::pressure, effort_.calibrate,
                                                 [] { return !interrupt_requested(); });
      return SizeCalibration{settings.kernel, settings.K, found};
    });
  }

  void run_case(std::size_t k) {
    std::size_t const c = k / treatments.size();
    Treatment const treatment = treatments[k % treatments.size()];
    auto settings = settings_of_case(c);
    settings.seed += 1; // another history than the calibration's
    settings.centre_of_mass =
        treatment == Treatment::free ? sdpd::CentreOfMass::free : sdpd::CentreOfMass::bulk;
    if (treatment != Treatment::plain)
      settings.density_correction = result_.calibrations[c].found.constants;
    result_.runs[k] = part(fmt::format("run-{}", k), [&] { return run_fluid(settings, treatment, effort_); });
  }

  /// The constants of the second largest size, and of a middle one, in a shocked state and at other sizes.
  void add_elsewhere(std::size_t kernel, std::vector<std::function<void()>>& jobs) {
    std::size_t const middle = kernel * sizes() + sizes() / 2, large = kernel * sizes() + sizes() - 2;
    auto add = [this, &jobs](std::size_t place, std::size_t from, double K, bool in_shock) {
      jobs.push_back([this, place, from, K, in_shock] {
        auto const& calibration = result_.calibrations[from];
        auto settings = fluid(calibration.kernel, K, seed_ + 2);
        if (in_shock)
          settings = shocked(settings);
        settings.density_correction = calibration.found.constants;
        result_.elsewhere[place] = {fmt::format("{}: constants of K = {:g} at K = {:g}{}", calibration.kernel,
                                                calibration.K, K, in_shock ? ", 1541 kg/m^3, 1340 K" : ""),
                                    part(fmt::format("elsewhere-{}", place),
                                         [&] { return run_fluid(settings, Treatment::free, effort_); })};
      });
    };
    double const middle_K = result_.sizes[sizes() / 2], large_K = result_.sizes[sizes() - 2];
    std::size_t const place = 4 * kernel;
    add(place, middle, middle_K, true);
    add(place + 1, large, large_K, true);
    add(place + 2, middle, result_.sizes.front(), false);
    add(place + 3, middle, result_.sizes.back(), false);
  }

  Effort effort_;
  std::uint64_t seed_;
  std::filesystem::path directory_;
  std::string identity_; ///< of all parts
  SizeStudy result_;
  std::mutex mutex_;
  double done_ = 0;
};

} // namespace

std::string label_of(Treatment treatment) {
  switch (treatment) {
  case Treatment::plain:
    return "plain";
  case Treatment::corrected:
    return "corrected";
  case Treatment::free:
    break;
  }
  return "corrected, centre-of-mass-free";
}

SizeStudy run_size_study(md::Preset preset, std::uint64_t seed, int threads,
                         std::filesystem::path const& directory, Context const& context) {
  return Study(preset, seed, directory).run(threads, context);
}

} // namespace mesobridge::workflows
