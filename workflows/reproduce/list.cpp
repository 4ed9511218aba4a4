#include "workflows/reproduce/list.hpp"

namespace mesobridge::workflows {

// clang-format off
std::vector<Reproduction> const& reproductions() {
  static std::vector<Reproduction> const list{
      {"table-5.1", "pressure, density, temperatures over the particle size", reproduce_table_5_1},
  };
  return list;
}
// clang-format on

} // namespace mesobridge::workflows
