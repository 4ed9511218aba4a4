#include "workflows/star/lammps_dump.hpp"
#include "workflows/star/dump_columns.hpp"
#include <algorithm>
#include <set>
#include <span>

namespace mesobridge::workflows {

namespace {

struct Atom {
  std::int64_t id = 0, molecule = 0, type = 0;
  double mass = 0;
  Vec3 q, v, f;
};

class DumpReader {
 public:
  DumpReader(std::filesystem::path const& file, TrajectoryReading const& how)
      : file_(file), how_(how), lines_(file), file_size_(std::filesystem::file_size(file)) {}

  void read_all(std::function<void(TrajectoryFrame const&)> const& consume) {
    for (std::size_t frames = 0;; ++frames) {
      TrajectoryFrame frame;
      bool begun = false;
      try {
        read_frame(frame, begun);
      } catch (EndOfFile const&) {
        if (begun || frames == 0)
          end_inside(frames);
        return;
      }
      consume(frame);
    }
  }

 private:
  void end_inside(std::size_t whole_frames) const {
    if (whole_frames == 0)
      throw InputError(fmt::format("{}:{}: the file ends inside its first frame, or its last line has no end",
                                   file_.string(), lines_.number() + 1));
    how_.warn(fmt::format("{}:{}: the file ends inside a frame: its {} whole frames are used", file_.string(),
                          lines_.number() + 1, whole_frames));
  }

  /// Items in any order up to ITEM: ATOMS, the last one of a frame.
  void read_frame(TrajectoryFrame& frame, bool& begun) {
    std::optional<std::size_t> atoms;
    std::optional<Vec3> low;
    bool has_step = false;
    for (;;) {
      std::string const head = lines_.next();
      if (!begun && words_of(head).empty())
        continue; // between frames
      begun = true;
      if (!head.starts_with("ITEM: "))
        lines_.refuse("must begin with 'ITEM:': only LAMMPS's text dumps are read");
      auto const item = std::string_view(head).substr(6);
      if (item.starts_with("UNITS"))
        check_units(lines_.next());
      else if (item == "TIME")
        frame.time = one<double>("the time");
      else if (item == "TIMESTEP")
        frame.step = one<std::int64_t>("the step"), has_step = true;
      else if (item == "NUMBER OF ATOMS")
        atoms = number_of_atoms();
      else if (item.starts_with("BOX BOUNDS"))
        low = read_box(item.substr(10), frame);
      else if (item.starts_with("ATOMS")) {
        if (!has_step || !atoms || !low)
          lines_.refuse("ITEM: TIMESTEP, NUMBER OF ATOMS and BOX BOUNDS must stand before");
        read_atoms(DumpColumns(item.substr(5), lines_), *atoms, *low, frame);
        return;
      } else
        lines_.refuse(fmt::format("the item '{}' is not known: TIMESTEP, TIME, UNITS, NUMBER OF ATOMS, BOX "
                                  "BOUNDS and ATOMS are read",
                                  item));
    }
  }

  template <class Number>
  Number one(std::string const& what) {
    auto const words = words_of(lines_.next());
    if (words.size() != 1)
      lines_.refuse(fmt::format("must be one number, {}", what));
    return lines_.as<Number>(words[0], what);
  }

  std::size_t number_of_atoms() {
    auto const atoms = one<std::int64_t>("the number of atoms");
    constexpr std::uintmax_t shortest_line = 8; // an id, three positions
    if (atoms <= 0 || std::uintmax_t(atoms) > file_size_ / shortest_line)
      lines_.refuse(
          fmt::format("{} atoms: must be at least one, and no more than the file of {} bytes can hold", atoms,
                      file_size_));
    auto const each = std::int64_t(how_.atoms_per_molecule);
    if (atoms % each != 0)
      throw InputError(
          fmt::format("'{}' has {} atoms, the mapping's molecules {} each: {} atoms are left out. "
                      "Map every atom",
                      file_.string(), atoms, each, atoms % each));
    return std::size_t(atoms);
  }

  void check_units(std::string const& text) {
    auto const words = words_of(text);
    std::string const name(words.empty() ? "" : words[0]);
    if (name != how_.units.name)
      lines_.refuse(fmt::format("the dump's units are '{}', the mapping's '{}'{}: say units = \"{}\" in the "
                                "mapping, and give its values in them",
                                name, how_.units.name, how_.units_given ? "" : " (the default)", name));
  }

  /// Returns the lower corner.
  Vec3 read_box(std::string_view text, TrajectoryFrame& frame) {
    auto const words = words_of(text);
    if (std::ranges::find(words, "abc") != words.end())
      lines_.refuse("a tilted box (abc origin): only rectangular boxes are read");
    auto const letters = std::span(words).last(std::min<std::size_t>(words.size(), 3));
    bool const lettered = letters.size() == 3 && std::ranges::all_of(letters, [](std::string_view word) {
                            return word.size() == 2 && word.find_first_not_of("pfsm") == word.npos;
                          });
    if (!lettered && !warned_)
      how_.warn(
          fmt::format("{}:{}: the box has no boundary letters (pp, ff, ss, mm): it is taken as periodic",
                      file_.string(), lines_.number()));
    warned_ = warned_ || !lettered;
    std::array<double, 3> low{}, edge{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      auto const bounds = words_of(lines_.next());
      if (bounds.size() != 2 && bounds.size() != 3)
        lines_.refuse("must be the two bounds of a rectangular box");
      low[axis] = lines_.as<double>(bounds[0], "the lower bound");
      edge[axis] = lines_.as<double>(bounds[1], "the upper bound") - low[axis];
      if (bounds.size() == 3 && lines_.as<double>(bounds[2], "the tilt") != 0)
        lines_.refuse("a tilted box: only rectangular boxes are read");
      if (!(edge[axis] > 0) || !std::isfinite(edge[axis]))
        lines_.refuse("the upper bound of the box must be greater than the lower one");
      frame.periodic[axis] = !lettered || letters[axis] == "pp";
    }
    frame.box = {{edge[0], edge[1], edge[2]}};
    return {low[0], low[1], low[2]};
  }

  void read_atoms(DumpColumns const& columns, std::size_t count, Vec3 const& low, TrajectoryFrame& frame) {
    std::vector<Atom> atoms;
    atoms.reserve(count);
    double potential = 0;
    for (std::size_t k = 0; k < count; ++k) {
      auto const words = words_of(lines_.next());
      if (words.size() != columns.count())
        lines_.refuse(
            fmt::format("has {} values: must be {}, one for each column", words.size(), columns.count()));
      atoms.push_back(atom_of(words, columns, low, frame.box));
      if (columns.potential)
        potential += lines_.as<double>(words[*columns.potential], "the potential energy");
    }
    if (columns.potential)
      frame.potential_energy = potential;
    std::ranges::sort(atoms, {}, [](Atom const& atom) { return std::pair(atom.molecule, atom.id); });
    check_molecules(atoms, columns);
    for (auto const& atom : atoms) {
      frame.q.push_back(atom.q), frame.v.push_back(atom.v), frame.ids.push_back(atom.id);
      if (columns.f)
        frame.f.push_back(atom.f);
    }
  }

  Atom atom_of(std::vector<std::string_view> const& words, DumpColumns const& columns, Vec3 const& low,
               Box const& box) const {
    Atom atom;
    atom.id = lines_.as<std::int64_t>(words[columns.id], "id");
    if (atom.id < 1)
      lines_.refuse(fmt::format("id = {}: must be >= 1", atom.id));
    atom.molecule = columns.molecule ? lines_.as<std::int64_t>(words[*columns.molecule], "mol")
                                     : (atom.id - 1) / std::int64_t(how_.atoms_per_molecule);
    if (columns.type)
      atom.type = lines_.as<std::int64_t>(words[*columns.type], "type");
    if (columns.mass)
      atom.mass = lines_.as<double>(words[*columns.mass], "mass");
    auto const vector = [&](std::array<std::size_t, 3> const& places, char const* what) {
      return Vec3{lines_.as<double>(words[places[0]], what), lines_.as<double>(words[places[1]], what),
                  lines_.as<double>(words[places[2]], what)};
    };
    auto const q = vector(columns.q, "position");
    atom.q = columns.scaled ? Vec3{q.x * box.edge.x, q.y * box.edge.y, q.z * box.edge.z} : q - low;
    atom.v = vector(columns.v, "velocity");
    if (columns.f)
      atom.f = vector(*columns.f, "force");
    constexpr double most_edges = 1e6; // farther away a position has lost the digits that tell its neighbours
    if (!(std::max({std::abs(atom.q.x / box.edge.x), std::abs(atom.q.y / box.edge.y),
                    std::abs(atom.q.z / box.edge.z)}) < most_edges))
      lines_.refuse(
          fmt::format("the position of atom {} is more than {:g} box edges away", atom.id, most_edges));
    return atom;
  }

  void check_molecules(std::vector<Atom> const& atoms, DumpColumns const& columns) const {
    auto const n = how_.atoms_per_molecule;
    std::set<std::int64_t> ids;
    for (std::size_t k = 0; k < atoms.size(); ++k) {
      auto const& atom = atoms[k];
      if (!ids.insert(atom.id).second)
        lines_.refuse(fmt::format("the frame that ends here has the atom {} twice", atom.id));
      if (atom.molecule != atoms[k - k % n].molecule ||
          (k % n == 0 && k > 0 && atom.molecule == atoms[k - 1].molecule))
        lines_.refuse(fmt::format("molecule {} has not the mapping's {} atoms", atom.molecule, n));
      if (columns.type && atom.type != atoms[k % n].type)
        lines_.refuse(
            fmt::format("atom {} of molecule {} has the type {}, that of molecule {} the type {}: the "
                        "mapping takes all molecules as equal, atoms in the order of their ids",
                        k % n + 1, atom.molecule, atom.type, atoms[0].molecule, atoms[k % n].type));
      constexpr double rounded = 1e-3;
      if (columns.mass && k % n < how_.masses.size() &&
          !(std::abs(atom.mass - how_.masses[k % n]) <= rounded * how_.masses[k % n]))
        lines_.refuse(fmt::format("atom {} has the mass {}, in the mapping {}", atom.id, atom.mass,
                                  how_.masses[k % n]));
    }
  }

  std::filesystem::path file_;
  TrajectoryReading const& how_;
  DumpLines lines_;
  std::uintmax_t file_size_;
  bool warned_ = false;
};

} // namespace

void read_lammps_dump(std::filesystem::path const& file, TrajectoryReading const& how,
                      std::function<void(TrajectoryFrame const&)> const& consume) {
  DumpReader(file, how).read_all(consume);
}

} // namespace mesobridge::workflows
