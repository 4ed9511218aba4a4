#include "cg/intermolecular.hpp"
#include "md/error.hpp"
#include <algorithm>
#include <cmath>

namespace mesobridge::cg {
namespace {

/// Atoms sorted into cells at least as wide as the longest cut-off.
class CellGrid {
 public:
  CellGrid(std::span<Vec3 const> q, Box const& box, double reach) : box_(box) {
    double const most = std::cbrt(double(q.size())) + 1; // along an axis: about a cell for each atom
    auto const count = [&](double edge) { return std::max(1, int(std::min(edge / reach, most))); };
    Vec3 const widths = box.widths();
    nx_ = count(widths.x), ny_ = count(widths.y), nz_ = count(widths.z);
    cells_.resize(std::size_t(nx_) * std::size_t(ny_) * std::size_t(nz_));
    for (std::size_t i = 0; i < q.size(); ++i)
      cells_[index(q[i])].push_back(i);
  }

  /// Atoms in the cells about a position, each once.
  template <class Visit>
  void for_each_near(Vec3 const& q, Visit const& visit) const {
    auto const [x, y, z] = place(q);
    for (int i : around(x, nx_))
      for (int j : around(y, ny_))
        for (int k : around(z, nz_))
          for (std::size_t const atom : cells_[flat(i, j, k)])
            visit(atom);
  }

 private:
  /// The cell of a position.
  std::array<int, 3> place(Vec3 const& q) const {
    Vec3 const s = box_.parts(box_.wrap(q));
    auto const along = [](double part, int n) { return std::clamp(int(part * n), 0, n - 1); };
    return {along(s.x, nx_), along(s.y, ny_), along(s.z, nz_)};
  }
  /// The cell and its neighbours along one axis; each once where there are fewer than three.
  static std::vector<int> around(int at, int n) {
    std::vector<int> list{at};
    for (int next : {(at + 1) % n, (at + n - 1) % n})
      if (std::find(list.begin(), list.end(), next) == list.end())
        list.push_back(next);
    return list;
  }
  std::size_t flat(int i, int j, int k) const {
    return (std::size_t(i) * std::size_t(ny_) + std::size_t(j)) * std::size_t(nz_) + std::size_t(k);
  }
  std::size_t index(Vec3 const& q) const {
    auto const [x, y, z] = place(q);
    return flat(x, y, z);
  }

  Box const& box_;
  int nx_, ny_, nz_;
  std::vector<std::vector<std::size_t>> cells_;
};

} // namespace

Intermolecular intermolecular(MoleculeModel const& model, std::span<Vec3 const> q, Box const& box) {
  auto const n = std::size_t(model.atoms());
  double const reach = model.longest_cutoff();
  Intermolecular result{.Phi = std::vector<double>(q.size() / n, 0.0),
                        .F = std::vector<Vec3>(q.size() / n, Vec3{})};
  if (reach == 0)
    return result;
  require(box.narrowest() >= 2 * reach, "narrowest width of the box", box.narrowest(),
          fmt::format("must be at least two cut-offs, {}", 2 * reach));
  CellGrid const grid(q, box, reach);
  for (std::size_t i = 0; i < q.size(); ++i)
    grid.for_each_near(q[i], [&](std::size_t j) {
      if (i / n == j / n)
        return;
      Vec3 const r = box.minimum_image(q[i] - q[j]);
      auto const& law = model.law(model.types[i % n], model.types[j % n]);
      double const r2 = norm2(r);
      if (r2 >= reach * reach)
        return;
      result.Phi[i / n] += law.energy(r2) / 2;
      result.F[i / n] += law.force_over_r(r2) * r;
    });
  return result;
}

} // namespace mesobridge::cg
