#include "workflows/star/force_check.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace mesobridge::workflows {
namespace {

constexpr double most_apart = 0.01; // dumps have six digits, cut-offs are seldom smooth

} // namespace

ForceCheck::ForceCheck(cg::MoleculeModel const& model)
    : has_pairs_(std::ranges::any_of(model.pairs, [](auto const& law) { return law.cutoff() > 0; })) {}

void ForceCheck::add(Vec3 const& said, Vec3 const& by_pairs) {
  said_ += norm2(said), difference_ += norm2(said - by_pairs), count_ += 1;
}

double ForceCheck::apart() const {
  return said_ > 0 ? std::sqrt(difference_ / said_) : 0;
}

std::vector<std::string> ForceCheck::warnings() const {
  if (!has_pairs_ || apart() <= most_apart)
    return {};
  return {fmt::format(
      "the forces of the trajectory are not those of the mapping's pairs: they differ by {:.2g} of "
      "their root mean square; the trajectory's are taken",
      apart())};
}

void ForceCheck::put(Json& json) const {
  json["forces"] = count_ > 0 ? "trajectory" : has_pairs_ ? "pairs of the mapping" : "none";
  if (count_ > 0 && has_pairs_)
    json["forces_apart"] = apart();
}

} // namespace mesobridge::workflows
