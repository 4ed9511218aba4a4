#include "workflows/sdpd/shortage.hpp"
#include "workflows/resources.hpp"
#include "workflows/sdpd/run_checks.hpp"
#include <fmt/ranges.h>

namespace mesobridge::workflows {
namespace {

double bytes_in(std::filesystem::path const& folder) {
  double bytes = 0;
  std::error_code error;
  for (auto const& entry : std::filesystem::directory_iterator(folder, error))
    if (entry.is_regular_file(error))
      bytes += static_cast<double>(entry.file_size(error));
  return bytes;
}

} // namespace

std::vector<std::string> shortages(CostEstimate const& cost, DiskEstimate const& disk,
                                   std::filesystem::path const& folder) {
  std::vector<std::string> lacking;
  double const memory = available_memory();
  if (cost.bytes > memory)
    lacking.push_back(fmt::format("the run needs about {} of memory, and {} are free", bytes_text(cost.bytes),
                                  bytes_text(memory)));
  double const room = available_disk(folder);
  if (disk.total() > room + bytes_in(folder))
    lacking.push_back(fmt::format("the run writes about {} into '{}', where {} are free",
                                  bytes_text(disk.total()), folder.string(), bytes_text(room)));
  return lacking;
}

std::filesystem::path results_folder(std::optional<std::filesystem::path> const& output, Scene const& scene,
                                     std::filesystem::path const& file) {
  return output.value_or(scene.output.directory.value_or("out/" + file.stem().string()));
}

void refuse_shortages(Scene const& scene, int threads, std::filesystem::path const& folder, Engine engine) {
  auto const lacking = shortages(estimate_cost(scene, threads, engine), estimate_disk(scene), folder);
  if (!lacking.empty())
    throw EnvironmentError(fmt::format("{}", fmt::join(lacking, "; ")));
}

} // namespace mesobridge::workflows
