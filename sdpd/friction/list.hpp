#pragma once
#include "sdpd/friction/dpd_law.hpp"
#include "sdpd/friction/sdpd_friction.hpp"
#include "sdpd/kernel/list.hpp"

namespace mesobridge::sdpd {

/// Every law of friction and noise; fluctuation and dissipation choose once, outside their loops.
using AnyPairLaw = std::variant<SdpdLaw, DpdeLaw<Transverse::none>, DpdeLaw<Transverse::own>,
                                DpdLaw<Transverse::none>, DpdLaw<Transverse::own>>;

} // namespace mesobridge::sdpd
