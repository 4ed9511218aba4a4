#include "workflows/trajectory/force_field_mapping.hpp"
#include "fitting/toml_text.hpp"
#include "workflows/trajectory/bond_style.hpp"
#include "workflows/trajectory/lj_mixing.hpp"
#include "workflows/trajectory/unit_style.hpp"
#include <algorithm>
#include <charconv>
#include <cmath>
#include <fmt/ranges.h>
#include <map>
#include <queue>

namespace mesobridge::workflows {

namespace {

using md::InputLine;

/// Types that a coefficient is for: "2", "*", "2*", "*3", "2*3".
std::pair<int, int> type_range(InputLine const& line, std::size_t word, int types) {
  auto const text = word < line.words.size() ? line.words[word] : "";
  auto const star = text.find('*');
  auto const whole = [&](std::string const& part, int otherwise) {
    if (part.empty())
      return otherwise;
    int value = 0;
    auto const [end, error] = std::from_chars(part.data(), part.data() + part.size(), value);
    if (error != std::errc() || end != part.data() + part.size() || value < 1 || value > types)
      md::refuse_line(line, fmt::format("type '{}': must be 1 ... {}, or a range with *", text, types));
    return value;
  };
  if (star == text.npos)
    return {whole(text, 0), whole(text, 0)};
  return {whole(text.substr(0, star), 1), whole(text.substr(star + 1), types)};
}

/// The lines of settings and data file, read as far as a mapping holds them.
class Terms {
 public:
  explicit Terms(md::MoleculeSystem const& system) : kind_(system.molecules.kind) {
    for (auto const& line : system.forces.lines())
      if (line.words[0].ends_with("_style"))
        take_style(line);
    for (auto const* lines : {&system.coefficients, &system.forces.lines()})
      for (auto const& line : *lines)
        take(line);
  }

  bool has_pairs() const { return has_pairs_; }
  bool shifted() const { return shifted_; }

  BondStyle const& bond_style() const {
    if (!bond_style_)
      throw InputError(
          "no bond_style is given, but there are bonds or bond_coeff: add the line to the settings");
    return *bond_style_;
  }
  std::vector<double> const& bond(int type) const {
    auto const found = bonds_.find(type);
    require(found != bonds_.end(), "bond_coeff", type, "no line gives this type's coefficients");
    return found->second;
  }

  LennardJones pair(int a, int b) const {
    if (auto const found = pairs_.find(std::minmax(a, b)); found != pairs_.end())
      return found->second;
    auto const own_a = pairs_.find({a, a}), own_b = pairs_.find({b, b});
    require(own_a != pairs_.end() && own_b != pairs_.end(), "pair_coeff", fmt::format("{} {}", a, b),
            "no line gives these types' coefficients");
    return mixed(own_a->second, own_b->second, mix_);
  }

  /// Whether directly bonded atoms interact as pairs.
  bool bonded_interact() const {
    std::array<bool, 4> there{}; // by bonds between them
    for (int const distance : distances())
      if (distance >= 1 && distance <= 3)
        there[std::size_t(distance)] = true;
    for (std::size_t k = 2; k <= 3; ++k)
      if (there[k] && weights_[k - 1] != 1)
        throw NotHeldByMapping(fmt::format("{}: atoms {} bonds apart count as pairs by the weight {}",
                                           weights_origin_, k, weights_[k - 1]));
    if (there[1] && weights_[0] != 0 && weights_[0] != 1)
      throw NotHeldByMapping(
          fmt::format("{}: bonded atoms count as pairs by the weight {}", weights_origin_, weights_[0]));
    return weights_[0] == 1;
  }

 private:
  [[noreturn]] static void refuse(InputLine const& line, std::string const& why) {
    throw NotHeldByMapping(fmt::format("{}: '{}': {}", line.origin, line.text(), why));
  }

  void take_style(InputLine const& line) {
    auto const& command = line.words[0];
    auto const style = line.words.size() > 1 ? line.words[1] : "";
    if (style == "none" || style == "zero")
      return;
    if (command == "bond_style") {
      auto const* const found = bond_style_named(style);
      if (!found)
        refuse(line, "a mapping holds the bond styles harmonic and fene alone");
      if (bond_style_)
        md::refuse_line(line,
                        fmt::format("'{}': a second bond style: LAMMPS forgets the coefficients of the first",
                                    line.text()));
      bond_style_ = found;
    } else if (command == "pair_style") {
      if (style != "lj/cut" && style != "lj/cut/opt")
        refuse(line, "a mapping holds the pair style lj/cut alone");
      has_pairs_ = true;
      cutoff_ = md::number_in(line, 2, "cut-off");
    } else if (!kind_.bonded[command.starts_with("angle")      ? 1
                             : command.starts_with("dihedral") ? 2
                                                               : 3]
                    .empty())
      refuse(line, "a mapping holds bonds and pairs alone");
  }

  void take(InputLine const& line) {
    auto const& command = line.words[0];
    if (command == "variable")
      refuse(line, "variables are not read for a mapping");
    if (command == "bond_coeff")
      take_bond(line);
    if (command == "pair_coeff" && has_pairs_)
      take_pair(line);
    if (command == "pair_modify")
      take_modify(line);
    if (command == "special_bonds")
      take_weights(line);
  }

  void take_bond(InputLine const& line) {
    auto const [low, high] = type_range(line, 1, kind_.bonded_types[0]);
    auto const values = bond_coefficients(line, bond_style());
    for (int type = low; type <= high; ++type)
      bonds_[type] = values;
  }

  void take_pair(InputLine const& line) {
    int const types = int(kind_.masses_of_types.size());
    auto const [low_a, high_a] = type_range(line, 1, types);
    auto const [low_b, high_b] = type_range(line, 2, types);
    LennardJones const law{md::number_in(line, 3, "epsilon"), md::number_in(line, 4, "sigma"),
                           line.words.size() > 5 ? md::number_in(line, 5, "cut-off") : cutoff_};
    for (int a = low_a; a <= high_a; ++a)
      for (int b = std::max(a, low_b); b <= high_b; ++b)
        pairs_[std::minmax(a, b)] = law;
  }

  void take_modify(InputLine const& line) {
    for (std::size_t k = 1; k + 1 < line.words.size(); k += 2) {
      auto const &key = line.words[k], &value = line.words[k + 1];
      if (key == "shift")
        shifted_ = value == "yes";
      else if (key == "mix" && (value == "geometric" || value == "arithmetic" || value == "sixthpower"))
        mix_ = value == "geometric"    ? Mix::geometric
               : value == "arithmetic" ? Mix::arithmetic
                                       : Mix::sixthpower;
      else if (key != "tail" && key != "table")
        refuse(line, fmt::format("'{} {}' is not read for a mapping", key, value));
    }
  }

  void take_weights(InputLine const& line) {
    weights_origin_ = line.origin;
    for (std::size_t k = 1; k < line.words.size();) {
      auto const& key = line.words[k];
      if (key == "lj" || key == "lj/coul" || key == "coul") {
        if (key != "coul")
          weights_ = {md::number_in(line, k + 1, "weight"), md::number_in(line, k + 2, "weight"),
                      md::number_in(line, k + 3, "weight")};
        k += 4;
      } else if (auto const named = named_weights.find(key); named != named_weights.end()) {
        weights_ = named->second;
        ++k;
      } else
        refuse(line, fmt::format("'{}' is not read for a mapping", key));
    }
  }

  /// By how many bonds each two atoms are apart, up to 3.
  std::vector<int> distances() const {
    int const n = kind_.atoms();
    std::vector<std::vector<int>> neighbours(static_cast<std::size_t>(n));
    for (auto const& term : kind_.bonded[0]) {
      neighbours[std::size_t(term.atoms[0])].push_back(int(term.atoms[1]));
      neighbours[std::size_t(term.atoms[1])].push_back(int(term.atoms[0]));
    }
    std::vector<int> all;
    for (int start = 0; start < n; ++start) {
      std::map<int, int> reached{{start, 0}};
      for (std::queue<int> open({start}); !open.empty(); open.pop())
        if (int const distance = reached[open.front()]; distance < 3)
          for (int const next : neighbours[std::size_t(open.front())])
            if (reached.try_emplace(next, distance + 1).second)
              open.push(next);
      for (auto const& [atom, distance] : reached)
        all.push_back(distance);
    }
    return all;
  }

  static inline std::map<std::string, std::array<double, 3>> const named_weights{
      {"amber", {0, 0, 0.5}}, {"charmm", {0, 0, 0}}, {"dreiding", {0, 0, 1}}, {"fene", {0, 1, 1}}};

  md::MoleculeKind const& kind_;
  bool has_pairs_ = false, shifted_ = false;
  double cutoff_ = 0;
  Mix mix_ = Mix::geometric;
  std::array<double, 3> weights_{};
  std::string weights_origin_ = "special_bonds is not given";
  BondStyle const* bond_style_ = nullptr; ///< none is given
  std::map<int, std::vector<double>> bonds_;
  std::map<std::pair<int, int>, LennardJones> pairs_;
};

template <class Number>
std::string toml_list(std::vector<Number> const& values) {
  std::vector<std::string> texts;
  for (auto const value : values) {
    auto text = fmt::format("{}", value);
    bool const whole = text.find_first_not_of("-0123456789") == text.npos;
    texts.push_back(text + (whole && !std::is_integral_v<Number> ? ".0" : ""));
  }
  return fmt::format("[ {} ]", fmt::join(texts, ", "));
}

std::string bonds_text(md::MoleculeKind const& kind, Terms const& terms) {
  if (kind.bonded[0].empty())
    return "";
  auto const& style = terms.bond_style();
  std::vector<std::int64_t> a, b;
  std::vector<std::vector<double>> columns(style.coefficients.size());
  for (auto const& term : kind.bonded[0]) {
    auto const& values = terms.bond(term.type);
    a.push_back(term.atoms[0] + 1), b.push_back(term.atoms[1] + 1);
    for (std::size_t c = 0; c < columns.size(); ++c)
      columns[c].push_back(values[c]);
  }
  auto text = fmt::format("\n[bonds]\nstyle = \"{}\"\ncount = {}\na = {}\nb = {}\n", style.name, a.size(),
                          toml_list(a), toml_list(b));
  for (std::size_t c = 0; c < columns.size(); ++c)
    text += fmt::format("{} = {}\n", style.coefficients[c], toml_list(columns[c]));
  return text;
}

std::string pairs_text(md::MoleculeKind const& kind, Terms const& terms) {
  if (!terms.has_pairs())
    return "";
  std::vector<int> a, b;
  std::vector<double> epsilon, sigma, cutoff;
  int const highest = *std::ranges::max_element(kind.types);
  auto const there = [&](int type) { return std::ranges::find(kind.types, type) != kind.types.end(); };
  for (int i = 1; i <= highest; ++i)
    for (int j = i; j <= highest; ++j)
      if (there(i) && there(j)) {
        auto const law = terms.pair(i, j);
        a.push_back(i), b.push_back(j), epsilon.push_back(law.epsilon), sigma.push_back(law.sigma),
            cutoff.push_back(law.cutoff);
      }
  return fmt::format(
      "\n[pairs]\ncount = {}\ntype_a = {}\ntype_b = {}\nepsilon = {}\nsigma = {}\ncutoff = {}\n"
      "shifted = \"{}\"\nbonded = \"{}\"\n",
      a.size(), toml_list(a), toml_list(b), toml_list(epsilon), toml_list(sigma), toml_list(cutoff),
      terms.shifted() ? "yes" : "no", terms.bonded_interact() ? "yes" : "no");
}

} // namespace

std::string mapping_text(md::MoleculeSystem const& system) {
  auto const& kind = system.molecules.kind;
  if (!system.others.empty())
    throw NotHeldByMapping(
        fmt::format("'{}': {} kinds of molecules", system.data.string(), system.others.size() + 1));
  if (std::ranges::any_of(kind.charges, [](double charge) { return charge != 0; }))
    throw NotHeldByMapping(fmt::format("'{}': charges", system.data.string()));
  Terms const terms(system);
  return fmt::format("format = \"mesobridge mapping 1\"\nname = {}\nunits = \"{}\"\natoms = {}\nmasses = {}\n"
                     "types = {}\n",
                     fitting::quoted(kind.name), unit_style(system.units).name, kind.atoms(),
                     toml_list(kind.masses()), toml_list(kind.types)) +
         bonds_text(kind, terms) + pairs_text(kind, terms);
}

} // namespace mesobridge::workflows
