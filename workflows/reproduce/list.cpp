#include "workflows/reproduce/list.hpp"

namespace mesobridge::workflows {

// clang-format off
std::vector<Reproduction> const& reproductions() {
  static std::vector<Reproduction> const list{
      {"table-4.1", "time per particle and step of the schemes", reproduce_table_4_1},
  };
  return list;
}
// clang-format on

} // namespace mesobridge::workflows
