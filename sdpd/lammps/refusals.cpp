#include "sdpd/lammps/block_sweep.hpp"
#include "sdpd/lammps/lammps_engine.hpp"

namespace mesobridge::sdpd {
namespace {

/// One thing that the engine inside LAMMPS does not do.
struct Refusal {
  bool (*asked)(SimulationSettings const&);
  std::string_view what; ///< begins with the name of the setting
};

bool has_walls_or_open_faces(SimulationSettings const& s) {
  auto const box = box_of(s);
  return !(box.periodic[0] && box.periodic[1] && box.periodic[2]);
}

constexpr std::array<Refusal, 11> refusals{{
    {[](auto const& s) { return s.scheme.pairs != "ser" && !scheme_in_turn(s.scheme.pairs); },
     "scheme.name: the LAMMPS engine has ser, which steps all pairs at once, ssa, ams and ems"},
    {[](auto const& s) { return s.scheme.conservative != "verlet"; },
     "scheme.conservative: the LAMMPS engine has verlet alone"},
    {[](auto const& s) { return s.scheme.splitting != Splitting::lie_trotter; },
     "scheme.splitting = strang: not in the LAMMPS engine"},
    {[](auto const& s) { return s.scheme.keep_energy; }, "scheme.energy = kept: not in the LAMMPS engine"},
    {has_walls_or_open_faces, "box.x, box.y, box.z: walls and open faces are not in the LAMMPS engine"},
    {[](auto const& s) { return s.layout != nullptr; }, "regions: not in the LAMMPS engine"},
    {[](auto const& s) { return s.body_force.acts(); }, "box.body_force: not in the LAMMPS engine"},
    {[](auto const& s) { return !s.reduced_species().empty(); },
     "species: the LAMMPS engine runs fluids of one species"},
    {[](auto const& s) { return s.conducts(); }, "conduction: not in the LAMMPS engine"},
    {[](auto const& s) { return scheme_in_turn(s.scheme.pairs) && !BlockSweep::fits(box_of(s), s.range()); },
     "scheme.name: pairs in turn inside LAMMPS want a box of four ranges of the interaction along each axis"},
    {[](auto const& s) { return s.features().reacts; }, "reaction: not in the LAMMPS engine"},
}};

} // namespace

std::vector<std::string> lammps_refusals(SimulationSettings const& settings) {
  std::vector<std::string> found;
  for (auto const& [asked, what] : refusals)
    if (asked(settings))
      found.emplace_back(what);
  return found;
}

void refuse_for_lammps(SimulationSettings const& settings) {
  if (auto const found = lammps_refusals(settings); !found.empty())
    throw InputError(found.front());
}

} // namespace mesobridge::sdpd
