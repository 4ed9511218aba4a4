#include "sdpd/step/fluctuation_ssa.hpp"
#include "sdpd/step/fluctuation_sweep.hpp"

namespace mesobridge::sdpd {
namespace {

/// One pair's step in double precision.
void fluctuate_pair(FluctuatingParticle& a, FluctuatingParticle& b, Vec3 const& e, double chi, Vec3 const& G,
                    Sweep const& sweep) {
  PairBath<double> const bath(sweep.boltzmann, a.caloric.T(a.u), b.caloric.T(b.u), a.caloric.inverse_C(a.u),
                              b.caloric.inverse_C(b.u));
  auto const [par, perp] = bath.step(sweep.friction.par(chi), sweep.friction.perp(chi), false, sweep.dt);
  Vec3 const v = a.p - b.p;
  Vec3 const dv = perp.decay * v + perp.kick * G +
                  ((par.decay - perp.decay) * dot(e, v) + (par.kick - perp.kick) * dot(e, G)) * e;
  double const heat = -0.125 * dot(dv, 2 * v + dv);
  a.p += 0.5 * dv, b.p -= 0.5 * dv;
  a.u += heat, b.u += heat;
}

template <class Kernel>
void sweep_block_plain(System& system, Kernel const& kernel, std::size_t number, NoiseSource const& source,
                       Sweep const& sweep, Failure& failure) {
  FluctuatingBlock block;
  block.copy_in(system, number);
  auto& particles = block.particles();
  for (auto const [i, j] : system.neighbours.pairs(number)) {
    Row const &at_i = block.rows()[i], &at_j = block.rows()[j];
    Vec3 const r{at_i[0] - at_j[0], at_i[1] - at_j[1], at_i[2] - at_j[2]};
    auto const a = block.ids()[i], b = block.ids()[j];
    auto const G = gaussians_reference(source, std::min(a, b), std::max(a, b));
    fluctuate_pair(particles[i], particles[j], r / norm(r),
                   kernel.F(norm(r), 1 / norm(r)) * at_i[3] * at_j[3],
                   (a < b ? 1.0 : -1.0) * Vec3{G[0], G[1], G[2]}, sweep);
    for (std::size_t const local : {i, j})
      if (!particles[local].caloric.in_reach(particles[local].u) && !block.renew(system, local, failure))
        return;
  }
  block.copy_out(system);
}

} // namespace

void fluctuate_ssa_plain(System& system, double dt) {
  Sweep const sweep{system.friction, system.boltzmann, dt};
  std::visit(
      [&](auto const& kernel) {
        sweep_all_blocks(system, [&](std::size_t block, NoiseSource const& source, Failure& failure) {
          sweep_block_plain(system, kernel, block, source, sweep, failure);
        });
      },
      system.kernel);
}

} // namespace mesobridge::sdpd
