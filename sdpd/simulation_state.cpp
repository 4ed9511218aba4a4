#include "sdpd/boundary/wall_friction.hpp"
#include "sdpd/conservative/conservative.hpp"
#include "sdpd/conservative/refresh.hpp"
#include "sdpd/observe/virials.hpp"
#include "sdpd/reaction/reaction.hpp"
#include "sdpd/simulation.hpp"
#include "sdpd/state/checkpoint.hpp"
#include "sdpd/system/system.hpp"
#include "sdpd/system/total_energy.hpp"
#include <algorithm>

// What a simulation tells of its particles, and how it goes on from that.

namespace mesobridge::sdpd {
namespace {

void check_lengths(Checkpoint const& c, Particles const& of) {
  for (auto const length :
       {c.particles.id.size(), c.particles.q.size(), c.q_at_renewal.size(), c.particles.p.size()})
    require(length == of.size(), "particles in the checkpoint", length,
            fmt::format("must be {} as in the scene", of.size()));
  for (auto const& field : fields)
    if (auto const length = (c.particles.*field.values).size(); field.checkpointed)
      require(length == (of.*field.values).size(), fmt::format("values of {} in the checkpoint", field.name),
              length, fmt::format("must be {} as in the scene", (of.*field.values).size()));
}

/// What is asked of positions and fields before cells are looked up by them.
void check_values(Checkpoint const& c, Box const& box) {
  auto within = [&](Vec3 const& q, int axis) {
    double const value = component(q, axis);
    return box.periodic[static_cast<unsigned>(axis)] ? value >= 0 && value <= component(box.edge, axis)
                                                     : std::isfinite(value);
  };
  for (auto const& q : c.q_at_renewal)
    require(within(q, 0) && within(q, 1) && within(q, 2), "a position in the checkpoint",
            fmt::format("({}, {}, {})", q.x, q.y, q.z),
            fmt::format("must be in the box of {} x {} x {}", box.edge.x, box.edge.y, box.edge.z));
  double const furthest = std::min({box.edge.x, box.edge.y, box.edge.z});
  for (std::size_t i = 0; i < c.particles.q.size(); ++i) {
    double const way = norm(c.particles.q[i] - c.q_at_renewal[i]);
    require(way <= furthest, "a way between two renewals in the checkpoint", way,
            fmt::format("must be at most the box's edge {}", furthest));
  }
  for (auto const& field : fields)
    for (double const value : c.particles.*field.values)
      require(field.range.contains(value), fmt::format("a value of {} in the checkpoint", field.name), value,
              field.range.demand());
}

/// What a checkpoint keeps of the particles.
void take_checkpointed(Particles& to, Particles const& from) {
  to.id = from.id, to.q = from.q, to.p = from.p;
  for (auto const& field : fields)
    if (field.checkpointed)
      to.*field.values = from.*field.values;
}

void restore_walls(System& system, std::vector<double> const& of) {
  std::size_t const numbers = system.walls.empty() ? 0 : 2 * system.walls.size() + 1;
  require(of.size() == numbers, "numbers of walls in the checkpoint", of.size(),
          fmt::format("must be {} as in the scene", numbers));
  for (std::size_t k = 0; k < system.walls.size(); ++k)
    system.walls[k].impulse = of[2 * k], system.walls[k].work = of[2 * k + 1];
  if (!of.empty())
    system.wall_time = of.back();
}

bool has_flow(System const& system) {
  return system.body_force.acts() || has_rough_walls(system);
}

std::vector<double> flow_of(System const& system) {
  std::vector<double> flow;
  if (!has_flow(system))
    return flow;
  for (auto const& wall : system.walls)
    flow.insert(flow.end(), {wall.drag.x, wall.drag.y, wall.drag.z, wall.heat});
  flow.insert(flow.end(), {system.body_work, system.sink_heat});
  return flow;
}

void restore_flow(System& system, std::vector<double> const& of) {
  std::size_t const numbers = has_flow(system) ? 4 * system.walls.size() + 2 : 0;
  require(of.size() == numbers, "numbers of the flow in the checkpoint", of.size(),
          fmt::format("must be {} as in the scene", numbers));
  if (of.empty())
    return;
  for (std::size_t k = 0; k < system.walls.size(); ++k)
    system.walls[k].drag = {of[4 * k], of[4 * k + 1], of[4 * k + 2]}, system.walls[k].heat = of[4 * k + 3];
  system.body_work = of[numbers - 2], system.sink_heat = of[numbers - 1];
}

/// Time of the reaction, and the rates of the last part of a time step where the next one begins with them.
std::vector<double> reaction_of(System const& system) {
  if (!system.reaction)
    return {};
  std::vector<double> of{system.reaction_time};
  if (looks_back(*system.reaction))
    for (std::size_t id = 0; id < system.size(); ++id) {
      auto const [forward, backward] = id < system.rates.size() ? system.rates[id] : Rates{};
      of.insert(of.end(), {forward, backward});
    }
  return of;
}

void restore_reaction(System& system, std::vector<double> const& of) {
  std::size_t const rates = system.reaction && looks_back(*system.reaction) ? system.size() : 0,
                    numbers = system.reaction ? 1 + 2 * rates : 0;
  if (rates > 0 && of.size() == 1)
    throw InputError(
        "the checkpoint is of an earlier state of the program, which did not keep the rates of a "
        "reaction: begin anew with --force or in another folder");
  require(of.size() == numbers, "numbers of the reaction in the checkpoint", of.size(),
          fmt::format("must be {} as in the scene", numbers));
  for (double const number : of)
    require(not_negative.contains(number), "time or rate of the reaction in the checkpoint", number,
            not_negative.demand());
  if (!of.empty())
    system.reaction_time = of[0];
  system.rates.resize(rates);
  for (std::size_t id = 0; id < rates; ++id)
    system.rates[id] = {of[2 * id + 1], of[2 * id + 2]};
}

} // namespace

Snapshot Simulation::snapshot() const {
  auto const& particles = system_->particles;
  Snapshot s;
  s.id.resize(size()), s.q.resize(size()), s.p.resize(size());
  for (std::size_t i = 0; i < size(); ++i) {
    auto const id = particles.id[i];
    s.id[id] = id, s.q[id] = box().wrap(particles.q[i]), s.p[id] = particles.p[i];
  }
  s.species = system_->species_of_id;
  for (auto const& field : fields) {
    auto const& values = particles.*field.values;
    (s.*field.values).resize(values.size());
    for (std::size_t i = 0; i < values.size(); ++i)
      (s.*field.values)[particles.id[i]] = values[i];
  }
  return s;
}

Snapshot Simulation::snapshot_with_virials() const {
  auto s = snapshot();
  s.virial = virials(*system_);
  return s;
}

Checkpoint Simulation::checkpoint() const {
  auto const renewed = system_->neighbours.positions_at_renewal();
  Checkpoint c{.step = system_->step,
               .particles = {},
               .q_at_renewal = {renewed.begin(), renewed.end()},
               .kept_energy = system_->kept_energy,
               .pair_counts = system_->pair_counts,
               .conduction_counts = system_->conduction_counts};
  take_checkpointed(c.particles, system_->particles);
  for (auto const& wall : system_->walls)
    c.walls.insert(c.walls.end(), {wall.impulse, wall.work});
  if (!c.walls.empty())
    c.walls.push_back(system_->wall_time);
  c.flow = flow_of(*system_);
  c.reaction = reaction_of(*system_);
  return c;
}

void Simulation::restore(Checkpoint const& c) {
  auto& particles = system_->particles;
  check_lengths(c, particles);
  check_values(c, box());
  // The lists of the checkpoint are those of its last renewal: renew them there, then move on.
  take_checkpointed(particles, c.particles);
  system_->label_particles();
  particles.q = c.q_at_renewal;
  system_->neighbours.renew(particles);
  particles.q = c.particles.q;
  restore_walls(*system_, c.walls);
  restore_flow(*system_, c.flow);
  restore_reaction(*system_, c.reaction);
  system_->step = c.step;
  system_->kept_energy = c.kept_energy, system_->pair_counts = c.pair_counts;
  system_->conduction_counts = c.conduction_counts;
  refresh_by(*system_, response_from_temperature);
}

void Simulation::begin_from(Checkpoint const& c) {
  auto& particles = system_->particles;
  check_lengths(c, particles);
  take_checkpointed(particles, c.particles);
  system_->label_particles();
  restore_walls(*system_, c.walls);
  restore_flow(*system_, c.flow);
  restore_reaction(*system_, c.reaction);
  system_->step = c.step;
  system_->neighbours.renew(particles);
  refresh(*system_);
}

} // namespace mesobridge::sdpd
