#pragma once
namespace mesobridge::sdpd {

/// How the pairs' fluctuation and dissipation is integrated: see fluctuate().
enum class PairScheme { ssa, ams, ems, ser, ser_implicit, hybrid, entropy };

} // namespace mesobridge::sdpd
