#pragma once
#include "sdpd/state/particles.hpp"
#include <functional>
#include <string>
#include <vector>

namespace mesobridge::workflows {

/// A quantity that a scene may ask for by name, if its particles and its box have it.
struct NamedQuantity {
  std::string name;
  std::function<bool(sdpd::Features const&)> exists;
};

/// What a profile may show.
std::vector<NamedQuantity> const& profile_quantities();
/// What a histogram may count: the fields of the particles that are written.
std::vector<NamedQuantity> const& histogram_quantities();

/// What may colour the particles of a film: those fields, and the components of the velocity.
std::vector<NamedQuantity> const& film_quantities();

/// What a series may hold: the measurements that no run makes unless it is asked to.
std::vector<NamedQuantity> const& series_quantities();

std::vector<std::string> names_of(std::vector<NamedQuantity> const& quantities);

/// The quantities that a scene names or, when it names none, all that there are.
std::vector<std::string> chosen(std::vector<std::string> const& named,
                                std::vector<NamedQuantity> const& quantities, sdpd::Features const& has);

} // namespace mesobridge::workflows
