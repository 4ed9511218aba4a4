#include "md/equal_molecules.hpp"
#include "md/spanning_steps.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/os.h>
#include <map>
#include <optional>

namespace mesobridge::md {
namespace {

/// A molecule's atoms as places in the data file's list.
using Members = std::map<std::int64_t, std::vector<std::size_t>>;

Members members_of(DataFile const& data) {
  Members members;
  for (std::size_t i = 0; i < data.atoms.size(); ++i) {
    auto const& atom = data.atoms[i];
    require(atom.molecule > 0, fmt::format("{}: molecule of atom {}", data.file.string(), atom.id),
            atom.molecule, "must be > 0: each atom belongs to one");
    members[atom.molecule].push_back(i);
  }
  for (auto& [number, list] : members)
    std::ranges::sort(list, {}, [&](std::size_t i) { return data.atoms[i].id; });
  return members;
}

struct Place {
  std::int64_t molecule;
  int atom; ///< in the molecule
};

std::map<std::int64_t, Place> places_of(DataFile const& data, Members const& members) {
  std::map<std::int64_t, Place> places;
  for (auto const& [number, list] : members)
    for (std::size_t k = 0; k < list.size(); ++k)
      if (auto const id = data.atoms[list[k]].id; !places.try_emplace(id, Place{number, int(k)}).second)
        throw InputError(fmt::format("{}: atom {} is there twice", data.file.string(), id));
  return places;
}

/// The term with the atoms of the molecule, in the one of its two orders that comes first. An improper has
/// but one.
BondedTerm within_molecule(BondedTerm term, std::size_t kind) {
  auto const n = bonded_atoms[kind];
  auto turned = term;
  std::reverse(turned.atoms.begin(), turned.atoms.begin() + std::ptrdiff_t(n));
  return bonded_kinds[kind] == Bonded::improper ? term : std::min(term, turned);
}

using Terms = std::array<std::vector<BondedTerm>, 4>;

/// The bonded terms of each molecule, sorted.
std::map<std::int64_t, Terms> terms_of(DataFile const& data, Members const& members) {
  auto const places = places_of(data, members);
  std::map<std::int64_t, Terms> terms;
  for (std::size_t kind = 0; kind < 4; ++kind)
    for (auto term : data.bonded[kind]) {
      std::int64_t molecule = 0;
      for (std::size_t k = 0; k < bonded_atoms[kind]; ++k) {
        auto const place = places.find(term.atoms[k]);
        require(place != places.end(),
                fmt::format("{}: atom of a {}", data.file.string(), bonded_names[kind]), term.atoms[k],
                "no atom has this number");
        if (k > 0 && place->second.molecule != molecule)
          throw InputError(fmt::format("{}: a {} joins atoms {} and {} of the molecules {} and {}: give them "
                                       "one number",
                                       data.file.string(), bonded_names[kind], term.atoms[0], place->first,
                                       molecule, place->second.molecule));
        molecule = place->second.molecule;
      }
      for (std::size_t k = 0; k < bonded_atoms[kind]; ++k)
        term.atoms[k] = places.at(term.atoms[k]).atom;
      terms[molecule][kind].push_back(within_molecule(term, kind));
    }
  for (auto& [number, of_molecule] : terms)
    for (auto& list : of_molecule)
      std::ranges::sort(list);
  return terms;
}

MoleculeKind kind_of(DataFile const& data, std::vector<std::size_t> const& list, Terms terms) {
  MoleculeKind kind{.name = data.file.stem().string(),
                    .atom_style = data.atom_style,
                    .types = {},
                    .charges = {},
                    .masses_of_types = data.masses,
                    .bonded_types = data.bonded_types,
                    .bonded = std::move(terms)};
  for (auto const i : list)
    kind.types.push_back(data.atoms[i].type), kind.charges.push_back(data.atoms[i].charge);
  return kind;
}

/// What differs between two kinds; without a value: nothing.
std::optional<std::string> difference(MoleculeKind const& first, MoleculeKind const& other) {
  if (other.atoms() != first.atoms())
    return fmt::format("the number of atoms, {} and {}", other.atoms(), first.atoms());
  for (std::size_t i = 0; i < first.types.size(); ++i) {
    if (other.types[i] != first.types[i])
      return fmt::format("the type of its atom {}, {} and {}", i + 1, other.types[i], first.types[i]);
    if (other.charges[i] != first.charges[i])
      return fmt::format("the charge of its atom {}, {} and {}", i + 1, other.charges[i], first.charges[i]);
  }
  for (std::size_t kind = 0; kind < 4; ++kind)
    if (other.bonded[kind] != first.bonded[kind])
      return fmt::format("its {}s", bonded_names[kind]);
  return std::nullopt;
}

std::vector<std::pair<int, int>> bonds_of(MoleculeKind const& kind) {
  std::vector<std::pair<int, int>> bonds;
  for (auto const& term : kind.bonded[std::size_t(Bonded::bond)])
    bonds.emplace_back(int(term.atoms[0]), int(term.atoms[1]));
  return bonds;
}

/// Brings each molecule together, wherever the borders of the box have cut it.
void join(Molecules& molecules) {
  auto const n = std::size_t(molecules.kind.atoms());
  auto const steps = spanning_steps(molecules.kind.atoms(), bonds_of(molecules.kind));
  for (std::size_t m = 0; m < molecules.q.size(); m += n)
    for (auto const& [from, to] : steps) {
      Vec3 const a = molecules.q[m + std::size_t(from)];
      Vec3& b = molecules.q[m + std::size_t(to)];
      b = a + molecules.box.minimum_image(molecules.box.wrap(b) - molecules.box.wrap(a));
    }
}

} // namespace

std::vector<double> MoleculeKind::masses() const {
  std::vector<double> list;
  for (int const type : types)
    list.push_back(masses_of_types[std::size_t(type - 1)]);
  return list;
}

std::vector<Molecules> molecules_by_kind(DataFile const& data) {
  auto const members = members_of(data);
  auto terms = terms_of(data, members);
  std::vector<Molecules> kinds;
  for (auto const& [number, list] : members) {
    auto kind = kind_of(data, list, terms[number]);
    auto at = std::ranges::find_if(kinds, [&](Molecules const& of) { return !difference(of.kind, kind); });
    if (at == kinds.end())
      at = kinds.insert(at, {.kind = std::move(kind), .box = data.box, .q = {}});
    ++at->count;
    for (auto const i : list)
      at->ids.push_back(data.atoms[i].id), at->q.push_back(data.atoms[i].q - data.low);
  }
  for (std::size_t type = 0; type < data.masses.size(); ++type)
    require(data.masses[type] > 0, data.file.string(), fmt::format("mass of atom type {}", type + 1),
            "must be there, in a section 'Masses' or as 'mass' in the settings");
  for (auto& molecules : kinds)
    join(molecules);
  return kinds;
}

Molecules equal_molecules(DataFile const& data) {
  auto kinds = molecules_by_kind(data);
  if (kinds.size() > 1) {
    auto const number_of = [&](Molecules const& of) {
      return std::ranges::find(data.atoms, of.ids[0], &DataAtom::id)->molecule;
    };
    throw InputError(
        fmt::format("{}: molecule {} differs from molecule {} in {}: all must be equal, with their "
                    "atoms in the same order (a trajectory of several kinds: cg mapping --kind)",
                    data.file.string(), number_of(kinds[1]), number_of(kinds[0]),
                    *difference(kinds[0].kind, kinds[1].kind)));
  }
  return std::move(kinds[0]);
}

Molecules replicated(Molecules const& molecules, std::array<int, 3> const& times) {
  auto const& edge = molecules.box.edge;
  Molecules more{.kind = molecules.kind,
                 .count = molecules.count * times[0] * times[1] * times[2],
                 .box = {{edge.x * times[0], edge.y * times[1], edge.z * times[2]}},
                 .q = {}};
  for (int z = 0; z < times[2]; ++z)
    for (int y = 0; y < times[1]; ++y)
      for (int x = 0; x < times[0]; ++x)
        for (Vec3 const& q : molecules.q)
          more.q.push_back(q + Vec3{x * edge.x, y * edge.y, z * edge.z});
  return more;
}

double mean_width(Molecules const& molecules) {
  auto const n = std::size_t(molecules.kind.atoms());
  double sum = 0;
  for (std::size_t m = 0; m < molecules.q.size(); m += n) {
    auto low = molecules.q[m], high = low;
    for (std::size_t i = m; i < m + n; ++i) {
      auto const& q = molecules.q[i];
      low = {std::min(low.x, q.x), std::min(low.y, q.y), std::min(low.z, q.z)};
      high = {std::max(high.x, q.x), std::max(high.y, q.y), std::max(high.z, q.z)};
    }
    sum += std::max({high.x - low.x, high.y - low.y, high.z - low.z});
  }
  return sum / molecules.count;
}

void write_data_file(std::filesystem::path const& file, MoleculeKind const& kind, std::span<Vec3 const> q,
                     Box const& box) {
  write_data_file(file, {{&kind, q.size() / std::size_t(kind.atoms())}}, q, box);
}

namespace {

void write_head(fmt::ostream& out, std::vector<CountedKind> const& parts, std::size_t atoms, Box const& box) {
  auto const& first = *parts[0].kind;
  out.print("molecules\n\n{} atoms\n{} atom types\n", atoms, first.masses_of_types.size());
  for (std::size_t k = 0; k < 4; ++k) {
    std::size_t terms = 0;
    for (auto const& [kind, count] : parts)
      terms += count * kind->bonded[k].size();
    if (first.bonded_types[k] > 0)
      out.print("{0} {1}s\n{2} {1} types\n", terms, bonded_names[k], first.bonded_types[k]);
  }
  out.print("0 {} xlo xhi\n0 {} ylo yhi\n0 {} zlo zhi\n", box.edge.x, box.edge.y, box.edge.z);
  if (box.tilted())
    out.print("{} {} {} xy xz yz\n", box.xy, box.xz, box.yz);
  out.print("\nMasses\n\n");
  for (std::size_t type = 0; type < first.masses_of_types.size(); ++type)
    out.print("{} {}\n", type + 1, first.masses_of_types[type]);
}

void write_atoms(fmt::ostream& out, std::vector<CountedKind> const& parts, std::span<Vec3 const> q,
                 Box const& box) {
  out.print("\nAtoms # {}\n\n", parts[0].kind->atom_style);
  std::size_t at = 0, molecule = 0;
  for (auto const& [kind, count] : parts)
    for (std::size_t m = 0; m < count; ++m) {
      ++molecule;
      for (std::size_t i = 0; i < kind->types.size(); ++i, ++at) {
        out.print("{} {} {}", at + 1, molecule, kind->types[i]);
        if (kind->atom_style == "full")
          out.print(" {}", kind->charges[i]);
        Vec3 const inside = box.wrap(q[at]);
        out.print(" {} {} {}\n", inside.x, inside.y, inside.z);
      }
    }
}

/// Those of one of the four kinds of bonded terms.
void write_terms(fmt::ostream& out, std::vector<CountedKind> const& parts, std::size_t k) {
  if (std::ranges::all_of(parts, [&](auto const& part) { return part.kind->bonded[k].empty(); }))
    return;
  std::string const name = bonded_names[k];
  out.print("\n{}{}s\n\n", char(name[0] - 'a' + 'A'), name.substr(1));
  std::size_t id = 0, first = 0;
  for (auto const& [kind, count] : parts)
    for (std::size_t m = 0; m < count; ++m, first += kind->types.size())
      for (auto const& term : kind->bonded[k]) {
        out.print("{} {}", ++id, term.type);
        for (std::size_t a = 0; a < bonded_atoms[k]; ++a)
          out.print(" {}", first + std::size_t(term.atoms[a]) + 1);
        out.print("\n");
      }
}

} // namespace

void write_data_file(std::filesystem::path const& file, std::vector<CountedKind> const& parts,
                     std::span<Vec3 const> q, Box const& box) {
  auto out = fmt::output_file(file.string());
  write_head(out, parts, q.size(), box);
  write_atoms(out, parts, q, box);
  for (std::size_t k = 0; k < 4; ++k)
    write_terms(out, parts, k);
}

} // namespace mesobridge::md
