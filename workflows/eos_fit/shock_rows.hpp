#pragma once
#include "workflows/eos_fit/row_numbers.hpp"
#include <set>

namespace mesobridge::workflows {

/// What says where the row's state is, and what was measured there.
struct RowSplit {
  std::set<fitting::Quantity> given, measured;
};

RowSplit split_of(fitting::DataPath path, RowNumbers const& numbers);

/// Refuses a row whose quantities contradict each other by conservation of mass and momentum.
void check_jump(DataRow const& row, RowNumbers const& numbers, fitting::Observation const& shock,
                RowSplit const& split);

/// A shock of no strength runs at the speed of sound of matter at rest. Throws InputError where the row says
/// otherwise.
fitting::Observation sound_at_rest(fitting::Observation const& shock, RowNumbers const& numbers,
                                   RelativeErrors const& errors);

} // namespace mesobridge::workflows
