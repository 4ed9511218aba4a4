#include "workflows/trajectory/bond_style.hpp"
#include <algorithm>
#include <fmt/ranges.h>

namespace mesobridge::workflows {

BondStyle const* bond_style_named(std::string_view name) {
  static std::vector<BondStyle> const styles{{"harmonic", {"K", "l"}},
                                             {"fene", {"K", "R0", "epsilon", "sigma"}}};
  auto const found = std::ranges::find(styles, name, &BondStyle::name);
  return found == styles.end() ? nullptr : &*found;
}

std::vector<double> bond_coefficients(md::InputLine const& line, BondStyle const& style) {
  std::vector<double> values;
  for (auto const* name : style.coefficients) {
    values.push_back(md::number_in(line, 2 + values.size(), name));
    bool const stiffness = values.size() == 1;
    if (!(stiffness ? values.back() > 0 : values.back() >= 0))
      md::refuse_line(line, fmt::format("'{}': {} = {}: must be {} 0", line.text(), name, values.back(),
                                        stiffness ? ">" : ">="));
  }
  if (line.words.size() != 2 + values.size())
    md::refuse_line(line, fmt::format("'{}': bond_style {} has the {} coefficients {}", line.text(),
                                      style.name, values.size(), fmt::join(style.coefficients, ", ")));
  return values;
}

} // namespace mesobridge::workflows
