#pragma once
#include "md/box.hpp"
#include "md/dimension.hpp"
#include "md/number_range.hpp"
#include "sdpd/state/caloric.hpp"
#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

namespace mesobridge::sdpd {

using Index = std::uint32_t;

/// What particles have beside positions and momenta, which the method decides, and what bounds them.
struct Features {
  bool energies = true;     ///< SDPD, DPDE
  bool densities = true;    ///< SDPD; without them temperatures average harmonically
  bool masses = false;      ///< several species: each particle has a mass of its own
  bool reacts = false;      ///< a reactant becomes a product
  bool walls = false;       ///< the box has some
  bool rough_walls = false; ///< with friction
  bool body_force = false;
};

/// The particles as a structure of arrays in reduced units. The order in memory follows the cells and changes
/// when lists are renewed; `id` says who is who. Arrays that are not needed are empty: DPDE has no densities,
/// DPD no internal energies either, and particles of one species all have the mass 1. A scalar is a member
/// here and a line of `fields` below.
struct Particles {
  std::vector<std::uint32_t> id;
  std::vector<std::uint32_t> species; ///< its number (state/species.hpp); empty for one species
  std::vector<Vec3> q;                ///< position; leaves the box between two renewals of the lists
  std::vector<Vec3> p;                ///< momentum
  std::vector<double> eps;            ///< internal energy
  std::vector<double> rho;            ///< density, with the self term
  std::vector<double> S;              ///< entropy
  std::vector<double> T;              ///< internal temperature
  std::vector<double> P;              ///< pressure
  std::vector<double> mass;
  std::vector<double> progress;          ///< lambda, the product's share of the mass, of what reacts
  std::vector<double> log_density_ratio; ///< ln(rho_1/rho_0) of product and reactant in what is a mixture
  std::vector<Vec3> f;                   ///< conservative force
  std::vector<Caloric> caloric;

  std::size_t size() const { return id.size(); }
  double mass_of(std::size_t i) const { return mass.empty() ? 1 : mass[i]; }

  void resize(std::size_t n, Features const& has = {});
};

/// A scalar of the particles, declared once: re-sorting, checkpoints, snapshots, histograms, profiles,
/// trajectories and the estimate of the disk that a run takes go through the table.
struct Field {
  std::string_view name; ///< in scenes and, with the unit's key, in files
  std::vector<double> Particles::*values;
  Dimension dimension;
  bool Features::*feature;        ///< who has it
  bool checkpointed = false;      ///< a run cannot go on without it: the others follow from these
  bool written = false;           ///< in trajectories, and histograms may count it
  bool profiled = false;          ///< profiles may show its mean over a slice, under its own name
  NumberRange range = any_number; ///< no other value makes sense
};

inline constexpr std::array fields{
    Field{.name = "eps",
          .values = &Particles::eps,
          .dimension = Dimension::energy,
          .feature = &Features::energies,
          .checkpointed = true,
          .written = true},
    Field{.name = "rho",
          .values = &Particles::rho,
          .dimension = Dimension::density,
          .feature = &Features::densities,
          .written = true},
    Field{.name = "S",
          .values = &Particles::S,
          .dimension = Dimension::entropy,
          .feature = &Features::densities,
          .checkpointed = true},
    Field{.name = "T",
          .values = &Particles::T,
          .dimension = Dimension::temperature,
          .feature = &Features::energies,
          .checkpointed = true,
          .written = true,
          .range = positive},
    Field{.name = "P",
          .values = &Particles::P,
          .dimension = Dimension::pressure,
          .feature = &Features::densities,
          .written = true},
    Field{.name = "mass",
          .values = &Particles::mass,
          .dimension = Dimension::mass,
          .feature = &Features::masses,
          .range = positive},
    Field{.name = "progress",
          .values = &Particles::progress,
          .dimension = Dimension::number,
          .feature = &Features::reacts,
          .checkpointed = true,
          .written = true,
          .profiled = true,
          .range = {.min = 0, .max = 1}},
    Field{.name = "log_density_ratio",
          .values = &Particles::log_density_ratio,
          .dimension = Dimension::number,
          .feature = &Features::reacts,
          .checkpointed = true},
};

inline void Particles::resize(std::size_t n, Features const& has) {
  id.resize(n), q.resize(n), p.resize(n), f.resize(n);
  for (auto const& field : fields)
    (this->*field.values).resize(has.*field.feature ? n : 0);
  caloric.resize(has.energies ? n : 0);
  species.resize(has.masses ? n : 0);
}

} // namespace mesobridge::sdpd
