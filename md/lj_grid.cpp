#include "md/lj_grid.hpp"
#include "md/seeds.hpp"
#include <algorithm>
#include <chrono>
#include <cmath>
#include <numeric>
#include <thread>

namespace mesobridge::md {
namespace {

enum Tag : int { report_tag = 1, stop_tag = 2 };

/// What a rank tells rank 0: steps of work done since the last report, whether it is the rank's last, and
/// samples.
struct Report {
  std::size_t state = 0;
  double steps = 0;
  bool last = false;
  std::vector<ThermoSample> samples;
};

std::vector<double> pack(Report const& report) {
  std::vector<double> numbers{double(report.state), report.steps, double(report.last)};
  for (auto const& sample : report.samples) // a step number is exact in a double up to 2^53
    numbers.insert(numbers.end(), {double(sample.step), sample.T, sample.U, sample.P});
  return numbers;
}

Report unpack(std::vector<double> const& numbers) {
  Report report{
      .state = std::size_t(numbers[0]), .steps = numbers[1], .last = numbers[2] != 0, .samples = {}};
  for (std::size_t k = 3; k + 3 < numbers.size(); k += 4)
    report.samples.push_back({std::int64_t(numbers[k]), numbers[k + 1], numbers[k + 2], numbers[k + 3]});
  return report;
}

/// Rank 0's side: gives the consumers what the ranks report and spreads the word when one of them says stop.
class Desk {
 public:
  Desk(MpiWorld const& world, LjGridConsumers const& consumers, double all_steps)
      : world_(world), consumers_(consumers), all_steps_(all_steps), working_(world.size()) {}

  bool take(Report const& report) {
    steps_done_ += report.steps;
    working_ -= report.last;
    if (!stopped_ && !report.samples.empty() && consumers_.samples &&
        !consumers_.samples(report.state, report.samples))
      stop();
    if (!stopped_ && consumers_.progress && !consumers_.progress(std::min(1.0, steps_done_ / all_steps_)))
      stop();
    return !stopped_;
  }

  bool take_what_has_arrived() {
    while (auto message = world_.receive(report_tag))
      take(unpack(message->content));
    return !stopped_;
  }

  /// Serves the other ranks until each has sent its last report.
  bool serve_to_the_end() {
    while (working_ > 0) {
      take_what_has_arrived();
      std::this_thread::sleep_for(std::chrono::milliseconds(5)); // MPI would wait at full load
      if (!stopped_ && consumers_.progress && !consumers_.progress(std::min(1.0, steps_done_ / all_steps_)))
        stop();
    }
    return !stopped_;
  }

 private:
  void stop() {
    stopped_ = true;
    for (int rank = 1; rank < world_.size(); ++rank)
      world_.send(rank, stop_tag, {});
  }

  MpiWorld const& world_;
  LjGridConsumers const& consumers_;
  double all_steps_;
  double steps_done_ = 0;
  int working_; ///< ranks that have not sent their last report
  bool stopped_ = false;
};

std::filesystem::path log_of_rank(std::filesystem::path const& log, int rank) {
  if (rank == 0)
    return log;
  auto const name = fmt::format("{}-{}{}", log.stem().string(), rank, log.extension().string());
  return log.parent_path() / name;
}

/// One rank's share of the states, run one after the other; `deliver` returns false to stop.
template <class Deliver>
bool run_share(MpiWorld const& world, std::span<std::size_t const> share, std::span<LjState const> states,
               LjFluidSettings const& settings, Deliver const& deliver) {
  constexpr std::size_t batch = 20;
  auto own = settings;
  own.log_file = log_of_rank(settings.log_file, world.rank());
  Log log = Log::replace;
  for (std::size_t index : share) {
    own.seed = mix(settings.seed, index);
    Report report{.state = index, .steps = 0, .last = false, .samples = {}};
    std::int64_t told = 0;
    auto const keep = [&](ThermoSample const& sample) {
      report.samples.push_back(sample);
      return true;
    };
    auto const hand_over = [&](std::int64_t steps_done) {
      if (report.samples.size() < batch && steps_done - told < 100)
        return true;
      report.steps = double(steps_done - told);
      told = steps_done;
      bool const go_on = deliver(report);
      report.samples.clear();
      return go_on;
    };
    LjFluidConsumers const consumers{
        .thermo = keep, .frames = {}, .frame_every = own.sample_every, .steps = hand_over};
    if (!sample_lj_fluid(world, Ranks::own, states[index], own, consumers, log))
      return false;
    report.steps = double(own.steps() - told);
    if (!deliver(report))
      return false;
    log = Log::append;
  }
  return true;
}

} // namespace

std::vector<LjState> lj_grid(LjRegion region, int densities, int temperatures) {
  require(region.rho_min > 0 && std::isfinite(region.rho_min), "lowest density", region.rho_min,
          "must be > 0");
  require(region.rho_max > region.rho_min && std::isfinite(region.rho_max), "highest density", region.rho_max,
          "must be above the lowest");
  require(region.T_min > 0 && std::isfinite(region.T_min), "lowest temperature", region.T_min, "must be > 0");
  require(region.T_max > region.T_min && std::isfinite(region.T_max), "highest temperature", region.T_max,
          "must be above the lowest");
  require(densities >= 2 && densities <= 1000, "densities of the grid", densities, "must be 2 ... 1000");
  require(temperatures >= 2 && temperatures <= 1000, "temperatures of the grid", temperatures,
          "must be 2 ... 1000");
  std::vector<LjState> states;
  for (int i = 0; i < temperatures; ++i)
    for (int j = 0; j < densities; ++j)
      states.push_back(
          {std::lerp(region.rho_min, region.rho_max, double(j) / (densities - 1)),
           region.T_min * std::pow(region.T_max / region.T_min, double(i) / (temperatures - 1))});
  return states;
}

std::vector<LjState> default_lj_grid(Preset preset) {
  int const edge = preset == Preset::quick ? 5 : preset == Preset::standard ? 8 : 12;
  return lj_grid(default_lj_region, edge, edge);
}

std::vector<std::vector<std::size_t>> share_states(std::span<LjState const> states, int ranks) {
  std::vector<std::size_t> order(states.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return states[a].rho > states[b].rho; });
  std::vector<std::vector<std::size_t>> shares(static_cast<std::size_t>(ranks));
  std::vector<double> work(shares.size(), 0.0);
  for (std::size_t index : order) {
    auto const least = std::size_t(std::min_element(work.begin(), work.end()) - work.begin());
    shares[least].push_back(index);
    work[least] += states[index].rho;
  }
  return shares;
}

bool sample_lj_grid(MpiWorld const& world, std::span<LjState const> states, LjFluidSettings const& settings,
                    LjGridConsumers const& consumers) {
  require(!states.empty(), "states of the grid", states.size(), "at least one is needed");
  for (LjState state : states)
    check(state, settings);
  auto const shares = share_states(states, world.size());
  auto const& share = shares[std::size_t(world.rank())];

  if (world.is_root()) {
    Desk desk(world, consumers, double(settings.steps()) * double(states.size()));
    run_share(world, share, states, settings,
              [&](Report const& report) { return desk.take(report) && desk.take_what_has_arrived(); });
    desk.take({.state = 0, .steps = 0, .last = true, .samples = {}});
    return desk.serve_to_the_end();
  }
  bool told_to_stop = false;
  run_share(world, share, states, settings, [&](Report const& report) {
    world.send(0, report_tag, pack(report));
    told_to_stop = told_to_stop || world.receive(stop_tag).has_value();
    return !told_to_stop;
  });
  world.send(0, report_tag, pack({.state = 0, .steps = 0, .last = true, .samples = {}}));
  return !told_to_stop;
}

} // namespace mesobridge::md
