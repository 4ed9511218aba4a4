#include "workflows/resources.hpp"
#include <algorithm>
#include <fstream>
#include <limits>
#include <string>
#include <sys/resource.h>
#include <unistd.h>

namespace mesobridge::workflows {
namespace {

namespace fs = std::filesystem;
constexpr double unlimited = std::numeric_limits<double>::infinity();

/// The number that follows a word at the beginning of a line, or the fallback.
double number_after(fs::path const& file, std::string const& word, double fallback) {
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);)
    if (line.starts_with(word))
      if (double const value = std::strtod(line.c_str() + word.size(), nullptr); value > 0)
        return value;
  return fallback;
}

double free_on_machine() {
  constexpr double kB = 1024;
  return kB * (number_after("/proc/meminfo", "MemAvailable:", unlimited) +
               number_after("/proc/meminfo", "SwapFree:", 0));
}

double free_address_space() {
  rlimit limit{};
  if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY)
    return unlimited;
  double const pages = number_after("/proc/self/statm", "", 0);
  return std::max(0.0,
                  static_cast<double>(limit.rlim_cur) - pages * static_cast<double>(sysconf(_SC_PAGESIZE)));
}

/// Of one control group; pages of files that it can drop at once count as free.
double free_in(fs::path const& group, char const* limit, char const* used, char const* droppable) {
  double const most = number_after(group / limit, "", unlimited); // "max" is no number
  double const taken = number_after(group / used, "", 0) - number_after(group / "memory.stat", droppable, 0);
  return std::max(0.0, most - taken);
}

/// Of the groups of this process and all above them, for both versions of the interface.
double free_in_groups() {
  double least = unlimited;
  std::ifstream groups("/proc/self/cgroup");
  for (std::string line; std::getline(groups, line);) { // "0::/user.slice", "5:memory:/batch"
    auto const first = line.find(':'), second = line.find(':', first + 1);
    if (second == std::string::npos)
      continue;
    auto const controller = line.substr(first + 1, second - first - 1);
    bool const unified = controller.empty();
    if (!unified && controller != "memory")
      continue;
    fs::path const root = unified ? "/sys/fs/cgroup" : "/sys/fs/cgroup/memory";
    for (auto path = fs::path(line.substr(second + 1)).relative_path();; path = path.parent_path()) {
      least = std::min(least, unified ? free_in(root / path, "memory.max", "memory.current", "inactive_file ")
                                      : free_in(root / path, "memory.limit_in_bytes", "memory.usage_in_bytes",
                                                "total_inactive_file "));
      if (path.empty())
        break;
    }
  }
  return least;
}

} // namespace

double available_memory() {
  return std::min({free_on_machine(), free_address_space(), free_in_groups()});
}

double available_disk(fs::path const& folder) {
  std::error_code error;
  auto existing = fs::absolute(folder, error);
  while (!fs::exists(existing, error) && existing.has_relative_path())
    existing = existing.parent_path();
  auto const space = fs::space(existing, error);
  return error ? unlimited : static_cast<double>(space.available);
}

} // namespace mesobridge::workflows
