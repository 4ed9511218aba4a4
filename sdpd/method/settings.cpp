#include "sdpd/method/settings.hpp"
#include "sdpd/neighbours/cells.hpp"
#include <limits>

namespace mesobridge::sdpd {

ReducedUnits SimulationSettings::units() const {
  return std::visit([this](auto const& of) { return of.units(*this); }, method);
}

std::size_t SimulationSettings::particle_count() const {
  return layout ? layout->size() : std::size_t{lattice[0]} * lattice[1] * lattice[2];
}

std::vector<Species> SimulationSettings::reduced_species() const {
  std::vector<Species> reduced;
  std::visit(
      [&](auto const& method) {
        for (auto const& of : method.species)
          reduced.push_back({of.name, of.share, mass_of(of) / units().mass()});
      },
      method);
  return reduced;
}

double SimulationSettings::spacing() const {
  double const of_unit_mass = std::visit([this](auto const& of) { return of.unit_spacing(*this); }, method);
  return layout ? of_unit_mass : of_unit_mass * std::cbrt(mean_mass(reduced_species(), particle_count()));
}

double SimulationSettings::range() const {
  return std::visit([this](auto const& of) { return of.range(*this); }, method);
}

Features SimulationSettings::features() const {
  return std::visit(
      [&](auto const& of) {
        Features features = of.features;
        features.masses = !of.species.empty();
        features.reacts = of.reacts();
        features.walls = has_walls(faces), features.rough_walls = has_rough_walls(faces);
        features.body_force = body_force.acts();
        return features;
      },
      method);
}

bool SimulationSettings::conducts() const {
  return std::visit([](auto const& of) { return of.conducts(); }, method);
}

Box box_of(SimulationSettings const& s) {
  Vec3 const lattice{double(s.lattice[0]), double(s.lattice[1]), double(s.lattice[2])};
  return {s.layout ? s.layout->edge() : s.spacing() * lattice, periodic_axes(s.faces)};
}

double skin_of(SimulationSettings const& s) {
  return s.skin > 0 ? s.skin : std::visit([&](auto const& of) { return of.usual_skin(s); }, s.method);
}

namespace {

template <class AnySpecies>
void check_species(std::vector<AnySpecies> const& species, bool are_drawn) {
  double sum = 0;
  for (auto const& of : species) {
    require(!are_drawn || species_shares.contains(of.share), fmt::format("share of species '{}'", of.name),
            of.share, species_shares.demand());
    require(positive.contains(mass_of(of)), fmt::format("mass of species '{}'", of.name), mass_of(of),
            positive.demand());
    sum += of.share;
  }
  require(!are_drawn || species.empty() || std::abs(sum - 1) < 1e-9, "sum of the species' shares", sum,
          "must be 1");
}

void check_baths(SimulationSettings const& s) {
  for (auto const& pair : s.faces)
    for (auto const& face : pair)
      require(face.friction.bath || s.features().energies, "bath of a wall", "none",
              "particles without internal energies have no other place for the heat of friction");
}

/// The momenta of a single particle cannot have a temperature and no sum.
void check_lattice(SimulationSettings const& s) {
  if (s.layout) // which has counted them
    return;
  double particles = 1;
  for (auto const n : s.lattice) {
    require(n >= 1, "particles along an edge", n, "must be >= 1");
    particles *= n;
  }
  require(particles >= 2 && particles <= std::numeric_limits<Index>::max(), "particles", particles,
          fmt::format("must be 2 ... {}", std::numeric_limits<Index>::max()));
}

void check_body_force(SimulationSettings const& s) {
  auto const& [a, across, waves] = s.body_force;
  for (double const one : {a.x, a.y, a.z})
    require(any_number.contains(one), "body force", one, any_number.demand());
  require(across >= 0 && across <= 2, "axis of the waves of the body force", across, "must be 0, 1 or 2");
  require(waves >= 0, "waves of the body force", waves, "must be >= 0");
  require(waves == 0 || s.faces[static_cast<std::size_t>(across)][0].kind == FaceKind::periodic,
          "waves of the body force", waves, "must be 0 across faces that are not periodic");
}

} // namespace

void require_one_species(SimulationSettings const& s, std::string_view asked) {
  require(!s.features().masses, "species", s.reduced_species().size(),
          fmt::format("must be one: the {} is known for one equation of state alone", asked));
}

void check_units(SimulationSettings const& s) {
  auto const units = s.units();
  for (auto const& [unit, value] : {std::pair("mass", units.mass()),
                                    {"length", units.length()},
                                    {"energy", units.energy()},
                                    {"time", units.time()},
                                    {"pressure", units.pressure()},
                                    {"viscosity", units.viscosity()}})
    require(
        positive.contains(value), fmt::format("reduced unit of {}", unit), value,
        "must be > 0 and finite: a size, mass, density, temperature or cut-off is too small or too large");
  for (auto const& [length, value] :
       {std::pair("distance between particles", s.spacing()), {"range of the interaction", s.range()}})
    require(positive.contains(value), length, value,
            "must be > 0 and finite in reduced units: the density or a cut-off is too small or too large");
}

void check(SimulationSettings const& s) {
  require(positive.contains(s.rho), "density rho", s.rho, positive.demand());
  require(positive.contains(s.T), "temperature T", s.T, positive.demand());
  require(positive.contains(s.dt), "time step dt", s.dt, positive.demand() + " (reduced units)");
  require(not_negative.contains(s.skin), "skin", s.skin, not_negative.demand());
  require(s.threads >= 1, "threads", s.threads, "must be >= 1");
  require(s.disorders.contains(s.disorder), "disorder", s.disorder,
          s.disorders.demand() + " lattice spacings");
  bool const fills_box = open_axes(s.faces) == std::array<bool, 3>{}; // else it would melt into the vacuum
  require(
      !s.melted || (s.features().densities && !s.layout && fills_box), "start", "\"melted\"",
      "must be \"lattice\" but for sdpd without open faces and regions, whose lattices make their densities");
  check_lattice(s);
  check(s.faces);
  check_baths(s);
  check_body_force(s);
  require(not_negative.contains(s.bath_rate), "rate of the bath", s.bath_rate, not_negative.demand());
  require(s.noise || s.bath_rate == 0, "rate of the bath", s.bath_rate, "must be 0 without noise");
  check(s.scheme, s.features(), s.noise);
  std::visit(
      [&](auto const& method) {
        method.check(s);
        check_species(method.species, !s.layout);
      },
      s.method);
  check_units(s);
  require_cells(box_of(s), s.range() + skin_of(s));
}

} // namespace mesobridge::sdpd
