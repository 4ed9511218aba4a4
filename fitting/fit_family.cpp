#include "fitting/fit_family.hpp"

namespace mesobridge::fitting {

std::vector<FittableKind> fittable_kinds() {
  std::vector<FittableKind> kinds;
  for_each_described_model([&]<class Model>() {
    auto const& description = Model::description();
    if (description.fittable())
      kinds.push_back({std::string(description.kind), std::string(description.material),
                       std::string(description.example), family_of<Model>});
  });
  return kinds;
}

} // namespace mesobridge::fitting
