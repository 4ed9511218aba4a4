#include "sdpd/step/exact_pair.hpp"
#include "sdpd/step/fluctuation.hpp"
#include <stdexcept>

namespace mesobridge::sdpd {
namespace {

template <class Kernel>
void sweep_block(System& system, Kernel const& kernel, PairScheme scheme, std::size_t number,
                 Sweep const& sweep, PairCounts& counts, Failure& failure) {
  FluctuatingBlock block;
  block.copy_in(system, number);
  for (auto const pair : system.neighbours.pairs(number)) {
    Row const &at_i = block.rows()[pair.i], &at_j = block.rows()[pair.j];
    Vec3 const r{at_i[0] - at_j[0], at_i[1] - at_j[1], at_i[2] - at_j[2]};
    auto const a = block.ids()[pair.i], b = block.ids()[pair.j];
    auto const [G, bits] = gaussians_and_bits_reference(sweep.noise.pairs, std::min(a, b), std::max(a, b));
    ++counts.proposed;
    try {
      ExactPair(system, block, pair)
          .step(scheme, {.e = r / norm(r), .chi = kernel.F(norm(r), 1 / norm(r)) * at_i[3] * at_j[3]},
                {.G = (a < b ? 1.0 : -1.0) * Vec3{G[0], G[1], G[2]},
                 .uniform = acceptance_uniform(sweep.noise.acceptance, std::min(a, b), std::max(a, b), bits)},
                sweep, counts);
    } catch (PhysicsError const& error) {
      failure.report(std::min(a, b), error.what());
      return;
    }
  }
  block.copy_out(system);
}

} // namespace

void fluctuate_plain(System& system, PairScheme scheme, double dt, bool second) {
  if (scheme == PairScheme::ser)
    throw std::logic_error("SER does not go pair after pair");
  std::visit(
      [&](auto const& kernel) {
        sweep_all_blocks(system, dt, second,
                         [&](std::size_t block, Sweep const& sweep, PairCounts& counts, Failure& failure) {
                           sweep_block(system, kernel, scheme, block, sweep, counts, failure);
                         });
      },
      system.kernel);
}

} // namespace mesobridge::sdpd
