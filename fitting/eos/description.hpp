#pragma once
#include "md/number_range.hpp"
#include <cmath>
#include <concepts>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace mesobridge::fitting {

struct DataSummary; // fitting/data_summary.hpp

/// A number that a fit starts from or is bounded by: itself, or a multiple of what the data say.
class FromData {
 public:
  constexpr FromData(double number) : factor_(number) {}
  constexpr FromData(double factor, double DataSummary::*of) : factor_(factor), of_(of) {}
  double in(DataSummary const& data) const;

 private:
  double factor_;
  double DataSummary::*of_ = nullptr;
};

/// How a fit treats a parameter as long as its user says nothing else.
struct FitRange {
  FromData start, lower, upper;
  bool logarithmic = false; ///< searched by its logarithm: for positive ones that may span decades
  bool free = true;
  bool linear = false; ///< what is measured is about linear in it while the others stand

  constexpr FitRange by_logarithm() const { return {start, lower, upper, true, free, linear}; }
  constexpr FitRange nearly_linear() const { return {start, lower, upper, logarithmic, free, true}; }
};
constexpr FitRange fitted(FromData start, FromData lower, FromData upper) {
  return {start, lower, upper};
}
/// The bounds count once the user frees it.
constexpr FitRange fixed(FromData start, FromData lower = 0, FromData upper = 0) {
  return {start, lower, upper, false, false};
}

/// One parameter of a model that is a plain struct of numbers in SI.
template <class Parameters>
struct ParameterDescription {
  double Parameters::*member;
  std::string_view name; ///< "rho_0"
  std::string_view unit; ///< "kg/m^3"; empty for pure numbers
  std::string_view meaning;
  NumberRange allowed;
  FitRange fit;
  std::optional<double> if_missing = std::nullopt; ///< for keys that older files do not have

  /// In files: "rho_0_kg_m3".
  std::string key() const {
    std::string key(name);
    key += unit.empty() ? "" : "_";
    for (char const c : unit)
      if (c != '^' && c != '(' && c != ')')
        key += c == '/' || c == ' ' ? '_' : c;
    return key;
  }
};

/// Where a material's model is near the real one, in the model's units.
struct UsableRange {
  double rho_min, rho_max, T_min, T_max;
};

/// A set of parameters under a name.
template <class Parameters>
struct DescribedMaterial {
  std::string_view name, description; ///< one line, with units and source
  Parameters parameters;
  std::optional<UsableRange> usable = std::nullopt; ///< nothing: as the description says
};

/// What a model says about itself: its file, its fit with the command for it, `eos list` and the generic
/// tests follow from this.
template <class Parameters>
struct Description {
  std::string_view kind;     ///< "mie-gruneisen": in files, and the name of the fit
  std::string_view material; ///< "metals and liquids under shock (Mie-Gruneisen)": what it describes
  std::string_view example;  ///< of its fit: what follows `mesobridge fit KIND`
  /// Its parameters say where energies are zero: no offset between the zeros of data and model is searched.
  bool knows_energy_zero = false;
  std::vector<ParameterDescription<Parameters>> parameters; ///< in the order of the file
  std::vector<DescribedMaterial<Parameters>> materials;

  /// Its table in files: "mie_gruneisen".
  std::string table() const {
    std::string table(kind);
    for (char& c : table)
      c = c == '-' ? '_' : c;
    return table;
  }
  bool fittable() const {
    for (auto const& parameter : parameters)
      if (parameter.fit.free)
        return true;
    return false;
  }
};

/// A model that describes itself and is made of its parameters alone.
template <class Model>
concept DescribedModel = requires(Model const& model) {
  { Model::description() } -> std::same_as<Description<typename Model::Parameters> const&>;
  { model.parameters() } -> std::same_as<typename Model::Parameters const&>;
};

/// Throws the InputError of `require`.
[[noreturn]] void refuse_parameter(std::string_view model, std::string_view parameter, double value,
                                   NumberRange const& allowed);

/// The parameters, once each has been found to be allowed; throws InputError that names model, parameter and
/// value otherwise.
template <class Model>
auto const& checked(auto const& parameters) {
  for (auto const& parameter : Model::description().parameters)
    if (double const value = parameters.*parameter.member; !parameter.allowed.contains(value))
      refuse_parameter(Model::name, parameter.name, value, parameter.allowed);
  return parameters;
}

} // namespace mesobridge::fitting
