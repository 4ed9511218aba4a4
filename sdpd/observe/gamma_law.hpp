#pragma once
#include "cg/histogram.hpp"

namespace mesobridge::sdpd {

/// The Gamma law of the internal energy of an ideal-gas particle of size K, in k_B T, as a density over the
/// bins (sdpd/README.md, Eq. (S19)).
std::vector<double> gamma_law(double K, cg::Bins const& bins);

} // namespace mesobridge::sdpd
