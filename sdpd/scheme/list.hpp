#pragma once
#include "sdpd/conservative/integrator.hpp"
#include "sdpd/fluctuation/pair_integrator.hpp"
#include <optional>

namespace mesobridge::sdpd {

/// Every way to integrate fluctuation and dissipation: scenes, options and studies take their names from
/// here.
std::vector<PairIntegrator> const& pair_integrators();

std::vector<std::string> pair_integrator_names();

/// Throws InputError that lists the names.
PairIntegrator const& pair_integrator(std::string_view name);

/// Why the integrator cannot be used for such particles, with or without noise, and what to take in its
/// place; nothing where it can.
std::optional<std::string> refusal(PairIntegrator const& of, Features const& particles, bool noise = true);

/// Every integrator of the conservative forces.
std::vector<ConservativeIntegrator> const& conservative_integrators();

std::vector<std::string> conservative_names();

/// Throws InputError that lists the names.
ConservativeIntegrator const& conservative_integrator(std::string_view name);

} // namespace mesobridge::sdpd
