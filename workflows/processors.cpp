#include "workflows/processors.hpp"
#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <sched.h>
#include <sstream>
#include <thread>

namespace mesobridge::workflows {
namespace {

constexpr double no_limit = std::numeric_limits<double>::infinity();

std::string content(std::filesystem::path const& file) {
  std::ifstream in(file);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

double quota_of(double microseconds, double period) {
  return microseconds > 0 && period > 0 ? microseconds / period : no_limit;
}

/// "150000 100000", or "max 100000" where there is no limit.
double quota_of_version_2(std::filesystem::path const& group) {
  std::istringstream in(content(group / "cpu.max"));
  double quota = 0, period = 0;
  return in >> quota >> period ? quota_of(quota, period) : no_limit;
}

/// A quota of -1 is none.
double quota_of_version_1(std::filesystem::path const& group) {
  double quota = 0, period = 0;
  std::istringstream in(content(group / "cpu.cfs_quota_us") + " " + content(group / "cpu.cfs_period_us"));
  return in >> quota >> period ? quota_of(quota, period) : no_limit;
}

template <class Quota>
double least_up_to_root(std::filesystem::path const& root, std::filesystem::path path, Quota const& quota) {
  double least = quota(root);
  for (path = path.relative_path(); !path.empty(); path = path.parent_path())
    least = std::min(least, quota(root / path));
  return least;
}

} // namespace

double processor_quota(std::string const& groups, std::filesystem::path const& root) {
  double least = no_limit;
  std::istringstream lines(groups); // "0::/path", or "4:cpu,cpuacct:/path" of version 1
  for (std::string line; std::getline(lines, line);) {
    auto const first = line.find(':'), second = line.find(':', first + 1);
    if (first == std::string::npos || second == std::string::npos)
      continue;
    auto const controllers = line.substr(first + 1, second - first - 1), path = line.substr(second + 1);
    if (controllers.empty())
      least = std::min(least, least_up_to_root(root, path, quota_of_version_2));
    else if (("," + controllers + ",").find(",cpu,") != std::string::npos)
      for (auto const& name : {controllers, std::string("cpu")})
        least = std::min(least, least_up_to_root(root / name, path, quota_of_version_1));
  }
  return least;
}

int available_processors() {
  cpu_set_t set;
  CPU_ZERO(&set);
  int const allowed = sched_getaffinity(0, sizeof set, &set) == 0
                          ? CPU_COUNT(&set)
                          : static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  double const quota = processor_quota(content("/proc/self/cgroup"), "/sys/fs/cgroup");
  return std::max(1, static_cast<int>(std::min<double>(allowed, std::floor(quota))));
}

} // namespace mesobridge::workflows
