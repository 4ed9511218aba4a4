#include "sdpd/conservative/conservative.hpp"
#include "sdpd/conservative/refresh.hpp"
#include "sdpd/observe/virials.hpp"
#include "sdpd/simulation.hpp"
#include "sdpd/state/checkpoint.hpp"
#include "sdpd/system/system.hpp"
#include "sdpd/system/total_energy.hpp"
#include <algorithm>

// What a simulation tells of its particles, and how it goes on from that.

namespace mesobridge::sdpd {
namespace {

void check_lengths(Checkpoint const& c, Particles const& of) {
  for (auto const length : {c.id.size(), c.q.size(), c.q_at_renewal.size(), c.p.size()})
    require(length == of.size(), "particles in the checkpoint", length,
            fmt::format("must be {} as in the scene", of.size()));
  for (auto const length : {c.eps.size(), c.T.size()})
    require(length == of.eps.size(), "internal energies in the checkpoint", length,
            fmt::format("must be {} as in the scene", of.eps.size()));
  require(c.S.size() == of.S.size(), "entropies in the checkpoint", c.S.size(),
          fmt::format("must be {} as in the scene", of.S.size()));
}

/// What is asked of positions and temperatures before cells are looked up by them.
void check_values(Checkpoint const& c, Box const& box) {
  auto within = [](double value, double edge) { return value >= 0 && value <= edge; };
  for (auto const& q : c.q_at_renewal)
    require(within(q.x, box.edge.x) && within(q.y, box.edge.y) && within(q.z, box.edge.z),
            "a position in the checkpoint", fmt::format("({}, {}, {})", q.x, q.y, q.z),
            fmt::format("must be in the box of {} x {} x {}", box.edge.x, box.edge.y, box.edge.z));
  double const furthest = std::min({box.edge.x, box.edge.y, box.edge.z});
  for (std::size_t i = 0; i < c.q.size(); ++i)
    require(norm(c.q[i] - c.q_at_renewal[i]) <= furthest, "a way between two renewals in the checkpoint",
            norm(c.q[i] - c.q_at_renewal[i]), fmt::format("must be at most the box's edge {}", furthest));
  for (double const T : c.T)
    require(T > 0, "a temperature in the checkpoint", T, "must be > 0");
}

} // namespace

Snapshot Simulation::snapshot() const {
  auto const& particles = system_->particles;
  std::size_t const n = particles.size();
  std::size_t const energies = particles.eps.size(), densities = particles.rho.size();
  Snapshot s{std::vector<Vec3>(n),           std::vector<Vec3>(n),          std::vector<double>(energies),
             std::vector<double>(densities), std::vector<double>(energies), std::vector<double>(densities)};
  for (std::size_t i = 0; i < n; ++i) {
    auto const id = particles.id[i];
    s.q[id] = box().wrap(particles.q[i]), s.p[id] = particles.p[i];
    if (energies > 0)
      s.eps[id] = particles.eps[i], s.T[id] = particles.T[i];
    if (densities > 0)
      s.rho[id] = particles.rho[i], s.P[id] = particles.P[i];
  }
  return s;
}

Snapshot Simulation::snapshot_with_virials() const {
  auto s = snapshot();
  s.virial = virials(*system_);
  return s;
}

Checkpoint Simulation::checkpoint() const {
  auto const& particles = system_->particles;
  auto const renewed = system_->neighbours.positions_at_renewal();
  return {system_->step,
          particles.id,
          particles.q,
          {renewed.begin(), renewed.end()},
          particles.p,
          particles.eps,
          particles.S,
          particles.T,
          system_->kept_energy,
          system_->pair_counts,
          system_->conduction_counts};
}

void Simulation::restore(Checkpoint const& c) {
  auto& particles = system_->particles;
  check_lengths(c, particles);
  check_values(c, box());
  // The lists of the checkpoint are those of its last renewal: renew them there, then move on.
  particles.id = c.id, particles.p = c.p, particles.eps = c.eps, particles.S = c.S, particles.T = c.T;
  particles.q = c.q_at_renewal;
  system_->neighbours.renew(particles);
  particles.q = c.q;
  system_->step = c.step;
  system_->kept_energy = c.kept_energy, system_->pair_counts = c.pair_counts;
  system_->conduction_counts = c.conduction_counts;
  refresh_by(*system_, response_from_temperature);
}

void Simulation::begin_from(Checkpoint const& c) {
  auto& particles = system_->particles;
  check_lengths(c, particles);
  particles.id = c.id, particles.q = c.q, particles.p = c.p, particles.eps = c.eps, particles.T = c.T;
  system_->step = c.step;
  system_->neighbours.renew(particles);
  refresh(*system_);
}

} // namespace mesobridge::sdpd
