#include "workflows/trajectory/frame_blobs.hpp"
#include "cg/intermolecular.hpp"
#include <algorithm>
#include <numeric>

namespace mesobridge::workflows {

namespace {

/// The energy of the bonds of all molecules, whose joined shapes nearest images along the bonds tell.
double bond_energy(cg::MoleculeModel const& model, std::span<Vec3 const> q, Box const& box) {
  double energy = 0;
  auto const n = std::size_t(model.atoms());
  for (std::size_t first = 0; first + n <= q.size(); first += n)
    for (auto const& bond : model.bonds)
      energy += bond.law.energy(
          norm(box.minimum_image(q[first + std::size_t(bond.a)] - q[first + std::size_t(bond.b)])));
  return energy;
}

class BlobsByMapping final : public FrameBlobs {
 public:
  explicit BlobsByMapping(Mapping const& mapping)
      : mapping_(mapping), maker_(mapping.model), reach_(mapping.model.longest_cutoff()) {}

  cg::MoleculeModel const& model() const override { return maker_.model(); }
  bool has_pairs() const override { return reach_ > 0; }
  double reach() const override { return reach_; }

  void expect(TrajectoryReading& reading) const override {
    reading.atoms_per_molecule = std::size_t(model().atoms());
    reading.masses = mapping_.masses;
  }

  FoundBlobs of(TrajectoryFrame const& frame, Box const& box) override {
    FoundBlobs found;
    auto const n = std::size_t(model().atoms());
    auto const others = cg::intermolecular(model(), frame.q, box);
    for (std::size_t m = 0; m < frame.q.size() / n; ++m) {
      auto blob = maker_.blob(std::span(frame.q).subspan(m * n, n), std::span(frame.v).subspan(m * n, n), {},
                              {}, box);
      blob.Phi = others.Phi[m], blob.F = others.F[m];
      found.kinetic += blob.U_kin + norm2(blob.P) / (2 * model().mass());
      found.potential += blob.U_pot + blob.Phi;
      found.blobs.push_back(blob);
    }
    found.bonds = bond_energy(model(), frame.q, box);
    return found;
  }

 private:
  Mapping const& mapping_;
  cg::BlobMaker maker_;
  double reach_;
};

/// All atoms of the system, those of its own kind of molecules first.
std::vector<ExpectedAtom> atoms_of(md::MoleculeSystem const& system) {
  std::vector<ExpectedAtom> atoms;
  auto const add = [&](md::Molecules const& of) {
    auto const masses = of.kind.masses();
    for (std::size_t i = 0; i < of.ids.size(); ++i)
      atoms.push_back({of.ids[i], of.kind.types[i % masses.size()], masses[i % masses.size()]});
  };
  add(system.molecules);
  for (auto const& other : system.others)
    add(other);
  return atoms;
}

class BlobsByLammps final : public FrameBlobs {
 public:
  BlobsByLammps(Mapping const& mapping, std::filesystem::path const& folder)
      : system_(*mapping.system), energy_of_mv2_(mapping.units.energy_of_mv2), maker_(mapping.model),
        atoms_(atoms_of(system_)), whole_(world_, system_, md::FrameEnergies::Of::whole_system, folder),
        inside_(world_, system_, md::FrameEnergies::Of::inside_molecules, folder) {}

  cg::MoleculeModel const& model() const override { return maker_.model(); }
  bool has_pairs() const override { return true; }
  double reach() const override { return norm(system_.molecules.box.edge); } // longer than any cut-off
  void expect(TrajectoryReading& reading) const override { reading.atoms = atoms_; }

  FoundBlobs of(TrajectoryFrame const& frame, Box const& box) override {
    auto const n = std::size_t(model().atoms()), own = n * std::size_t(system_.molecules.count);
    auto const whole = whole_.of(frame.q, box);
    auto const inside = inside_.of(std::span(frame.q).first(own), box);
    FoundBlobs found;
    found.potential = std::accumulate(whole.potential.begin(), whole.potential.end(), 0.0);
    for (std::size_t i = 0; i < atoms_.size(); ++i)
      found.kinetic += energy_of_mv2_ * atoms_[i].mass / 2 * norm2(frame.v[i]);
    for (std::size_t first = 0; first < own; first += n) {
      auto const part = [&](auto const& values) { return std::span(values).subspan(first, n); };
      auto const energies = part(inside.potential);
      found.blobs.push_back(
          maker_.blob(part(frame.q), part(frame.v), part(whole.f), part(whole.potential), box,
                      cg::ToldInside{std::accumulate(energies.begin(), energies.end(), 0.0), inside.reach}));
    }
    return found;
  }

 private:
  md::MpiWorld world_;
  md::MoleculeSystem const& system_;
  double energy_of_mv2_;
  cg::BlobMaker maker_;
  std::vector<ExpectedAtom> atoms_;
  md::FrameEnergies whole_, inside_;
};

} // namespace

std::unique_ptr<FrameBlobs> blobs_by(Mapping const& mapping, std::filesystem::path const& folder) {
  if (mapping.system)
    return std::make_unique<BlobsByLammps>(mapping, folder);
  return std::make_unique<BlobsByMapping>(mapping);
}

} // namespace mesobridge::workflows
