#include "sdpd/observe/bond_order.hpp"
#include "sdpd/neighbours/block_copy.hpp"
#include "sdpd/observe/measurement.hpp"
#include <cmath>

namespace mesobridge::sdpd {
namespace {

using Harmonics = std::array<double, 13>;

struct Bond {
  Index i, j;
};

double product(Harmonics const& a, Harmonics const& b) {
  double sum = 0;
  for (std::size_t k = 0; k < a.size(); ++k)
    sum += a[k] * b[k];
  return sum;
}

void add(Harmonics& sum, Harmonics const& of) {
  for (std::size_t k = 0; k < sum.size(); ++k)
    sum[k] += of[k];
}

/// Sums of the harmonics over the bonds of each particle.
class Bonds {
 public:
  explicit Bonds(System const& system)
      : of_particle_(system.size()), count_(system.size()),
        longest_(bond_length * std::cbrt(system.box.volume() / static_cast<double>(system.size()))) {
    std::vector<Row> rows;
    for (std::size_t block = 0; block < system.neighbours.grid().blocks().size(); ++block)
      gather(system, block, rows);
  }

  /// The root of the sum's square over its number of bonds, which is 1 where all point one way.
  double local() const {
    double sum = 0;
    for (std::size_t i = 0; i < count_.size(); ++i)
      if (count_[i] > 0)
        sum += std::sqrt(product(of_particle_[i], of_particle_[i])) / count_[i];
    return sum / static_cast<double>(count_.size());
  }

  double global() const {
    Harmonics sum{};
    for (auto const& of : of_particle_)
      add(sum, of);
    return bonds_.empty() ? 0 : std::sqrt(product(sum, sum)) / (2 * static_cast<double>(bonds_.size()));
  }

  double crystal() const {
    constexpr double alike = 0.5, most = 0.75; // see (S82)
    std::vector<double> bonds_alike(count_.size());
    for (auto const [i, j] : bonds_) {
      auto const &a = of_particle_[i], &b = of_particle_[j];
      if (product(a, b) > alike * std::sqrt(product(a, a) * product(b, b)))
        ++bonds_alike[i], ++bonds_alike[j];
    }
    double crystal = 0;
    for (std::size_t i = 0; i < count_.size(); ++i)
      crystal += count_[i] > 0 && bonds_alike[i] > most * count_[i];
    return crystal / static_cast<double>(count_.size());
  }

 private:
  void gather(System const& system, std::size_t block, std::vector<Row>& rows) {
    auto const members = system.neighbours.members(block);
    copy_rows(
        members, system.particles.q, [](Index) { return 0.0; }, 0, rows);
    for (auto const& [a, b] : system.neighbours.pairs(block)) {
      Row const r = rows[a] - rows[b];
      Vec3 const apart{r[0], r[1], r[2]};
      double const distance = norm(apart);
      if (!(distance < longest_) || distance == 0)
        continue;
      auto const harmonics = sixth_harmonics(apart / distance);
      Bond const bond{global_index(members, a), global_index(members, b)};
      add(of_particle_[bond.i], harmonics), add(of_particle_[bond.j], harmonics);
      ++count_[bond.i], ++count_[bond.j];
      bonds_.push_back(bond);
    }
  }

  std::vector<Harmonics> of_particle_;
  std::vector<double> count_;
  std::vector<Bond> bonds_;
  double longest_;
};

} // namespace

/// (x + iy)^m times the m-th derivative of P6 at z, normalised.
std::array<double, 13> sixth_harmonics(Vec3 const& e) {
  double const z = e.z, zz = z * z;
  std::array<double, 7> const derivative{(((231 * zz - 315) * zz + 105) * zz - 5) / 16,
                                         ((1386 * zz - 1260) * zz + 210) * z / 16,
                                         ((6930 * zz - 3780) * zz + 210) / 16,
                                         (27720 * zz - 7560) * z / 16,
                                         (83160 * zz - 7560) / 16,
                                         166320 * z / 16,
                                         166320.0 / 16};
  Harmonics of{derivative[0]};
  double real = 1, imaginary = 0, square = 1; // of (x + iy)^m, and (6-m)!/(6+m)!
  for (std::size_t m = 1; m <= 6; ++m) {
    std::tie(real, imaginary) = std::pair(real * e.x - imaginary * e.y, real * e.y + imaginary * e.x);
    square /= static_cast<double>((6 + m) * (7 - m));
    double const factor = std::sqrt(2 * square) * derivative[m];
    of[2 * m - 1] = factor * real, of[2 * m] = factor * imaginary;
  }
  return of;
}

BondOrder bond_order(System const& system) {
  Bonds const bonds(system);
  return {bonds.local(), bonds.global(), bonds.crystal()};
}

Measurement bond_order() {
  static constexpr std::array<std::string_view, 3> components{"_local", "_global", "_crystal"};
  return {.name = "bond_order",
          .meaning =
              "q6 of a particle's nearest neighbours, Q6 of all bonds, share of crystal-like particles",
          .components = components,
          .exists = without_walls,
          .values = [](System const& system) -> std::vector<double> {
            auto const order = bond_order(system);
            return {order.local, order.global, order.crystal};
          },
          .pair_passes = 1,
          .fills_box = true};
}

} // namespace mesobridge::sdpd
