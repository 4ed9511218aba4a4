#pragma once
#include "md/mpi_world.hpp"
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <vector>

namespace mesobridge::md {

/// Who watches runs that the ranks share, on rank 0; each may be absent.
struct SharedRunConsumers {
  /// New samples of one run, in their order, as plain numbers; false stops all runs at once.
  std::function<bool(std::size_t run, std::span<double const> samples)> samples;
  /// What a run concludes with, once, after its last sample; false stops all runs at once.
  std::function<bool(std::size_t run, std::span<double const> conclusion)> conclusion;
  /// Called often from the start on with the part of all work that is done, 0 ... 1; false stops all runs at
  /// once.
  std::function<bool(double fraction)> progress;
};

/// What a run reports while it goes on, on whichever rank. Samples travel in batches.
class RunReporter {
 public:
  using Send = std::function<bool(std::vector<double> const& samples, double steps)>;
  using Conclude = std::function<bool(std::span<double const> conclusion)>;

  RunReporter(Send send, Conclude conclude) : send_(std::move(send)), conclude_(std::move(conclude)) {}

  /// Keeps a sample for the next batch.
  void sample(std::initializer_list<double> numbers);
  /// Tells how many steps the run has done; false: stop at once.
  bool steps(std::int64_t done);
  /// Hands over what is left and ends the run with these numbers (none: no conclusion).
  bool conclude(std::int64_t done, std::span<double const> numbers);

 private:
  bool hand_over(std::int64_t done);

  Send send_;
  Conclude conclude_;
  std::vector<double> samples_;
  int batched_ = 0;
  std::int64_t told_ = 0;
};

/// The samples of a batch, which travelled as so many numbers each: make(numbers) makes one.
template <std::size_t numbers_of_sample, class Make>
auto samples_of(std::span<double const> numbers, Make const& make) {
  std::vector<decltype(make(numbers))> samples;
  for (std::size_t k = 0; k + numbers_of_sample <= numbers.size(); k += numbers_of_sample)
    samples.push_back(make(numbers.subspan(k, numbers_of_sample)));
  return samples;
}

/// Makes one run on this rank; returns false when the reporter stopped it.
using MakeRun = std::function<bool(std::size_t run, RunReporter& reporter)>;

/// Makes every run once, each on one rank: `shares` says which rank makes which, one after the other. All
/// ranks call it with the same arguments; the consumers of rank 0 are called while the runs go on.
/// `all_steps` is the sum of the steps of all runs. Returns (on rank 0) whether all runs are complete, false
/// when a consumer stopped them. An exception on one rank alone must be ended by MpiWorld::abort.
bool share_runs(MpiWorld const& world, std::span<std::vector<std::size_t> const> shares, double all_steps,
                MakeRun const& make, SharedRunConsumers const& consumers);

/// Which rank makes which runs: each in turn, the costliest first, to the rank with the least work.
std::vector<std::vector<std::size_t>> share_by_cost(std::span<double const> costs, int ranks);

/// A log file of this rank's own: `<stem>-<rank><extension>` on ranks > 0.
std::filesystem::path log_of_rank(std::filesystem::path const& log, int rank);

} // namespace mesobridge::md
