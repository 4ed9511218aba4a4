#pragma once
#include <string>

namespace mesobridge::workflows {

/// What the rows of a data file for a fit may be and which columns each kind has, with an example of each:
/// the text of `fit ... --columns`.
std::string column_guide();

} // namespace mesobridge::workflows
