#include "workflows/trajectory/dump_columns.hpp"

namespace mesobridge::workflows {

DumpColumns::DumpColumns(std::string_view names, DumpLines const& lines) {
  for (auto const& word : words_of(names))
    if (!places_.emplace(std::string(word), places_.size()).second)
      lines.refuse(fmt::format("the column '{}' stands there twice", word));
  count_ = places_.size();
  id = need("id", lines);
  molecule = find("mol"), type = find("type"), mass = find("mass");
  for (char const* name : {"c_pe", "pe", "v_pe", "c_peatom", "c_pe_atom", "c_epot", "c_eng"})
    if (!potential)
      potential = find(name);
  for (std::string const suffix : {"u", "", "su", "s"})
    if (find("x" + suffix)) {
      scaled = suffix.starts_with('s');
      q = {need("x" + suffix, lines), need("y" + suffix, lines), need("z" + suffix, lines)};
      break;
    } else if (suffix == "s") {
      lines.refuse("the dump has no positions: x y z, xu yu zu, xs ys zs or xsu ysu zsu");
    }
  for (char const* name : {"vx", "vy", "vz"})
    if (!find(name))
      lines.refuse(
          fmt::format("the dump has no column {}: momenta and kinetic energies need vx vy vz", name));
  v = {*find("vx"), *find("vy"), *find("vz")};
  if (find("fx") && find("fy") && find("fz"))
    f = {*find("fx"), *find("fy"), *find("fz")};
}

std::optional<std::size_t> DumpColumns::find(std::string const& name) const {
  auto const found = places_.find(name);
  return found == places_.end() ? std::nullopt : std::optional(found->second);
}

std::size_t DumpColumns::need(std::string const& name, DumpLines const& lines) const {
  auto const found = find(name);
  if (!found)
    lines.refuse(fmt::format("the dump has no column {}", name));
  return *found;
}

} // namespace mesobridge::workflows
