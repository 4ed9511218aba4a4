#pragma once
#include "fitting/fit_eos.hpp"
#include "workflows/command.hpp"
#include <span>

namespace mesobridge::workflows {

/// A command that fits one family of equations of state to data files.
struct FitFamily {
  std::string name;     ///< "mie-gruneisen"
  std::string material; ///< what it describes, for the summary
  std::string example;
  fitting::EosFamily (*family)(std::span<fitting::Observation const>);
};

Command fit_family_command(FitFamily const& family);

} // namespace mesobridge::workflows
