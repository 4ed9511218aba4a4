#include "workflows/coarse/molecule_forces.hpp"
#include "md/error.hpp"
#include "workflows/coarse/friction_output.hpp"
#include "workflows/coarse/structure_of_blobs.hpp"
#include "workflows/star/held_file.hpp"

namespace mesobridge::workflows {
namespace {

ForcesOfFile forces_on_blobs(std::filesystem::path const& file, double bin_width) {
  auto data = read_blobs(file);
  refuse_walls(data.head, file, "a potential");
  ForcesOfFile found{.head = data.head, .structure = structure_of(data, bin_width), .forces = {}};
  found.forces = {.molecules = std::size_t(data.head.molecules),
                  .boxes = std::move(data.boxes),
                  .R = std::move(data.R),
                  .F = read_blob_forces(file)};
  return found;
}

ForcesOfFile forces_on_held(std::filesystem::path const& file, double bin_width) {
  auto const data = read_held(file);
  ForcesOfFile found{.head = data.head, .structure = {}, .forces = {}};
  auto& forces = found.forces;
  forces.molecules = data.molecules(), forces.independent = true;
  auto const all = configurations_of(data);
  require(!all.empty(), "whole configurations", all.size(), "at least 1 is needed");
  double kT = 0;
  for (auto const& one : all) {
    kT += one.kT / double(all.size());
    forces.boxes.push_back(one.box);
    forces.R.insert(forces.R.end(), one.R.begin(), one.R.end());
    std::vector<Vec3> mean(forces.molecules);
    double const frames = double(data.frames_of_each);
    for (std::size_t k = 0; k < one.F.size(); ++k)
      mean[k % forces.molecules] += one.F[k] / frames;
    forces.F.insert(forces.F.end(), mean.begin(), mean.end());
  }
  found.structure = structure_of(data.head, forces.boxes, forces.R, kT, bin_width);
  return found;
}

} // namespace

ForcesOfFile read_forces(std::filesystem::path const& file, double bin_width) {
  return holds_held(file) ? forces_on_held(file, bin_width) : forces_on_blobs(file, bin_width);
}

} // namespace mesobridge::workflows
