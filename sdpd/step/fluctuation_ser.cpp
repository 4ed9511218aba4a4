#include "sdpd/step/fluctuation.hpp"
#include "sdpd/step/fluctuation_sweep.hpp"
#include "sdpd/step/pair_lanes.hpp"

namespace mesobridge::sdpd {
namespace {

/// What a pair gives to its first particle and takes from its second, -Gamma v dt + Sigma G sqrt(dt), all
/// pairs at the velocities and temperatures of the start.
[[gnu::always_inline]] inline VectorLanes<Lanes> impulse(ParticleLanes const& a, ParticleLanes const& b,
                                                         VectorLanes<Lanes> const& relative,
                                                         InputLanes const& input, Sweep const& sweep) {
  BathLanes const bath(sweep.boltzmann, to_float(a.caloric.T_0), to_float(b.caloric.T_0),
                       to_float(a.caloric.inverse_C_0), to_float(b.caloric.inverse_C_0));
  FloatLanes const dt = constant<FloatLanes>(sweep.dt);
  FloatLanes const gamma_par = sweep.friction.par(input.chi) * bath.one_minus_d * dt,
                   gamma_perp = sweep.friction.perp(input.chi) * bath.one_minus_d * dt;
  FloatLanes const sigma_par = square_root(bath.thermal * gamma_par),
                   sigma_perp = square_root(bath.thermal * gamma_perp);
  VectorLanes<FloatLanes> const v{to_float(relative.x), to_float(relative.y), to_float(relative.z)};
  auto const &e = input.e, &G = input.G;
  FloatLanes const along = (gamma_perp - gamma_par) * dot(e, v) + (sigma_par - sigma_perp) * dot(e, G);
  return {to_double(sigma_perp * G.x - gamma_perp * v.x + along * e.x),
          to_double(sigma_perp * G.y - gamma_perp * v.y + along * e.y),
          to_double(sigma_perp * G.z - gamma_perp * v.z + along * e.z)};
}

/// Calls f(pair, count, a, b, v, impulse) for the pairs of a block, eight at a time.
template <class F>
void for_each_impulse(System const& system, FluctuatingBlock& block, std::size_t number,
                      PairInputs& inputs, Sweep const& sweep, F const& f) {
  auto const pairs = system.neighbours.pairs(number);
  prepare_pairs(block, system.kernel, pairs, sweep.noise.pairs, inputs);
  auto const* const particles = block.particles().data();
  for_each_group(pairs, block.size(), [&](LocalPair const* pair, std::size_t first, std::size_t count) {
    ParticleLanes const a(load_lines([&](std::size_t l) { return &particles[pair[l].i]; }));
    ParticleLanes const b(load_lines([&](std::size_t l) { return &particles[pair[l].j]; }));
    VectorLanes<Lanes> const v{a.p_x - b.p_x, a.p_y - b.p_y, a.p_z - b.p_z};
    f(pair, count, v, impulse(a, b, v, InputLanes(inputs, first), sweep));
  });
}

/// The block's part of the impulses of its particles.
void add_impulses(System& system, std::size_t number, Sweep const& sweep) {
  thread_local FluctuatingBlock block;
  thread_local PairInputs inputs;
  thread_local std::vector<Row> sums;
  block.copy_in(system, number);
  sums.assign(block.size() + 2, Row{});
  for_each_impulse(
      system, block, number, inputs, sweep,
      [&](LocalPair const* pair, std::size_t count, VectorLanes<Lanes> const&, VectorLanes<Lanes> const& dp) {
        auto const rows = to_rows({dp.x, dp.y, dp.z, Lanes{}});
        for (std::size_t l = 0; l < count; ++l) {
          sums[pair[l].i] += rows[l];
          sums[pair[l].j] -= rows[l];
        }
      });
  for_each_member(block.members(), [&](std::size_t local, Index i, Vec3 const&) {
    Row const& sum = sums[local];
    system.impulse[i] += Vec3{sum[0], sum[1], sum[2]};
  });
}

/// The block's part of the heat of its particles, -(1/2) dp_ij (v_ij + (dp_i - dp_j)/2): with it the energy
/// is conserved exactly, whatever the other pairs do.
void add_heat(System& system, std::size_t number, Sweep const& sweep) {
  thread_local FluctuatingBlock block;
  thread_local PairInputs inputs;
  thread_local std::vector<Vec3> total;
  thread_local std::vector<double> heat;
  block.copy_in(system, number);
  total.assign(block.size() + 2, {}), heat.assign(block.size(), 0);
  for_each_member(block.members(),
                  [&](std::size_t local, Index i, Vec3 const&) { total[local] = system.impulse[i]; });
  for_each_impulse(
      system, block, number, inputs, sweep,
      [&](LocalPair const* pair, std::size_t count, VectorLanes<Lanes> const& v,
          VectorLanes<Lanes> const& dp) {
        for (std::size_t l = 0; l < count; ++l) {
          Vec3 const mean = Vec3{v.x[l], v.y[l], v.z[l]} + 0.5 * (total[pair[l].i] - total[pair[l].j]);
          double const given = -0.5 * dot(Vec3{dp.x[l], dp.y[l], dp.z[l]}, mean);
          heat[pair[l].i] += given, heat[pair[l].j] += given;
        }
      });
  for_each_member(block.members(),
                  [&](std::size_t local, Index i, Vec3 const&) { system.energy_gain[i] += heat[local]; });
}

/// Gives impulses and heat to the particles.
void apply(System& system) {
  auto& particles = system.particles;
  Failure failure;
  for_each_range(system, [&](Range range) {
    for (std::size_t i = range.begin; i < range.end; ++i) {
      particles.p[i] += system.impulse[i];
      particles.eps[i] += system.energy_gain[i];
      double const T = particles.caloric[i].T(system.energy_gain[i]);
      if (!(T > 0))
        failure.report(
            particles.id[i],
            fmt::format("fluctuation and dissipation (SER) took its internal energy to {:.6g} (in K "
                        "k_B T), where its temperature is not positive; take a shorter time step",
                        particles.eps[i]));
      particles.T[i] = T;
    }
  });
  system.stop_at(failure);
}

} // namespace

void fluctuate_ser(System& system, double dt, bool second) {
  system.impulse.assign(system.size(), {});
  system.energy_gain.assign(system.size(), 0);
  Sweep const sweep{system.friction, system.boltzmann, dt, SweepNoise(system, second)};
  auto const& grid = system.neighbours.grid();
  for_each_block(grid, system.threads, [&](std::size_t block) { add_impulses(system, block, sweep); });
  for_each_block(grid, system.threads, [&](std::size_t block) { add_heat(system, block, sweep); });
  apply(system);
}

} // namespace mesobridge::sdpd
