#include "workflows/earlier_results.hpp"
#include "md/error.hpp"
#include "md/mpi_world.hpp"
#include "workflows/command.hpp"
#include "workflows/ranks.hpp"
#include <algorithm>
#include <fmt/format.h>
#include <spdlog/spdlog.h>

namespace mesobridge::workflows {
namespace {

namespace fs = std::filesystem;

fs::path new_backup(fs::path const& folder) {
  int number = 1;
  auto const backup = [&] { return folder / fmt::format("backup-{}", number); };
  while (fs::exists(backup()))
    ++number;
  std::error_code error;
  if (!fs::create_directory(backup(), error))
    throw EnvironmentError(fmt::format("cannot create '{}': {}", backup().string(), error.message()));
  return backup();
}

void move_into(fs::path const& folder, fs::path const& file) {
  std::error_code error;
  fs::rename(file, folder / file.filename(), error);
  if (error)
    throw EnvironmentError(
        fmt::format("cannot move '{}' into '{}': {}", file.string(), folder.string(), error.message()));
}

} // namespace

fs::path set_aside(fs::path const& folder, std::vector<fs::path> const& files) {
  fs::path backup;
  for (auto const& file : files) {
    if (!fs::exists(file))
      continue;
    if (backup.empty())
      backup = new_backup(folder);
    move_into(backup, file);
  }
  return backup;
}

void keep_earlier_results(Context const& context, bool started_by_ourselves, fs::path const& folder,
                          std::vector<fs::path> const& files) {
  // This process must not become a rank of MPI when it is to start the ranks.
  if (started_by_ourselves || (!must_start_ranks(context) && !md::MpiWorld().is_root()))
    return;
  auto const is_result = [](fs::path const& file) { return file.extension() != ".log" && fs::exists(file); };
  if (std::ranges::none_of(files, is_result)) // a log alone is of a call that came to nothing
    return;
  if (auto const backup = set_aside(folder, files); !backup.empty())
    context.log->info("what was in '{}' is in '{}' now", folder.string(), backup.string());
}

} // namespace mesobridge::workflows
