#include "workflows/farm.hpp"
#include "md/child_process.hpp"
#include "md/error.hpp"
#include "workflows/interrupt.hpp"
#include "workflows/ranks.hpp"
#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <fmt/ranges.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <utility>

namespace mesobridge::workflows {

namespace {

constexpr int patience_ms = 250;

/// A descriptor that is closed with its owner.
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  ~Descriptor() {
    if (number_ >= 0)
      close(number_);
  }
  int number() const { return number_; }

 private:
  int number_;
};

/// By which a child tells how far it is.
struct Pipe {
  Descriptor reads, writes;

  static Pipe open() {
    int ends[2];
    if (pipe2(ends, O_CLOEXEC | O_NONBLOCK) != 0)
      throw EnvironmentError(fmt::format("cannot create a pipe: {}", std::strerror(errno)));
    return {Descriptor(ends[0]), Descriptor(ends[1])};
  }
};

/// One run that goes on.
class RunningChild {
 public:
  explicit RunningChild(FarmedRun const& run) : RunningChild(run, Pipe::open()) {}

  FarmedRun const& run() const { return *run_; }
  int reports() const { return reports_.number(); }
  /// The work done so far, by the last report.
  double done() const { return done_ * run_->work; }
  double processor_seconds() const { return processor_seconds_; } ///< once it has ended
  void ask_to_stop() const { kill(process_, SIGINT); }

  void take_reports() {
    char buffer[4096];
    for (ssize_t size = 0; (size = read(reports(), buffer, sizeof buffer)) > 0;)
      text_.append(buffer, std::size_t(size));
    for (std::size_t end = 0; (end = text_.find('\n')) != std::string::npos; text_.erase(0, end + 1))
      done_ = std::strtod(text_.c_str(), nullptr);
  }

  /// Its wait status once it has ended.
  std::optional<int> ended() {
    int status = 0;
    rusage usage{};
    pid_t const process = wait4(process_, &status, WNOHANG, &usage);
    auto const seconds = [](timeval const& time) {
      return double(time.tv_sec) + 1e-6 * double(time.tv_usec);
    };
    processor_seconds_ = seconds(usage.ru_utime) + seconds(usage.ru_stime);
    if (process < 0 && errno != EINTR)
      throw EnvironmentError(
          fmt::format("the process of '{}' was lost: {}", fmt::join(run_->argv, " "), std::strerror(errno)));
    return process == process_ ? std::optional(status) : std::nullopt;
  }

 private:
  RunningChild(FarmedRun const& run, Pipe pipe)
      : run_(&run),
        process_(md::start_child(run.argv,
                                 {.variables = {fmt::format("{}={}", reports_variable, pipe.writes.number())},
                                  .descriptor = pipe.writes.number(),
                                  .signal_mask = std::nullopt})),
        reports_(std::move(pipe.reads)) {}

  FarmedRun const* run_;
  pid_t process_;
  Descriptor reports_;
  std::string text_;
  double done_ = 0, processor_seconds_ = 0;
};

class Farm {
 public:
  Farm(std::vector<FarmedRun> runs, int at_once) : runs_(std::move(runs)), at_once_(std::size_t(at_once)) {
    std::stable_sort(runs_.begin(), runs_.end(), [](auto& a, auto& b) { return a.work > b.work; });
    for (auto const& run : runs_)
      all_work_ += run.work;
  }

  void work(Progress& progress) {
    interrupts_are_asked_for();
    while (begin_more() || !children_.empty()) {
      wait();
      std::erase_if(children_, [&](RunningChild& child) { return take(child); });
      progress.update(done() / all_work_, fmt::format("{} of {} runs done", ended_, runs_.size()));
      if (failure_ || interrupt_requested())
        stop();
    }
    if (failure_)
      std::rethrow_exception(failure_);
    if (stopped_)
      throw Interrupted("interrupted; the same command goes on from the checkpoints");
    progress.finish();
  }

 private:
  /// Whether there are more to begin later.
  bool begin_more() {
    try {
      while (!stopped_ && begun_ < runs_.size() && children_.size() < at_once_)
        children_.emplace_back(runs_[begun_++]);
    } catch (...) {
      note(std::current_exception());
      stop();
    }
    return !stopped_ && begun_ < runs_.size();
  }

  void wait() const {
    std::vector<pollfd> reports;
    for (auto const& child : children_)
      reports.push_back({.fd = child.reports(), .events = POLLIN, .revents = 0});
    poll(reports.data(), reports.size(), patience_ms);
  }

  /// Whether the child has ended.
  bool take(RunningChild& child) {
    child.take_reports();
    auto const status = child.ended();
    if (!status)
      return false;
    if (WIFEXITED(*status) && WEXITSTATUS(*status) == 0) {
      ++ended_, work_ended_ += child.run().work;
      if (child.run().ended)
        child.run().ended(child.processor_seconds());
    } else
      note(failure_of(child.run(), *status));
    return true;
  }

  static std::exception_ptr failure_of(FarmedRun const& run, int status) {
    auto const call = fmt::format("{}", fmt::join(run.argv, " "));
    if (WIFSIGNALED(status))
      return std::make_exception_ptr(
          EnvironmentError(fmt::format("'{}' was ended by the signal {}", call, WTERMSIG(status))));
    if (WEXITSTATUS(status) == md::not_executed)
      return std::make_exception_ptr(EnvironmentError(fmt::format("'{}' could not be executed", call)));
    return std::make_exception_ptr(AlreadyReported{WEXITSTATUS(status)});
  }

  /// Of the failures the first one counts; those of runs that were asked to stop do not.
  void note(std::exception_ptr failure) {
    if (!stopped_ && !failure_)
      failure_ = std::move(failure);
  }

  void stop() {
    if (!std::exchange(stopped_, true))
      for (auto const& child : children_)
        child.ask_to_stop();
  }

  double done() const {
    double sum = work_ended_;
    for (auto const& child : children_)
      sum += child.done();
    return sum;
  }

  std::vector<FarmedRun> runs_;
  std::vector<RunningChild> children_;
  std::size_t at_once_, begun_ = 0, ended_ = 0;
  double all_work_ = 0, work_ended_ = 0;
  bool stopped_ = false;
  std::exception_ptr failure_;
};

} // namespace

bool farming_pays(std::span<double const> work, int cores) {
  // Ranks that share one run wait for each other: two lose at least this part of their time.
  constexpr double lost_by_ranks = 0.05;
  std::vector<double> longest_first(work.begin(), work.end());
  std::sort(longest_first.begin(), longest_first.end(), std::greater<>());
  std::vector<double> cores_busy(std::size_t(cores), 0.0);
  double all = 0;
  for (double const one : longest_first) {
    *std::min_element(cores_busy.begin(), cores_busy.end()) += one;
    all += one;
  }
  double const farmed = *std::max_element(cores_busy.begin(), cores_busy.end());
  return cores > 1 && farmed < all / cores * (1 + lost_by_ranks);
}

void farm(std::string const& title, std::vector<FarmedRun> runs, int at_once, Context const& context) {
  for (auto const& run : runs)
    require(run.work > 0, "work of '" + fmt::format("{}", fmt::join(run.argv, " ")) + "'", run.work,
            "must be > 0");
  require(at_once >= 1, "runs at once", at_once, "must be at least 1");
  auto progress = context.progress(title, 1);
  Farm(std::move(runs), at_once).work(progress);
  interrupts_end_at_once(); // what follows analyses what the runs have stored
}

} // namespace mesobridge::workflows
