#include "sdpd/scheme/list.hpp"
#include "md/error.hpp"
#include <fmt/ranges.h>

namespace mesobridge::sdpd {

// Each integrator is a file of its room; it is declared here and nowhere else.
PairIntegrator ssa_integrator();
PairIntegrator ams_integrator();
PairIntegrator ems_integrator();
PairIntegrator ser_integrator();
PairIntegrator implicit_integrator();
PairIntegrator hybrid_integrator();
PairIntegrator entropy_integrator();
PairIntegrator lowe_andersen_integrator();

ConservativeIntegrator verlet_integrator();
ConservativeIntegrator mclachlan_integrator();
ConservativeIntegrator position_verlet_integrator();
ConservativeIntegrator no_integrator();

std::vector<PairIntegrator> const& pair_integrators() {
  static std::vector const list{
      ssa_integrator(),      ams_integrator(),    ems_integrator(),     ser_integrator(),
      implicit_integrator(), hybrid_integrator(), entropy_integrator(), lowe_andersen_integrator(),
  };
  return list;
}

std::vector<ConservativeIntegrator> const& conservative_integrators() {
  static std::vector const list{
      verlet_integrator(),
      mclachlan_integrator(),
      position_verlet_integrator(),
      no_integrator(),
  };
  return list;
}

namespace {

template <class Named>
std::vector<std::string> names_of(std::vector<Named> const& list) {
  std::vector<std::string> names;
  for (auto const& known : list)
    names.push_back(known.name);
  return names;
}

template <class Named>
Named const& find(std::vector<Named> const& list, std::string_view what, std::string_view name) {
  for (auto const& known : list)
    if (known.name == name)
      return known;
  throw InputError(fmt::format("{} = '{}': must be one of {}", what, name, fmt::join(names_of(list), ", ")));
}

/// What the integrator needs and there is not; empty where there is nothing of the kind.
std::string missing(Needs const& needs, Features const& particles, bool noise) {
  if (!noise && !needs.noise.empty())
    return fmt::format("without noise {}", needs.noise);
  if (!particles.energies && !needs.internal_energies.empty())
    return fmt::format("the particles have no internal energies, so {}", needs.internal_energies);
  if (particles.energies && !needs.no_internal_energies.empty())
    return fmt::format("the particles have internal energies, and {}", needs.no_internal_energies);
  if (!particles.densities && !needs.densities.empty())
    return std::string(needs.densities);
  return {};
}

} // namespace

std::vector<std::string> pair_integrator_names() {
  return names_of(pair_integrators());
}

PairIntegrator const& pair_integrator(std::string_view name) {
  return find(pair_integrators(), "scheme", name);
}

std::optional<std::string> refusal(PairIntegrator const& of, Features const& particles, bool noise) {
  auto const why = missing(of.needs, particles, noise);
  if (why.empty())
    return std::nullopt;
  std::vector<std::string> others;
  for (auto const& other : pair_integrators())
    if (missing(other.needs, particles, noise).empty())
      others.push_back(other.name);
  return fmt::format("{}: take one of {}", why, fmt::join(others, ", "));
}

std::vector<std::string> conservative_names() {
  return names_of(conservative_integrators());
}

ConservativeIntegrator const& conservative_integrator(std::string_view name) {
  return find(conservative_integrators(), "conservative", name);
}

} // namespace mesobridge::sdpd
