#include "md/data_file.hpp"
#include <algorithm>
#include <cctype>
#include <functional>
#include <map>

namespace mesobridge::md {
namespace {

/// The commands that say what a section of coefficients says, and the word that goes before the numbers.
struct CoefficientSection {
  char const* command;
  char const* keyword;
};

std::map<std::string, CoefficientSection> const coefficient_sections{
    {"Pair Coeffs", {"pair_coeff", ""}},
    {"PairIJ Coeffs", {"pair_coeff", ""}},
    {"Bond Coeffs", {"bond_coeff", ""}},
    {"Angle Coeffs", {"angle_coeff", ""}},
    {"Dihedral Coeffs", {"dihedral_coeff", ""}},
    {"Improper Coeffs", {"improper_coeff", ""}},
    {"BondBond Coeffs", {"angle_coeff", "bb"}},
    {"BondAngle Coeffs", {"angle_coeff", "ba"}},
    {"MiddleBondTorsion Coeffs", {"dihedral_coeff", "mbt"}},
    {"EndBondTorsion Coeffs", {"dihedral_coeff", "ebt"}},
    {"AngleTorsion Coeffs", {"dihedral_coeff", "at"}},
    {"AngleAngleTorsion Coeffs", {"dihedral_coeff", "aat"}},
    {"BondBond13 Coeffs", {"dihedral_coeff", "bb13"}},
    {"AngleAngle Coeffs", {"improper_coeff", "aa"}}};

std::string joined(std::vector<std::string> const& words, std::size_t first) {
  std::string text;
  for (std::size_t k = first; k < words.size(); ++k)
    text += (k > first ? " " : "") + words[k];
  return text;
}

bool names_a_section(InputLine const& line) {
  return std::isalpha(static_cast<unsigned char>(line.words[0][0])) != 0;
}

/// Reads the file from its first line on.
class Reader {
 public:
  Reader(std::filesystem::path const& file, std::string const& atom_style)
      : lines_(read_input_lines(file, false)) {
    data_.file = file, data_.atom_style = atom_style;
  }

  DataFile read() {
    header();
    while (at_ < lines_.size())
      section();
    require(!data_.atoms.empty(), data_.file.string(), "no atoms", "a section 'Atoms' must be there");
    for (auto const kind : bonded_kinds)
      expect_count(bonded_names[std::size_t(kind)], data_.bonded[std::size_t(kind)].size(),
                   counts_[std::size_t(kind)]);
    return std::move(data_);
  }

 private:
  /// The next line with words; false at the end of the file.
  bool to_words() {
    while (at_ < lines_.size() && lines_[at_].words.empty())
      ++at_;
    return at_ < lines_.size();
  }

  void header() {
    at_ = 1; // the first line is a title
    for (; to_words() && !names_a_section(lines_[at_]); ++at_)
      header_line(lines_[at_]);
    require(data_.box.edge.x > 0 && data_.box.edge.y > 0 && data_.box.edge.z > 0, data_.file.string(),
            fmt::format("box {} x {} x {}", data_.box.edge.x, data_.box.edge.y, data_.box.edge.z),
            "must have edges > 0: lines 'LOW HIGH xlo xhi' and so on");
    require(atom_count_ > 0, data_.file.string(), "atoms = 0", "a line 'N atoms' must be there");
    require(data_.atom_types > 0, data_.file.string(), "atom types = 0",
            "a line 'N atom types' must be there");
    data_.masses.assign(std::size_t(data_.atom_types), 0.0);
  }

  void header_line(InputLine const& line) {
    auto const name = joined(line.words, 1), bounds = joined(line.words, 2);
    if (bounds.ends_with("lo " + std::string(1, bounds[0]) + "hi") && bounds.size() == 7)
      return edge(line, bounds[0]);
    if (joined(line.words, 3) == "xy xz yz") {
      auto& box = data_.box;
      box.xy = number_in(line, 0, "tilt"), box.xz = number_in(line, 1, "tilt"),
      box.yz = number_in(line, 2, "tilt");
      return;
    }
    if (name == "atoms")
      atom_count_ = whole_in(line, 0, "number of atoms");
    else if (name == "atom types")
      data_.atom_types = int(bounded(line, 0, "number of atom types", 1, most_types));
    else if (!bonded_header(line, name) && !name.starts_with("extra "))
      refuse_line(line, fmt::format("'{}' is not understood in the head of a data file", line.text()));
  }

  bool bonded_header(InputLine const& line, std::string const& name) {
    for (std::size_t k = 0; k < bonded_names.size(); ++k) {
      std::string const one = bonded_names[k];
      if (name == one + "s") {
        counts_[k] = std::size_t(bounded(line, 0, "number of " + name, 0, most_terms));
        return true;
      }
      if (name == one + " types") {
        data_.bonded_types[k] = int(bounded(line, 0, "number of " + name, 0, most_types));
        return true;
      }
    }
    return false;
  }

  void edge(InputLine const& line, char axis) {
    double const low = number_in(line, 0, "low end of the box"),
                 length = number_in(line, 1, "high end of the box") - low;
    auto const set = [&](double Vec3::*member) { data_.low.*member = low, data_.box.edge.*member = length; };
    if (axis == 'x')
      set(&Vec3::x);
    else if (axis == 'y')
      set(&Vec3::y);
    else
      set(&Vec3::z);
  }

  void section() {
    auto const head = lines_[at_++];
    auto const name = head.text();
    if (name == "Atoms")
      return atoms(head);
    if (name == "Masses")
      return each([&](InputLine const& line) {
        auto const type = bounded(line, 0, "atom type", 1, data_.atom_types);
        double const mass = number_in(line, 1, "mass");
        if (!(mass > 0))
          refuse_line(line, fmt::format("mass = {}: must be > 0", mass));
        data_.masses[std::size_t(type - 1)] = mass;
      });
    if (name == "Velocities")
      return each([](InputLine const&) {});
    for (std::size_t k = 0; k < bonded_names.size(); ++k)
      if (std::string plural = bonded_names[k]; name.size() == plural.size() + 1 && name.ends_with('s') &&
                                                name.substr(1, plural.size() - 1) == plural.substr(1) &&
                                                std::tolower(name[0]) == plural[0])
        return terms(k);
    auto const found = coefficient_sections.find(name);
    if (found == coefficient_sections.end())
      refuse_line(
          head, fmt::format("section '{}': atoms with molecules and bonded terms are read, no others", name));
    coefficients(found->second, name == "PairIJ Coeffs");
  }

  void coefficients(CoefficientSection const& to, bool of_pairs) {
    bool const twice = std::string(to.command) == "pair_coeff" && !of_pairs;
    each([&](InputLine line) {
      std::vector<std::string> words{to.command, line.words[0]};
      if (twice)
        words.push_back(line.words[0]);
      if (*to.keyword)
        words.emplace_back(to.keyword);
      words.insert(words.end(), line.words.begin() + 1, line.words.end());
      line.words = std::move(words);
      data_.coefficients.push_back(std::move(line));
    });
  }

  /// The lines of a section.
  void each(std::function<void(InputLine const&)> const& take) {
    for (; to_words() && !names_a_section(lines_[at_]); ++at_)
      take(lines_[at_]);
  }

  void terms(std::size_t kind) {
    each([&](InputLine const& line) {
      BondedTerm term{.type = int(bounded(line, 1, std::string(bonded_names[kind]) + " type", 1,
                                          data_.bonded_types[kind]))};
      for (std::size_t k = 0; k < bonded_atoms[kind]; ++k)
        term.atoms[k] = whole_in(line, 2 + k, "atom");
      data_.bonded[kind].push_back(term);
    });
  }

  void settle_style(InputLine const& head) {
    auto& style = data_.atom_style;
    if (!head.comment.empty()) {
      if (!style.empty() && style != head.comment)
        refuse_line(head, fmt::format("the atoms are of the style {} by this line, {} by the settings",
                                      head.comment, style));
      style = head.comment;
    }
    if (style.empty() && to_words() && !names_a_section(lines_[at_])) {
      auto const columns = lines_[at_].words.size();
      style = columns == 6 || columns == 9 ? "molecular" : columns == 7 || columns == 10 ? "full" : "";
    }
    for (char const* known : {"bond", "angle", "molecular", "full"})
      if (style == known)
        return;
    refuse_line(head, fmt::format("atom style '{}': must be bond, angle, molecular or full, whose atoms have "
                                  "molecules and bonds",
                                  style));
  }

  void atoms(InputLine const& head) {
    settle_style(head);
    std::size_t const first = data_.charged() ? 4 : 3, columns = first + 3;
    each([&](InputLine const& line) {
      if (line.words.size() != columns && line.words.size() != columns + 3)
        refuse_line(line, fmt::format("an atom of the style {} has {} columns, or {} with image flags; here "
                                      "are {}",
                                      data_.atom_style, columns, columns + 3, line.words.size()));
      data_.atoms.push_back({.id = whole_in(line, 0, "atom"),
                             .molecule = whole_in(line, 1, "molecule"),
                             .type = int(bounded(line, 2, "atom type", 1, data_.atom_types)),
                             .charge = data_.charged() ? number_in(line, 3, "charge") : 0,
                             .q = {number_in(line, first, "x"), number_in(line, first + 1, "y"),
                                   number_in(line, first + 2, "z")}});
    });
    expect_count("atom", data_.atoms.size(), std::size_t(atom_count_));
  }

  void expect_count(std::string const& what, std::size_t found, std::size_t said) const {
    require(found == said, fmt::format("{}: {}s", data_.file.string(), what), found,
            fmt::format("must be {}, as the head says", said));
  }

  static std::int64_t bounded(InputLine const& line, std::size_t word, std::string const& what,
                              std::int64_t low, std::int64_t high) {
    auto const value = whole_in(line, word, what);
    if (value < low || value > high)
      refuse_line(line, fmt::format("{} = {}: must be {} ... {}", what, value, low, high));
    return value;
  }

  static constexpr std::int64_t most_types = 10000, most_terms = 100000000;

  std::vector<InputLine> lines_;
  std::size_t at_ = 0;
  std::int64_t atom_count_ = 0;
  std::array<std::size_t, 4> counts_{};
  DataFile data_;
};

} // namespace

DataFile read_data_file(std::filesystem::path const& file, std::string const& atom_style) {
  return Reader(file, atom_style).read();
}

} // namespace mesobridge::md
