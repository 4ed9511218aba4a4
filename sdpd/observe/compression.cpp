#include "sdpd/observe/compression.hpp"
#include "sdpd/neighbours/block_copy.hpp"
#include "sdpd/observe/measurement.hpp"

namespace mesobridge::sdpd {

double compression_response(System const& system) {
  auto const& neighbours = system.neighbours;
  double sum = 0; // of m F r^2 over the pairs, m the mean of the two masses
  std::vector<Row> rows;
  std::visit(
      [&](auto const& kernel) {
        for (std::size_t block = 0; block < neighbours.grid().blocks().size(); ++block) {
          auto const mass = [&](Index i) { return system.particles.mass_of(i); };
          copy_rows(neighbours.members(block), system.particles.q, mass, 0, rows);
          for (auto const& pair : neighbours.pairs(block)) {
            Row const &a = rows[pair.i], &b = rows[pair.j];
            double const r2 = norm2(Vec3{a[0] - b[0], a[1] - b[1], a[2] - b[2]}), r = std::sqrt(r2);
            sum += 0.5 * (a[3] + b[3]) * kernel.F(r, 1 / r) * r2;
          }
        }
      },
      system.kernel);
  return 2 * sum / (3 * static_cast<double>(system.size()));
}

Measurement compression_response() {
  return {
      .name = "compression_response",
      .meaning = "d<rho>/d ln(1/V) at an affine compression: 1 where densities follow the mass per volume",
      .exists = [](Features const& has) { return with_densities(has) && without_walls(has); },
      .values = [](System const& system) -> std::vector<double> { return {compression_response(system)}; },
      .pair_passes = 1};
}

} // namespace mesobridge::sdpd
