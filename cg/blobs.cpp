#include "cg/blobs.hpp"
#include <algorithm>
#include <cmath>
#include <numeric>

namespace mesobridge::cg {
namespace {

/// What travels for each blob.
constexpr std::size_t numbers_of_blob = 13;

template <class Value>
std::span<Value const> part(std::vector<Value> const& values, std::size_t first, std::size_t count) {
  return values.empty() ? std::span<Value const>{} : std::span(values).subspan(first, count);
}

} // namespace

BlobMaker::BlobMaker(MoleculeModel model)
    : model_(std::move(model)), steps_(spanning_steps(model_)), whole_(joined_by_bonds(model_)),
      cutoff_(model_.longest_cutoff()), x_(model_.masses.size()), y_(x_), z_(x_), mass_(model_.mass()) {}

void BlobMaker::join(std::span<Vec3 const> q, Box const& box) {
  x_[0] = q[0].x, y_[0] = q[0].y, z_[0] = q[0].z;
  for (auto const& [from, to] : steps_) {
    auto const a = std::size_t(from), b = std::size_t(to);
    Vec3 const step = box.minimum_image(q[b] - q[a]);
    x_[b] = x_[a] + step.x, y_[b] = y_[a] + step.y, z_[b] = z_[a] + step.z;
  }
}

Vec3 BlobMaker::extents(Box const& box) const {
  Vec3 low, high;
  for (std::size_t i = 0; i < x_.size(); ++i) {
    Vec3 const across = box.across({x_[i], y_[i], z_[i]});
    if (i == 0)
      low = high = across;
    low = {std::min(low.x, across.x), std::min(low.y, across.y), std::min(low.z, across.z)};
    high = {std::max(high.x, across.x), std::max(high.y, across.y), std::max(high.z, across.z)};
  }
  return high - low;
}

double BlobMaker::width_in(Box const& box, double reach) const {
  auto const fits = [&](double width, double edge, char const* axis) {
    if (!(width < edge - reach))
      throw PhysicsError(fmt::format("a molecule is {:.4g} wide along {}: in a box {:.4g} wide it meets "
                                     "its own image. Take a larger box (more molecules)",
                                     width, axis, edge));
    if (!whole_ && !(width <= edge / 2))
      throw PhysicsError(fmt::format(
          "a molecule that bonds do not join is {:.4g} wide along {}, more than half of the box, {:.4g}: "
          "nearest images do not tell where its parts are. Take a larger box (more molecules)",
          width, axis, edge));
    return width;
  };
  Vec3 const own = extents(box), room = box.widths();
  return std::max({fits(own.x, room.x, "x"), fits(own.y, room.y, "y"), fits(own.z, room.z, "z")});
}

double BlobMaker::energy_inside() const {
  double energy = 0;
  std::size_t const n = x_.size();
  auto const squared = [&](std::size_t a, std::size_t b) {
    double const dx = x_[a] - x_[b], dy = y_[a] - y_[b], dz = z_[a] - z_[b];
    return dx * dx + dy * dy + dz * dz;
  };
  for (std::size_t a = 0; a < n; ++a)
    for (std::size_t b = a + 1; b < n; ++b)
      energy += model_.law(model_.types[a], model_.types[b]).energy(squared(a, b));
  for (auto const& [a, b] : model_.excluded)
    energy -= model_.law(model_.types[std::size_t(a)], model_.types[std::size_t(b)])
                  .energy(squared(std::size_t(a), std::size_t(b)));
  for (auto const& bond : model_.bonds)
    energy += bond.law.energy(std::sqrt(squared(std::size_t(bond.a), std::size_t(bond.b))));
  return energy;
}

Blob BlobMaker::blob(std::span<Vec3 const> q, std::span<Vec3 const> v, std::span<Vec3 const> f,
                     std::span<double const> potential, Box const& box, std::optional<ToldInside> inside) {
  join(q, box);
  Blob blob;
  blob.width = width_in(box, inside ? inside->reach : cutoff_);
  Vec3 moment;
  for (std::size_t i = 0; i < q.size(); ++i) {
    double const m = model_.masses[i];
    moment += m * Vec3{x_[i], y_[i], z_[i]};
    if (!v.empty())
      blob.P += m * v[i];
    if (!f.empty())
      blob.F += f[i];
  }
  blob.R = box.wrap(moment / mass_);
  Vec3 const V = blob.P / mass_;
  if (!v.empty())
    for (std::size_t i = 0; i < q.size(); ++i)
      blob.U_kin += model_.masses[i] / 2 * norm2(v[i] - V);
  blob.U_pot = inside ? inside->energy : energy_inside();
  if (!potential.empty())
    blob.Phi = std::accumulate(potential.begin(), potential.end(), 0.0) - blob.U_pot;
  return blob;
}

std::vector<Blob> BlobMaker::blobs(md::MoleculeFrame const& frame) {
  std::vector<Blob> result;
  auto const n = std::size_t(frame.atoms_per_molecule);
  for (std::size_t m = 0; m < std::size_t(frame.molecules); ++m) {
    std::optional<ToldInside> inside;
    if (!frame.inside.empty())
      inside = {.energy = frame.inside[m], .reach = frame.reach};
    result.push_back(blob(part(frame.q, m * n, n), part(frame.v, m * n, n), part(frame.f, m * n, n),
                          part(frame.potential, m * n, n), frame.box, inside));
  }
  return result;
}

void refuse_large_molecules(BlobFrame const& frame) {
  if (frame.blobs.empty())
    return;
  double sum = 0;
  for (auto const& blob : frame.blobs)
    sum += blob.width;
  double const edge = frame.box.narrowest();
  if (double const mean = sum / double(frame.blobs.size()); !(mean <= edge / 2))
    throw PhysicsError(
        fmt::format("the molecules are {:.4g} wide on average, more than half of the box, {:.4g}. "
                    "Take a larger box (more molecules)",
                    mean, edge));
}

BlobFrame gather_blobs(md::MpiWorld const& world, md::MoleculeFrame const& frame,
                       std::span<Blob const> of_this_rank) {
  std::vector<double> numbers;
  numbers.reserve(of_this_rank.size() * numbers_of_blob);
  for (auto const& b : of_this_rank)
    numbers.insert(numbers.end(), {b.R.x, b.R.y, b.R.z, b.P.x, b.P.y, b.P.z, b.F.x, b.F.y, b.F.z, b.U_kin,
                                   b.U_pot, b.Phi, b.width});
  auto const all = world.gather_at_root(numbers);
  BlobFrame result{.step = frame.step,
                   .time = frame.time,
                   .box = frame.box,
                   .energy = frame.energy,
                   .pressure = frame.pressure,
                   .blobs = {}};
  for (auto r = all.begin(); r != all.end(); r += numbers_of_blob)
    result.blobs.push_back({.R = {r[0], r[1], r[2]},
                            .P = {r[3], r[4], r[5]},
                            .F = {r[6], r[7], r[8]},
                            .U_kin = r[9],
                            .U_pot = r[10],
                            .Phi = r[11],
                            .width = r[12]});
  refuse_large_molecules(result);
  return result;
}

double total_energy(std::span<Blob const> blobs, double mass) {
  double sum = 0;
  for (auto const& blob : blobs)
    sum += blob.internal_energy() + norm2(blob.P) / (2 * mass);
  return sum;
}

} // namespace mesobridge::cg
