#include "workflows/job_pool.hpp"
#include <atomic>
#include <exception>
#include <thread>

namespace mesobridge::workflows {

void run_jobs(std::vector<std::function<void()>> const& jobs, int threads) {
  std::vector<std::exception_ptr> errors(jobs.size());
  std::atomic<std::size_t> next = 0;
  std::atomic<bool> failed = false;
  auto work = [&] {
    for (std::size_t k; !failed && (k = next++) < jobs.size();) {
      try {
        jobs[k]();
      } catch (...) {
        errors[k] = std::current_exception();
        failed = true;
      }
    }
  };
  {
    std::vector<std::jthread> workers;
    for (int t = 0; t < threads; ++t)
      workers.emplace_back(work);
  }
  for (auto const& error : errors)
    if (error)
      std::rethrow_exception(error);
}

} // namespace mesobridge::workflows
