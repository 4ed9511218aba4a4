#include "md/metal_potential.hpp"
#include "md/error.hpp"
#include "md/units.hpp"
#include <algorithm>
#include <array>
#include <cctype>
#include <cstdlib>
#include <fmt/ranges.h>
#include <fstream>
#include <sstream>

namespace mesobridge::md {
namespace {

constexpr double angstrom = 1e-10;

/// Symbols by atomic number: a funcfl file tells its element by the number only.
constexpr char const* symbols[] = {
    "H",  "He", "Li", "Be", "B",  "C",  "N",  "O",  "F",  "Ne", "Na", "Mg", "Al", "Si", "P",  "S",
    "Cl", "Ar", "K",  "Ca", "Sc", "Ti", "V",  "Cr", "Mn", "Fe", "Co", "Ni", "Cu", "Zn", "Ga", "Ge",
    "As", "Se", "Br", "Kr", "Rb", "Sr", "Y",  "Zr", "Nb", "Mo", "Tc", "Ru", "Rh", "Pd", "Ag", "Cd",
    "In", "Sn", "Sb", "Te", "I",  "Xe", "Cs", "Ba", "La", "Ce", "Pr", "Nd", "Pm", "Sm", "Eu", "Gd",
    "Tb", "Dy", "Ho", "Er", "Tm", "Yb", "Lu", "Hf", "Ta", "W",  "Re", "Os", "Ir", "Pt", "Au", "Hg",
    "Tl", "Pb", "Bi", "Po", "At", "Rn", "Fr", "Ra", "Ac", "Th", "Pa", "U",  "Np", "Pu", "Am"};

std::filesystem::path find(std::string const& file) {
  require(!file.empty(), "potential", file, "must be the name of a file");
  std::vector<std::filesystem::path> places{file};
  if (!std::filesystem::path(file).is_absolute()) {
    if (char const* const folder = std::getenv("LAMMPS_POTENTIALS"))
      places.push_back(std::filesystem::path(folder) / file);
    places.push_back(packaged_potentials() / file);
  }
  for (auto const& place : places)
    if (std::filesystem::is_regular_file(place))
      return place;
  std::vector<std::string> names;
  for (auto const& place : places)
    names.push_back(fmt::format("'{}'", place.string()));
  throw InputError(fmt::format("the potential file was not found: looked for {}; the package lammps-data "
                               "brings some, `ls {}/*.eam*` shows them",
                               fmt::join(names, ", "), packaged_potentials().string()));
}

std::string style_of(std::filesystem::path const& file) {
  auto const name = file.filename().string();
  if (name.ends_with(".alloy"))
    return "eam/alloy";
  if (name.ends_with(".fs"))
    return "eam/fs";
  if (name.ends_with(".eam"))
    return "eam";
  throw InputError(
      fmt::format("potential file '{}': its name must end in .eam, .eam.alloy (.alloy) or .eam.fs "
                  "(.fs), which tells its format",
                  file.string()));
}

/// Reads numbers and words of one file and names the file when they are not what they should be.
class Reader {
 public:
  explicit Reader(std::filesystem::path const& file) : file_(file), stream_(file) {
    if (!stream_)
      fail("cannot be read");
  }
  std::string line() {
    std::string text;
    if (!std::getline(stream_, text))
      fail("ends too early");
    return text;
  }
  template <class Value>
  Value next(std::string_view what) {
    Value value{};
    if (!(stream_ >> value))
      fail(fmt::format("has no {} where it should", what));
    return value;
  }
  double positive(std::string_view what) {
    auto const value = next<double>(what);
    if (!(value > 0 && std::isfinite(value)))
      fail(fmt::format("gives {} = {}, which must be > 0", what, value));
    return value;
  }
  std::size_t count(std::string_view what) {
    auto const value = next<long>(what);
    if (value < 2 || value > 10'000'000)
      fail(fmt::format("gives {} = {}, which must be at least 2", what, value));
    return std::size_t(value);
  }
  std::vector<double> numbers(std::size_t n, std::string_view what) {
    std::vector<double> values(n);
    for (double& value : values)
      value = next<double>(what);
    return values;
  }
  [[noreturn]] void fail(std::string const& why) const {
    throw InputError(fmt::format("potential file '{}' {}", file_.string(), why));
  }

 private:
  std::filesystem::path file_;
  std::ifstream stream_;
};

void read_atom(Reader& reader, MetalPotential& potential) {
  reader.next<double>("atomic number");
  potential.mass = reader.positive("mass") * atomic_mass;
  potential.lattice_constant = reader.positive("lattice constant") * angstrom;
}

/// A file may state a lattice that is none of ours (diamond, say) for an element that it does not describe.
Lattice lattice_in_file(Reader const& reader, std::string const& name) {
  try {
    return lattice_of(name);
  } catch (InputError const& error) {
    reader.fail(fmt::format("cannot be used: {}", error.what()));
  }
}

struct TableSizes {
  std::size_t embedding, radial;
};

TableSizes read_table_sizes(Reader& reader, MetalPotential& potential) {
  TableSizes sizes{};
  sizes.embedding = reader.count("size of the embedding table");
  potential.largest_density = double(sizes.embedding - 1) * reader.positive("step of the embedding table");
  sizes.radial = reader.count("size of the radial tables");
  potential.spacing = reader.positive("step of the radial tables") * angstrom;
  potential.cutoff = reader.positive("cut-off") * angstrom;
  return sizes;
}

/// DYNAMO funcfl: one element, named by its atomic number.
void read_single(Reader& reader, MetalPotential& potential) {
  reader.line();
  auto const number = reader.next<int>("atomic number");
  if (number < 1 || number > int(std::size(symbols)))
    reader.fail(fmt::format("gives the atomic number {}", number));
  std::string const own = symbols[number - 1];
  if (!potential.element.empty() && potential.element != own)
    reader.fail(fmt::format("has no element '{}'; it has {}", potential.element, own));
  potential.element = own;
  potential.mass = reader.positive("mass") * atomic_mass;
  potential.lattice_constant = reader.positive("lattice constant") * angstrom;
  potential.lattice = lattice_in_file(reader, reader.next<std::string>("lattice"));
  auto const sizes = read_table_sizes(reader, potential);
  reader.numbers(sizes.embedding, "embedding function");
  reader.numbers(sizes.radial, "effective charge");
  potential.density = reader.numbers(sizes.radial, "electron density");
}

/// DYNAMO setfl: several elements, each with one density function or, Finnis-Sinclair, one for each partner.
void read_several(Reader& reader, MetalPotential& potential) {
  for (int comment = 0; comment < 3; ++comment)
    reader.line();
  std::istringstream words(reader.line());
  std::size_t count = 0;
  words >> count;
  std::vector<std::string> elements;
  for (std::string word; words >> word;)
    elements.push_back(word);
  if (count == 0 || elements.size() != count)
    reader.fail("does not list its elements in line 4");
  if (potential.element.empty() && count == 1)
    potential.element = elements[0];
  auto const own = std::find(elements.begin(), elements.end(), potential.element);
  if (own == elements.end())
    reader.fail(fmt::format("has no element '{}'; it has {}", potential.element, fmt::join(elements, ", ")));
  auto const index = std::size_t(own - elements.begin());
  std::size_t const functions = potential.style == "eam/fs" ? count : 1;
  auto const sizes = read_table_sizes(reader, potential);
  for (std::size_t k = 0; k <= index; ++k) {
    read_atom(reader, potential);
    auto const lattice = reader.next<std::string>("lattice");
    reader.numbers(sizes.embedding, "embedding function");
    auto const densities = reader.numbers(sizes.radial * functions, "electron density");
    if (k < index)
      continue;
    potential.lattice = lattice_in_file(reader, lattice);
    auto const first = densities.begin() + std::ptrdiff_t(functions > 1 ? index * sizes.radial : 0);
    potential.density.assign(first, first + std::ptrdiff_t(sizes.radial));
  }
}

} // namespace

std::string_view name_of(Lattice lattice) {
  constexpr std::array<std::string_view, 3> names{"fcc", "bcc", "hcp"};
  return names[std::size_t(lattice)];
}

Lattice lattice_of(std::string const& name) {
  std::string lower = name;
  std::transform(lower.begin(), lower.end(), lower.begin(), [](unsigned char c) { return std::tolower(c); });
  for (auto lattice : {Lattice::fcc, Lattice::bcc, Lattice::hcp})
    if (lower == name_of(lattice))
      return lattice;
  throw InputError(fmt::format("lattice '{}': must be fcc, bcc or hcp", name));
}

double MetalPotential::density_at(double r) const {
  double const x = r / spacing;
  auto const k = std::size_t(x);
  return k + 1 < density.size() ? std::lerp(density[k], density[k + 1], x - double(k)) : 0.0;
}

std::filesystem::path packaged_potentials() {
  return "/usr/share/lammps/potentials";
}

MetalPotential read_metal_potential(std::string const& file, std::string const& element) {
  MetalPotential potential;
  potential.file = find(file);
  potential.style = style_of(potential.file);
  potential.element = element;
  Reader reader(potential.file);
  potential.style == "eam" ? read_single(reader, potential) : read_several(reader, potential);
  return potential;
}

double part_beyond_table(MetalPotential const& potential, Frame const& frame) {
  std::size_t const n = frame.positions.size();
  std::vector<double> densities(n, 0.0);
  double const reach = potential.cutoff / angstrom;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 1; j < n; ++j) {
      double const r2 = norm2(frame.box.minimum_image(frame.positions[i] - frame.positions[j]));
      if (r2 >= reach * reach)
        continue;
      double const f = potential.density_at(std::sqrt(r2) * angstrom);
      densities[i] += f, densities[j] += f;
    }
  auto const beyond = std::count_if(densities.begin(), densities.end(),
                                    [&](double density) { return density > potential.largest_density; });
  return double(beyond) / double(n);
}

} // namespace mesobridge::md
