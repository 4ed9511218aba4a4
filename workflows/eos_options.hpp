#pragma once
#include "fitting/model_file.hpp"
#include <optional>
#include <string>

namespace CLI {
class App;
}

namespace mesobridge::workflows {

/// The options by which every `eos` command names its equation of state.
struct EosOptions {
  std::string model;                    ///< a name of `eos list`, or a model's file
  std::optional<double> gamma, dof, m0; ///< of `ideal-gas` only; m0 in kg

  void declare(CLI::App& app);
  /// Throws InputError for an unknown model, a bad file, and for gas options that do not apply.
  fitting::EosModel load() const;
};

} // namespace mesobridge::workflows
