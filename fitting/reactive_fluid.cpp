#include "fitting/reactive_fluid.hpp"

namespace mesobridge::fitting {

template class Mixture<AnyModel, AnyModel>;

} // namespace mesobridge::fitting
