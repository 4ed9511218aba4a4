// The C interface alone: MPI's C++ bindings were withdrawn from the standard.
#define OMPI_SKIP_MPICXX 1
#include "md/mpi_world.hpp"
#include "md/error.hpp"
#include "md/rank_launcher.hpp"
#include <chrono>
#include <cstdlib>
#include <mpi.h>
#include <numeric>
#include <thread>

namespace mesobridge::md {
namespace {

constexpr int broadcast_tag = 1000;

void finalise_at_exit() {
  int finalised = 0;
  MPI_Finalized(&finalised);
  if (!finalised)
    MPI_Finalize();
}

/// Where each of several parts begins that lie one behind the other.
std::vector<int> begins_of(std::vector<int> const& counts) {
  std::vector<int> begins(counts.size(), 0);
  std::exclusive_scan(counts.begin(), counts.end(), begins.begin(), 0);
  return begins;
}

} // namespace

MpiWorld::MpiWorld() {
  int started = 0, finalised = 0;
  MPI_Initialized(&started);
  MPI_Finalized(&finalised);
  if (finalised)
    throw EnvironmentError("MPI has already been finalised in this process and cannot start again");
  if (!started) {
    if (!already_on_ranks()) // alone it shares nothing: no files of shared memory, which limits may forbid
      setenv("PMIX_MCA_gds", "hash", 0);
    if (MPI_Init(nullptr, nullptr) != MPI_SUCCESS)
      throw EnvironmentError("MPI could not be started");
    std::atexit(finalise_at_exit);
  }
  MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
  MPI_Comm_size(MPI_COMM_WORLD, &size_);
}

void MpiWorld::send(int to, int tag, std::span<double const> content) const {
  MPI_Send(content.data(), int(content.size()), MPI_DOUBLE, to, tag, MPI_COMM_WORLD);
}

std::optional<Message> MpiWorld::receive(int tag) const {
  int arrived = 0, count = 0;
  MPI_Status status;
  MPI_Iprobe(MPI_ANY_SOURCE, tag, MPI_COMM_WORLD, &arrived, &status);
  if (!arrived)
    return std::nullopt;
  MPI_Get_count(&status, MPI_DOUBLE, &count);
  Message message{status.MPI_SOURCE, tag, std::vector<double>(std::size_t(count))};
  MPI_Recv(message.content.data(), count, MPI_DOUBLE, message.from, tag, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
  return message;
}

bool MpiWorld::root_says(bool answer) const {
  int value = answer;
  MPI_Bcast(&value, 1, MPI_INT, 0, MPI_COMM_WORLD);
  return value != 0;
}

std::vector<double> MpiWorld::root_gives(std::span<double const> numbers) const {
  if (is_root()) {
    for (int rank = 1; rank < size_; ++rank)
      send(rank, broadcast_tag, numbers);
    return {numbers.begin(), numbers.end()};
  }
  constexpr std::chrono::microseconds soon(20), later(5000);
  for (auto wait = soon;; wait = std::min(2 * wait, later)) {
    if (auto message = receive(broadcast_tag))
      return std::move(message->content);
    std::this_thread::sleep_for(wait); // MPI would wait at full load
  }
}

std::vector<double> MpiWorld::exchange(std::vector<std::vector<double>> const& to_each) const {
  if (size_ == 1)
    return to_each.at(0);
  std::vector<int> out(to_each.size()), in(to_each.size());
  std::vector<double> outgoing;
  for (std::size_t rank = 0; rank < to_each.size(); ++rank) {
    out[rank] = int(to_each[rank].size());
    outgoing.insert(outgoing.end(), to_each[rank].begin(), to_each[rank].end());
  }
  MPI_Alltoall(out.data(), 1, MPI_INT, in.data(), 1, MPI_INT, MPI_COMM_WORLD);
  auto const out_starts = begins_of(out), in_starts = begins_of(in);
  std::vector<double> incoming(std::size_t(in_starts.back() + in.back()));
  MPI_Alltoallv(outgoing.data(), out.data(), out_starts.data(), MPI_DOUBLE, incoming.data(), in.data(),
                in_starts.data(), MPI_DOUBLE, MPI_COMM_WORLD);
  return incoming;
}

std::vector<double> MpiWorld::gather_at_root(std::span<double const> numbers) const {
  if (size_ == 1)
    return {numbers.begin(), numbers.end()};
  int const own = int(numbers.size());
  std::vector<int> counts(is_root() ? std::size_t(size_) : 0);
  MPI_Gather(&own, 1, MPI_INT, counts.data(), 1, MPI_INT, 0, MPI_COMM_WORLD);
  auto const begins = begins_of(counts);
  std::vector<double> all(is_root() ? std::size_t(begins.back() + counts.back()) : 0);
  MPI_Gatherv(numbers.data(), own, MPI_DOUBLE, all.data(), counts.data(), begins.data(), MPI_DOUBLE, 0,
              MPI_COMM_WORLD);
  return all;
}

void MpiWorld::add_up(std::span<double> numbers) const {
  if (size_ > 1)
    MPI_Allreduce(MPI_IN_PLACE, numbers.data(), int(numbers.size()), MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
}

void MpiWorld::barrier() const {
  MPI_Barrier(MPI_COMM_WORLD);
}

void MpiWorld::abort(int exit_code) const {
  MPI_Abort(MPI_COMM_WORLD, exit_code);
  std::abort(); // MPI_Abort is not declared to end the process
}

} // namespace mesobridge::md
