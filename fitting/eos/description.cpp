#include "fitting/eos/description.hpp"
#include "fitting/data_summary.hpp"
#include "md/error.hpp"

namespace mesobridge::fitting {

double FromData::in(DataSummary const& data) const {
  return of_ ? factor_ * data.*of_ : factor_;
}

void refuse_parameter(std::string_view model, std::string_view parameter, double value,
                      NumberRange const& allowed) {
  throw InputError(fmt::format("{} {} = {}: {}", model, parameter, value, allowed.demand()));
}

} // namespace mesobridge::fitting
