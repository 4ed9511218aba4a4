#include "workflows/trajectory/lammps_dump.hpp"
#include "workflows/trajectory/dump_box.hpp"
#include "workflows/trajectory/dump_columns.hpp"
#include <algorithm>
#include <map>
#include <set>

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
        else if (lines_.cut())
          how_.warn(
              fmt::format("'{}': the packed file has no end of its own: its {} frames are used, unchecked",
                          file_.string(), frames));
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
    std::optional<DumpBox> box;
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
        box = read_box(item.substr(10), frame);
      else if (item.starts_with("ATOMS")) {
        if (!has_step || !atoms || !box)
          lines_.refuse("ITEM: TIMESTEP, NUMBER OF ATOMS and BOX BOUNDS must stand before");
        read_atoms(DumpColumns(item.substr(5), lines_), *atoms, *box, frame);
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
    if (atoms <= 0 || (!lines_.packed() && std::uintmax_t(atoms) > file_size_ / shortest_line))
      lines_.refuse(
          fmt::format("{} atoms: must be at least one, and no more than the file of {} bytes can hold", atoms,
                      file_size_));
    if (!how_.atoms.empty() && std::size_t(atoms) != how_.atoms.size())
      lines_.refuse(fmt::format("{} atoms: the data file of the mapping has {} (it must be that of the whole "
                                "system, as write_data writes it)",
                                atoms, how_.atoms.size()));
    auto const each = how_.atoms.empty() ? std::int64_t(how_.atoms_per_molecule) : atoms;
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

  DumpBox read_box(std::string_view text, TrajectoryFrame& frame) {
    auto const box = read_dump_box(text, lines_);
    if (!box.lettered && !warned_)
      how_.warn(
          fmt::format("{}:{}: the box has no boundary letters (pp, ff, ss, mm): it is taken as periodic",
                      file_.string(), box.line));
    warned_ = warned_ || !box.lettered;
    frame.periodic = box.periodic, frame.box = box.turned.box, frame.may_tilt = box.may_tilt;
    return box;
  }

  void read_atoms(DumpColumns const& columns, std::size_t count, DumpBox const& box, TrajectoryFrame& frame) {
    std::vector<Atom> atoms;
    constexpr std::size_t at_first = 1000000; // what a packed file holds is not known
    atoms.reserve(std::min(count, at_first));
    double potential = 0;
    for (std::size_t k = 0; k < count; ++k) {
      auto const words = words_of(lines_.next());
      if (words.size() != columns.count())
        lines_.refuse(
            fmt::format("has {} values: must be {}, one for each column", words.size(), columns.count()));
      atoms.push_back(atom_of(words, columns, box));
      if (columns.potential)
        potential += lines_.as<double>(words[*columns.potential], "the potential energy");
    }
    if (columns.potential)
      frame.potential_energy = potential;
    if (how_.atoms.empty()) {
      std::ranges::sort(atoms, {}, [](Atom const& atom) { return std::pair(atom.molecule, atom.id); });
      check_molecules(atoms, columns);
    } else
      put_in_order(atoms, columns);
    for (auto const& atom : atoms) {
      frame.q.push_back(atom.q), frame.v.push_back(atom.v), frame.ids.push_back(atom.id);
      if (columns.f)
        frame.f.push_back(atom.f);
    }
  }

  Atom atom_of(std::vector<std::string_view> const& words, DumpColumns const& columns,
               DumpBox const& box) const {
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
    atom.q = columns.scaled ? box.turned.box.position(q) : box.turned.turned(q - box.low);
    atom.v = box.turned.turned(vector(columns.v, "velocity"));
    if (columns.f)
      atom.f = box.turned.turned(vector(*columns.f, "force"));
    constexpr double most_edges = 1e6; // farther away a position has lost the digits that tell its neighbours
    Vec3 const part = box.turned.box.parts(atom.q);
    if (!(std::max({std::abs(part.x), std::abs(part.y), std::abs(part.z)}) < most_edges))
      lines_.refuse(
          fmt::format("the position of atom {} is more than {:g} box edges away", atom.id, most_edges));
    return atom;
  }

  /// In the order of the atoms that are expected.
  void put_in_order(std::vector<Atom>& atoms, DumpColumns const& columns) {
    if (place_.empty())
      for (std::size_t k = 0; k < how_.atoms.size(); ++k)
        place_[how_.atoms[k].id] = k;
    std::vector<Atom> sorted(atoms.size());
    for (auto const& atom : atoms) {
      auto const found = place_.find(atom.id);
      if (found == place_.end())
        lines_.refuse(fmt::format(
            "the frame that ends here has the atom {}, which the mapping's data file has not", atom.id));
      auto& into = sorted[found->second];
      auto const& expected = how_.atoms[found->second];
      if (into.id != 0)
        lines_.refuse(fmt::format("the frame that ends here has the atom {} twice", atom.id));
      if (columns.type && atom.type != expected.type)
        lines_.refuse(fmt::format("atom {} has the type {}, in the mapping's data file {}", atom.id,
                                  atom.type, expected.type));
      refuse_mass(atom, columns, expected.mass);
      into = atom;
    }
    atoms = std::move(sorted);
  }

  void refuse_mass(Atom const& atom, DumpColumns const& columns, double expected) const {
    constexpr double rounded = 1e-3;
    if (columns.mass && !(std::abs(atom.mass - expected) <= rounded * expected))
      lines_.refuse(fmt::format("atom {} has the mass {}, in the mapping {}", atom.id, atom.mass, expected));
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
      if (k % n < how_.masses.size())
        refuse_mass(atom, columns, how_.masses[k % n]);
    }
  }

  std::filesystem::path file_;
  TrajectoryReading const& how_;
  DumpLines lines_;
  std::uintmax_t file_size_;
  std::map<std::int64_t, std::size_t> place_; ///< of each atom that is expected, by its id
  bool warned_ = false;
};

} // namespace

void read_lammps_dump(std::filesystem::path const& file, TrajectoryReading const& how,
                      std::function<void(TrajectoryFrame const&)> const& consume) {
  DumpReader(file, how).read_all(consume);
}

} // namespace mesobridge::workflows
