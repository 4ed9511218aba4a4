#include "md/shared_runs.hpp"
#include <algorithm>
#include <chrono>
#include <fmt/format.h>
#include <numeric>
#include <thread>

namespace mesobridge::md {
namespace {

enum Tag : int { report_tag = 1, stop_tag = 2 };
enum class Kind { samples, conclusion, last };

/// What a rank tells rank 0: steps of work done since the last report, and numbers of one run.
struct Report {
  Kind kind = Kind::samples;
  std::size_t run = 0;
  double steps = 0;
  std::vector<double> numbers;
};

std::vector<double> pack(Report const& report) {
  std::vector<double> message{double(int(report.kind)), double(report.run), report.steps};
  message.insert(message.end(), report.numbers.begin(), report.numbers.end());
  return message;
}

Report unpack(std::vector<double> const& message) {
  return {.kind = Kind(int(message[0])),
          .run = std::size_t(message[1]),
          .steps = message[2],
          .numbers = {message.begin() + 3, message.end()}};
}

/// Rank 0's side: gives the consumers what the ranks report and spreads the word when one of them says stop.
class Desk {
 public:
  Desk(MpiWorld const& world, SharedRunConsumers const& consumers, double all_steps)
      : world_(world), consumers_(consumers), all_steps_(all_steps), working_(world.size()) {}

  bool take(Report const& report) {
    steps_done_ += report.steps;
    working_ -= report.kind == Kind::last;
    if (!stopped_ && !give(report))
      stop();
    return ask_on();
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
      ask_on();
    }
    return !stopped_;
  }

 private:
  /// What the consumer of such a report answers.
  bool give(Report const& report) const {
    if (report.kind == Kind::samples && !report.numbers.empty() && consumers_.samples)
      return consumers_.samples(report.run, report.numbers);
    if (report.kind == Kind::conclusion && consumers_.conclusion)
      return consumers_.conclusion(report.run, report.numbers);
    return true;
  }

  bool ask_on() {
    if (!stopped_ && consumers_.progress && !consumers_.progress(std::min(1.0, steps_done_ / all_steps_)))
      stop();
    return !stopped_;
  }

  void stop() {
    stopped_ = true;
    for (int rank = 1; rank < world_.size(); ++rank)
      world_.send(rank, stop_tag, {});
  }

  MpiWorld const& world_;
  SharedRunConsumers const& consumers_;
  double all_steps_;
  double steps_done_ = 0;
  int working_; ///< ranks that have not sent their last report
  bool stopped_ = false;
};

/// One rank's share of the runs, made one after the other; `deliver` returns false to stop.
void make_share(std::span<std::size_t const> share, MakeRun const& make,
                std::function<bool(Report const&)> const& deliver) {
  for (std::size_t run : share) {
    RunReporter reporter(
        [&](std::vector<double> const& samples, double steps) {
          return deliver({.kind = Kind::samples, .run = run, .steps = steps, .numbers = samples});
        },
        [&](std::span<double const> numbers) {
          return deliver({.kind = Kind::conclusion,
                          .run = run,
                          .steps = 0,
                          .numbers = {numbers.begin(), numbers.end()}});
        });
    if (!make(run, reporter))
      return;
  }
}

} // namespace

void RunReporter::sample(std::initializer_list<double> numbers) {
  samples_.insert(samples_.end(), numbers);
  ++batched_;
}

bool RunReporter::steps(std::int64_t done) {
  constexpr int batch = 20;
  constexpr std::int64_t patience = 100;
  return (batched_ < batch && done - told_ < patience) || hand_over(done);
}

bool RunReporter::conclude(std::int64_t done, std::span<double const> numbers) {
  return hand_over(done) && (numbers.empty() || conclude_(numbers));
}

bool RunReporter::hand_over(std::int64_t done) {
  double const steps = double(done - told_);
  told_ = done;
  bool const go_on = send_(samples_, steps);
  samples_.clear();
  batched_ = 0;
  return go_on;
}

bool share_runs(MpiWorld const& world, std::span<std::vector<std::size_t> const> shares, double all_steps,
                MakeRun const& make, SharedRunConsumers const& consumers) {
  auto const& share = shares[std::size_t(world.rank())];
  Report const last{.kind = Kind::last, .run = 0, .steps = 0, .numbers = {}};
  if (world.is_root()) {
    Desk desk(world, consumers, all_steps);
    make_share(share, make,
               [&](Report const& report) { return desk.take(report) && desk.take_what_has_arrived(); });
    desk.take(last);
    return desk.serve_to_the_end();
  }
  bool told_to_stop = false;
  make_share(share, make, [&](Report const& report) {
    world.send(0, report_tag, pack(report));
    told_to_stop = told_to_stop || world.receive(stop_tag).has_value();
    return !told_to_stop;
  });
  world.send(0, report_tag, pack(last));
  return !told_to_stop;
}

std::vector<std::vector<std::size_t>> share_by_cost(std::span<double const> costs, int ranks) {
  std::vector<std::size_t> order(costs.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return costs[a] > costs[b]; });
  std::vector<std::vector<std::size_t>> shares(static_cast<std::size_t>(ranks));
  std::vector<double> work(shares.size(), 0.0);
  for (std::size_t index : order) {
    auto const least = std::size_t(std::min_element(work.begin(), work.end()) - work.begin());
    shares[least].push_back(index);
    work[least] += costs[index];
  }
  return shares;
}

std::filesystem::path log_of_rank(std::filesystem::path const& log, int rank) {
  if (rank == 0)
    return log;
  auto const name = fmt::format("{}-{}{}", log.stem().string(), rank, log.extension().string());
  return log.parent_path() / name;
}

} // namespace mesobridge::md
