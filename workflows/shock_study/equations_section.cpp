#include "workflows/report/check.hpp"
#include "workflows/report/number_text.hpp"
#include "workflows/shock_study/shock_quantities.hpp"
#include "workflows/summary.hpp"
#include <algorithm>
#include <fmt/ranges.h>

namespace mesobridge::workflows {
namespace {

double error_of(NamedShock const& one, ShockQuantity const& quantity) {
  return one.se ? (*one.se).*quantity.error : 0;
}

/// Molecular dynamics less the cut potential, in standard errors of the difference.
double in_errors(ShockRow const& md, NamedShock const& one, ShockQuantity const& quantity) {
  auto const found = judged(md, quantity);
  return (found.mean - quantity.of_shock(one.cut)) / std::hypot(found.se, error_of(one, quantity));
}

std::vector<std::string> cells_of(NamedShock const& one, ShockRow const* md) {
  std::vector<std::string> cells{one.name};
  for (auto const& quantity : shock_quantities()) {
    double const x = quantity.of_shock(one.cut), se = error_of(one, quantity);
    cells.push_back(one.se ? with_error_text({x * quantity.factor, se * quantity.factor, 0})
                           : digits_of(quantity, x));
    if (md)
      cells.push_back(fmt::format("{:+.1f}", in_errors(*md, one, quantity)));
  }
  return cells;
}

/// Which are farther than chance allows, and in what.
std::string sentence_of(ShockRow const& md, std::vector<NamedShock> const& equations) {
  double const allowed = allowed_deviation(4 * equations.size());
  std::vector<std::string> off, near;
  for (auto const& one : equations) {
    std::vector<std::string> in;
    for (auto const& quantity : shock_quantities())
      if (double const far = in_errors(md, one, quantity); std::abs(far) > allowed)
        in.push_back(fmt::format("{} by {:+.1f}", quantity.name, -far));
    (in.empty() ? near : off)
        .push_back(in.empty() ? one.name : fmt::format("{} ({})", one.name, fmt::join(in, ", ")));
  }
  auto const list = [](std::vector<std::string> const& names) {
    return names.empty() ? std::string("none") : fmt::format("{}", fmt::join(names, "; "));
  };
  return fmt::format("Farther from molecular dynamics than {:.1f} standard errors: {}. Within them: {}.",
                     allowed, list(off), list(near));
}

} // namespace

Section equations_section(ShockRow const* md, std::vector<NamedShock> const& equations) {
  Table table{.header = {"equation of state"},
              .caption =
                  "By the relations of Rankine and Hugoniot, for the potential that molecular dynamics "
                  "has: cut, without a tail, for which the mean field of what lies beyond is taken "
                  "away. MD -: molecular dynamics less the equation, in standard errors of the "
                  "difference."};
  for (auto const& quantity : shock_quantities()) {
    table.header.push_back(fmt::format("{} [{}]", quantity.name, quantity.unit));
    if (md)
      table.header.emplace_back("MD -");
  }
  for (auto const& one : equations)
    table.rows.push_back(cells_of(one, md));
  Section section{"Which equation of state is off", {}};
  if (md) {
    std::vector<std::string> cells{"molecular dynamics"};
    for (auto const& quantity : shock_quantities()) {
      auto const found = judged(*md, quantity);
      cells.push_back(
          with_error_text({found.mean * quantity.factor, found.se * quantity.factor, found.n_eff}));
      cells.emplace_back();
    }
    table.rows.insert(table.rows.begin(), std::move(cells));
    section.content.emplace_back(Paragraph{sentence_of(*md, equations)});
  }
  section.content.emplace_back(std::move(table));
  return section;
}

Json equations_json(ShockRow const* md, std::vector<NamedShock> const& equations) {
  Json list = Json::array();
  for (auto const& one : equations) {
    Json of{{"equation", one.key}, {"name", one.name}};
    for (auto const& quantity : shock_quantities()) {
      of[quantity.key] = quantity.of_shock(one.shock);
      of["cut_potential"][quantity.key] = quantity.of_shock(one.cut);
      if (one.se)
        of[quantity.key + "_se"] = error_of(one, quantity);
      if (md)
        of["md_less_cut_potential_in_se"][quantity.name] = in_errors(*md, one, quantity);
    }
    list.push_back(std::move(of));
  }
  return list;
}

} // namespace mesobridge::workflows
