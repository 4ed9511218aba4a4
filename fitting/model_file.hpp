#pragma once
#include "fitting/eos/list.hpp"
#include "fitting/fit_lj_bwr.hpp"
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace mesobridge::fitting {

/// Where the data of a fit lie: the model interpolates inside, extrapolates outside. In Lennard-Jones units
/// per atom for `lj-bwr`, in SI per unit mass for the others.
struct ValidRange {
  double rho_min, rho_max, T_min, T_max, e_min, e_max;
  friend bool operator==(ValidRange const&, ValidRange const&) = default;
};

/// An equation of state as it stands in a file.
struct EosModel {
  AnyEos eos;
  /// Lower triangular L of the covariance L L^T of x1 ... x32 (lj-bwr), or of `fitted` (the others).
  std::optional<Eigen::MatrixXd> covariance_factor;
  std::optional<ValidRange> valid;
  std::string data_hash;                         ///< of the data that were fitted; empty if none
  std::map<std::string, std::string> provenance; ///< whatever the caller wants to remember
  std::vector<std::string> fitted; ///< keys of the parameters that a fit left free; none for lj-bwr
};

/// A fit in the given units (none: Lennard-Jones units), ready to be written.
EosModel model_of(LjBwrFit const& fit, std::optional<LjUnits> units, std::string data_hash,
                  std::map<std::string, std::string> provenance);

/// TOML text from which parse_model returns the same model bit for bit.
std::string to_toml(EosModel const& model);

/// Reads that text. Throws InputError with file, line, key and what is allowed for malformed TOML, an unknown
/// or missing key, a wrong type, a number that is not finite, and for a model whose heat capacity is not
/// positive all over its domain (temperatures would not be unique).
EosModel parse_model(std::string_view text, std::string const& file_name);

/// A built-in material by its name, or the model in the file of that name, whose text `read_text` returns
/// (this stage touches no files).
EosModel load_eos(std::string const& name_or_file,
                  std::function<std::string(std::string const&)> const& read_text);

} // namespace mesobridge::fitting
