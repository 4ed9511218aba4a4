#include "workflows/trajectory/force_check.hpp"
#include <cmath>
#include <fmt/format.h>

namespace mesobridge::workflows {
namespace {

constexpr double digits = 1e-4;     // of the forces in a dump, with room
constexpr double most_apart = 0.01; // dumps have six digits, cut-offs are seldom smooth

} // namespace

void ForceCheck::add(Vec3 const& said, Vec3 const& by_laws, std::span<Vec3 const> of_atoms) {
  said_ += norm2(said), difference_ += norm2(said - by_laws), count_ += 1;
  for (Vec3 const& f : of_atoms)
    of_atoms_ += norm2(f);
}

/// Of molecules that do not touch what is said is round-off of their atoms' forces.
bool ForceCheck::differ() const {
  return has_pairs_ && difference_ > most_apart * most_apart * said_ + digits * digits * of_atoms_;
}

double ForceCheck::apart() const {
  return said_ > 0 ? std::sqrt(difference_ / said_) : 0;
}

std::vector<std::string> ForceCheck::warnings() const {
  if (!differ())
    return {};
  return {fmt::format(
      "the forces of the trajectory are not those of the mapping's laws: they differ by {:.2g} of "
      "their root mean square (those of a Langevin thermostat are in them, too); the trajectory's are taken",
      apart())};
}

void ForceCheck::put(Json& json) const {
  json["forces"] = count_ > 0 ? "trajectory" : has_pairs_ ? "laws of the mapping" : "none";
  if (count_ > 0 && has_pairs_)
    json["forces_apart"] = apart();
}

} // namespace mesobridge::workflows
