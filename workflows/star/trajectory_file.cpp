#include "workflows/star/trajectory_file.hpp"
#include "md/error.hpp"
#include "workflows/store/store.hpp"
#include <algorithm>
#include <array>
#include <fstream>
#include <map>
#include <numeric>
#include <sstream>

namespace mesobridge::workflows {

namespace {

/// Refuses atoms that no molecule takes.
void require_whole_molecules(std::filesystem::path const& file, std::size_t atoms, std::size_t per_molecule) {
  if (atoms == 0 || atoms % per_molecule != 0)
    throw InputError(
        fmt::format("'{}' has {} atoms, the mapping's molecules {} each: {} atoms are left out. Map "
                    "every atom",
                    file.string(), atoms, per_molecule, atoms % per_molecule));
}

/// A LAMMPS text dump, line by line.
class DumpReader {
 public:
  DumpReader(std::filesystem::path const& file, std::size_t per_molecule, double time_step)
      : file_(file), in_(file), per_molecule_(per_molecule), time_step_(time_step) {
    if (!in_)
      throw InputError(fmt::format("'{}' cannot be read", file.string()));
  }

  bool next(TrajectoryFrame& frame) {
    std::string head;
    if (!std::getline(in_, head))
      return false;
    ++line_;
    expect(head, "ITEM: TIMESTEP");
    frame.step = std::int64_t(number(line()));
    frame.time = double(frame.step) * time_step_;
    expect(line(), "ITEM: NUMBER OF ATOMS");
    auto const atoms = std::size_t(number(line()));
    require_whole_molecules(file_, atoms, per_molecule_);
    expect(line(), "ITEM: BOX BOUNDS");
    std::array<double, 3> low{}, edge{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      std::istringstream bounds(line());
      double high = 0, tilt = 0;
      if (!(bounds >> low[axis] >> high) || high <= low[axis] || (bounds >> tilt && tilt != 0))
        refuse("must be the two bounds of a rectangular box");
      edge[axis] = high - low[axis];
    }
    frame.box = {{edge[0], edge[1], edge[2]}};
    read_columns(line());
    read_atoms(atoms, {low[0], low[1], low[2]}, frame);
    return true;
  }

 private:
  [[noreturn]] void refuse(std::string const& what) const {
    throw InputError(fmt::format("{}:{}: {}", file_.string(), line_, what));
  }
  std::string line() {
    std::string text;
    if (!std::getline(in_, text))
      refuse("the file ends inside a frame");
    ++line_;
    return text;
  }
  void expect(std::string const& text, std::string const& start) const {
    if (!text.starts_with(start))
      refuse(fmt::format("must be '{}': only LAMMPS's text dumps are read", start));
  }
  double number(std::string const& text) const {
    std::istringstream in(text);
    double value = 0;
    if (!(in >> value))
      refuse("must be a number");
    return value;
  }

  void read_columns(std::string const& text) {
    expect(text, "ITEM: ATOMS");
    std::istringstream words(text.substr(11));
    columns_.clear();
    std::size_t place = 0;
    for (std::string word; words >> word;)
      columns_[word] = place++;
    if (!columns_.contains("id"))
      refuse("the dump has no column id");
    for (char const* set : {"xu", "x", "xs"})
      if (columns_.contains(set)) {
        position_ = set;
        break;
      }
    if (position_.empty())
      refuse("the dump has no positions: x y z, xu yu zu or xs ys zs");
    if (!columns_.contains("vx"))
      refuse("the dump has no velocities (vx vy vz): momenta and kinetic energies need them");
  }

  void read_atoms(std::size_t atoms, Vec3 const& low, TrajectoryFrame& frame) {
    struct Atom {
      std::int64_t id, molecule;
      Vec3 q, v;
    };
    std::vector<Atom> list;
    std::vector<double> values(columns_.size());
    auto const at = [&](std::string const& name) {
      auto const found = columns_.find(name);
      if (found == columns_.end())
        refuse(fmt::format("the dump has no column {}", name));
      return values[found->second];
    };
    std::string const suffix = position_.substr(1);
    for (std::size_t k = 0; k < atoms; ++k) {
      std::istringstream in(line());
      for (double& value : values)
        if (!(in >> value))
          refuse(fmt::format("must be {} numbers", values.size()));
      Vec3 q{at("x" + suffix), at("y" + suffix), at("z" + suffix)};
      if (position_ == "xs")
        q = {q.x * frame.box.edge.x, q.y * frame.box.edge.y, q.z * frame.box.edge.z};
      else
        q -= low;
      auto const id = std::int64_t(at("id"));
      bool const named = columns_.contains("mol");
      list.push_back({id,
                      named ? std::int64_t(at("mol")) : (id - 1) / std::int64_t(per_molecule_),
                      q,
                      {at("vx"), at("vy"), at("vz")}});
    }
    std::sort(list.begin(), list.end(), [](Atom const& a, Atom const& b) {
      return std::pair(a.molecule, a.id) < std::pair(b.molecule, b.id);
    });
    for (std::size_t k = 0; k < atoms; ++k)
      if (list[k].molecule != list[k - k % per_molecule_].molecule ||
          (k % per_molecule_ == 0 && k > 0 && list[k].molecule == list[k - 1].molecule))
        refuse(fmt::format("molecule {} has not the mapping's {} atoms", list[k].molecule, per_molecule_));
    frame.q.clear(), frame.v.clear();
    for (auto const& atom : list)
      frame.q.push_back(atom.q), frame.v.push_back(atom.v);
  }

  std::filesystem::path file_;
  std::ifstream in_;
  std::size_t per_molecule_;
  double time_step_;
  std::int64_t line_ = 0;
  std::map<std::string, std::size_t> columns_;
  std::string position_;
};

void read_h5md(std::filesystem::path const& file, std::size_t per_molecule,
               std::function<void(TrajectoryFrame const&)> const& consume) {
  Store const store(file, Store::Mode::read);
  std::string const all = "particles/all";
  for (char const* needed : {"/position/value", "/velocity/value", "/box/edges/value"})
    if (!store.contains(all + needed))
      throw InputError(fmt::format("'{}' has no {}: positions, velocities and the box of the group 'all' are "
                                   "needed",
                                   file.string(), all + needed));
  auto const shape = store.shape(all + "/position/value");
  std::size_t const frames = shape.at(0), atoms = shape.at(1);
  require_whole_molecules(file, atoms, per_molecule);
  auto const q = store.read_doubles(all + "/position/value"), v = store.read_doubles(all + "/velocity/value"),
             edges = store.read_doubles(all + "/box/edges/value"),
             time = store.read_doubles(all + "/position/time");
  auto const step = store.read_integers(all + "/position/step");
  std::size_t const numbers = edges.size() / frames; // three lengths or three vectors
  for (std::size_t f = 0; f < frames; ++f) {
    double const* const e = &edges[f * numbers];
    TrajectoryFrame frame{.step = step[f],
                          .time = time[f],
                          .box = numbers == 3 ? Box{{e[0], e[1], e[2]}} : Box{{e[0], e[4], e[8]}},
                          .q = {},
                          .v = {}};
    for (std::size_t k = f * atoms; k < (f + 1) * atoms; ++k) {
      frame.q.push_back({q[3 * k], q[3 * k + 1], q[3 * k + 2]});
      frame.v.push_back({v[3 * k], v[3 * k + 1], v[3 * k + 2]});
    }
    consume(frame);
  }
}

} // namespace

void read_trajectory(std::filesystem::path const& file, std::size_t per_molecule, double time_step,
                     std::function<void(TrajectoryFrame const&)> const& consume) {
  if (file.extension() == ".h5" || file.extension() == ".h5md")
    return read_h5md(file, per_molecule, consume);
  DumpReader reader(file, per_molecule, time_step);
  TrajectoryFrame frame;
  while (reader.next(frame))
    consume(frame);
}

} // namespace mesobridge::workflows
