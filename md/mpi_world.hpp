#pragma once
#include <optional>
#include <span>
#include <vector>

namespace mesobridge::md {

/// Numbers that one rank sent to another.
struct Message {
  int from = 0;
  int tag = 0;
  std::vector<double> content;
};

/// The MPI ranks of this program. MPI can be started once in a process: the first MpiWorld starts it, the end
/// of the process finalises it, and every later MpiWorld is the same world. A program that was not started by
/// mpirun is a world of one rank. Not for use by several threads at once.
class MpiWorld {
 public:
  MpiWorld();

  int rank() const { return rank_; }
  int size() const { return size_; }
  bool is_root() const { return rank_ == 0; }

  /// Sends numbers to a rank; returns when they may be changed. Messages of one sender arrive in order.
  void send(int to, int tag, std::span<double const> content) const;
  /// The next message with this tag from any rank, if one has arrived; never waits.
  std::optional<Message> receive(int tag) const;
  /// The answer of rank 0, given to every rank. All ranks must call it.
  bool root_says(bool answer) const;
  /// Numbers of rank 0, given to every rank; the others wait for them without load. All ranks must call it.
  std::vector<double> root_gives(std::span<double const> numbers) const;
  /// Gives each rank the numbers meant for it and returns what all ranks meant for this one, in the order of
  /// the ranks. All ranks must call it; `to_each` has one entry a rank.
  std::vector<double> exchange(std::vector<std::vector<double>> const& to_each) const;
  /// The numbers of all ranks in the order of the ranks, on rank 0; nothing elsewhere. All ranks must call
  /// it.
  std::vector<double> gather_at_root(std::span<double const> numbers) const;
  /// Adds up the numbers of all ranks, place by place, and gives each rank the sums. All ranks must call it
  /// with as many.
  void add_up(std::span<double> numbers) const;
  /// Waits for all ranks.
  void barrier() const;

  /// Ends every rank at once with this exit code: the way out when one rank alone has failed, because the
  /// others would wait for it for ever. The caller first prints its one message.
  [[noreturn]] void abort(int exit_code) const;

 private:
  int rank_ = 0;
  int size_ = 1;
};

} // namespace mesobridge::md
