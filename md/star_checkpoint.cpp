#include "md/star_checkpoint.hpp"
#include "md/star_system.hpp"

namespace mesobridge::md {

void write_checkpoint(MpiWorld const& world, LammpsSession& lammps, std::filesystem::path const& file,
                      std::function<void()> const& before_it_counts) {
  auto const fresh = file.string() + ".new";
  lammps.command("write_restart \"{}\"", fresh);
  if (before_it_counts)
    before_it_counts();
  world.barrier();
  if (world.is_root())
    std::filesystem::rename(fresh, file);
  world.barrier();
}

std::int64_t step_to_begin_at(MpiWorld const& world, StarPolymer const& star,
                              std::filesystem::path const& file, std::filesystem::path const& log,
                              bool resume) {
  if (world.is_root() && !resume)
    std::filesystem::remove(file);
  if (!world.root_says(resume && std::filesystem::exists(file)))
    return 0;
  LammpsSession lammps(world, Ranks::all, log, Log::append);
  prepare_for_stars(lammps, star);
  lammps.command("read_restart \"{}\"", file.string());
  return lammps.step();
}

} // namespace mesobridge::md
