#pragma once
#include "cg/correlations.hpp"

namespace mesobridge::cg {

/// How far what was found is from the key approximation, test by test.
std::vector<KeyTest> key_tests(Correlations const& found);

} // namespace mesobridge::cg
