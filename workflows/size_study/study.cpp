#include "workflows/size_study/study.hpp"
#include "workflows/interrupt.hpp"
#include "workflows/job_pool.hpp"
#include "workflows/size_study/fluid_run.hpp"
#include "workflows/size_study/parts.hpp"
#include "workflows/version.hpp"
#include <algorithm>
#include <mutex>

namespace mesobridge::workflows {

namespace {

constexpr double shock_compression = 1.34; // a shocked state: this factor in density and in temperature

SizeRunLength run_length_of(md::Preset preset) {
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

/// The state behind a shock, where the support of the kernel stays as wide as it is ahead, and the fluid is
/// stiffer.
sdpd::SimulationSettings shocked(sdpd::SimulationSettings settings) {
  settings.rho *= shock_compression, settings.T *= shock_compression;
  settings.as<sdpd::Sdpd>().h_factor *= std::cbrt(shock_compression);
  settings.dt *= 0.5;
  return settings;
}

/// All work as jobs that fill their own places.
class Study {
 public:
  Study(md::Preset preset, std::uint64_t seed, std::filesystem::path directory)
      : run_length_(run_length_of(preset)), seed_(seed), directory_(std::move(directory)),
        identity_(fmt::format("preset {}, seed {}, {}, {}, {}, {}, {}", static_cast<int>(preset), seed,
                              run_length_.calibrate, run_length_.settle, run_length_.sample,
                              run_length_.settle_per_size, git_commit())) {
    result_.sizes = run_length_.sizes;
    auto const any = fluid("cubic", 5, seed);
    result_.P_eos = eos_state(any).P;
    result_.particles = std::size_t{any.lattice[0]} * any.lattice[1] * any.lattice[2];
    std::size_t const cases = kernels.size() * run_length_.sizes.size();
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
          return find_structure(structure_kernels[k], run_length_.sizes.back(), seed_, run_length_);
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

  std::size_t sizes() const { return run_length_.sizes.size(); }
  sdpd::SimulationSettings settings_of_case(std::size_t c) const {
    return fluid(kernels[c / sizes()], run_length_.sizes[c % sizes()], seed_);
  }

  void calibrate(std::size_t c) {
    auto const settings = settings_of_case(c);
    result_.calibrations[c] = part(fmt::format("calibration-{}", c), [&] {
      auto const found =
          sdpd::calibrate_density(settings, sdpd::ScaleCondition::pressure, run_length_.calibrate,
                                  [] { return !interrupt_requested(); });
      return SizeCalibration{settings.as<sdpd::Sdpd>().kernel, settings.K(), found};
    });
  }

  void run_case(std::size_t k) {
    std::size_t const c = k / treatments.size();
    Treatment const treatment = treatments[k % treatments.size()];
    auto settings = settings_of_case(c);
    settings.seed += 1; // another history than the calibration's
    settings.as<sdpd::Sdpd>().centre_of_mass =
        treatment == Treatment::free ? sdpd::CentreOfMass::free : sdpd::CentreOfMass::bulk;
    if (treatment != Treatment::plain)
      settings.as<sdpd::Sdpd>().density_correction = result_.calibrations[c].found.constants;
    result_.runs[k] =
        part(fmt::format("run-{}", k), [&] { return run_fluid(settings, treatment, run_length_); });
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
        settings.as<sdpd::Sdpd>().density_correction = calibration.found.constants;
        result_.elsewhere[place] = {fmt::format("{}: constants of K = {:g} at K = {:g}{}", calibration.kernel,
                                                calibration.K, K, in_shock ? ", 1541 kg/m^3, 1340 K" : ""),
                                    part(fmt::format("elsewhere-{}", place),
                                         [&] { return run_fluid(settings, Treatment::free, run_length_); })};
      });
    };
    double const middle_K = result_.sizes[sizes() / 2], large_K = result_.sizes[sizes() - 2];
    std::size_t const place = 4 * kernel;
    add(place, middle, middle_K, true);
    add(place + 1, large, large_K, true);
    add(place + 2, middle, result_.sizes.front(), false);
    add(place + 3, middle, result_.sizes.back(), false);
  }

  SizeRunLength run_length_;
  std::uint64_t seed_;
  std::filesystem::path directory_;
  std::string identity_; ///< of all parts
  SizeStudy result_;
  std::mutex mutex_;
  double done_ = 0;
};

} // namespace

std::string label_of(Treatment treatment) {
  constexpr std::array in_order{"plain", "corrected", "corrected, centre-of-mass-free"};
  return in_order.at(static_cast<std::size_t>(treatment));
}

SizeStudy run_size_study(md::Preset preset, std::uint64_t seed, int threads,
                         std::filesystem::path const& directory, Context const& context) {
  return Study(preset, seed, directory).run(threads, context);
}

} // namespace mesobridge::workflows
