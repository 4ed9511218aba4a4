#include "fitting/eos/tabulated.hpp"

namespace mesobridge::fitting {
namespace {

using quintic::dot, quintic::order, quintic::Row, quintic::row, quintic::weights;

/// sum_k w[k] row_k of the six rows from `first` on.
Row combine(double const* first, std::size_t stride, Row w) {
  Row sum = w[0] * row(first);
  for (int k = 1; k < order; ++k)
    sum += w[k] * row(first + static_cast<std::size_t>(k) * stride);
  return sum;
}

[[noreturn]] void refuse_state(EntropyTable const& table, double e, double rho) {
  throw PhysicsError(fmt::format("table: the state of density {}, energy {} is outside {} <= rho <= {}, "
                                 "{} <= T <= {}",
                                 rho, e, table.density.low, table.density.high, table.T_min, table.T_max));
}

} // namespace

EntropyJet EntropyTable::at(double e, double rho) const {
  if (!(rho >= density.low && rho <= density.high))
    refuse_state(*this, e, rho);
  auto const i = density.place(rho);
  double const per_x = 1 / density.width(), per_y = 1 / y.width();
  Row const x0 = weights(i.t), x1 = weights<1>(i.t), x2 = weights<2>(i.t), base = row(&e_0[i.cell]);
  double const b1 = dot(x1, base) * per_x, b2 = dot(x2, base) * per_x * per_x;
  double const z = e - dot(x0, base), at = std::log(z / e_1);
  if (!(at >= y.low && at <= y.high))
    refuse_state(*this, e, rho);
  auto const j = y.place(at);
  double const* const corner = &S[i.cell * stride + j.cell];
  Row const y0 = weights(j.t), y1 = weights<1>(j.t), y2 = weights<2>(j.t), y3 = weights<3>(j.t);
  Row const v0 = combine(corner, stride, x0), v1 = combine(corner, stride, x1),
            v2 = combine(corner, stride, x2);
  double const S_y = dot(y1, v0) * per_y, S_yy = dot(y2, v0) * per_y * per_y;
  double const S_yyy = dot(y3, v0) * per_y * per_y * per_y;
  double const S_x = dot(y0, v1) * per_x, S_xy = dot(y1, v1) * per_x * per_y;
  double const S_xx = dot(y0, v2) * per_x * per_x;
  // y = ln[(e - e_0(rho))/e_1]
  double const iz = 1 / z, y_rho = -b1 * iz, y_rho_rho = -b2 * iz - b1 * b1 * iz * iz;
  return {.s = dot(y0, v0) - R * std::log(rho),
          .e = S_y * iz,
          .ee = (S_yy - S_y) * iz * iz,
          .eee = (S_yyy - 3 * S_yy + 2 * S_y) * iz * iz * iz,
          .rho = -R / rho + S_x + S_y * y_rho,
          .e_rho = (S_xy + S_yy * y_rho + S_y * b1 * iz) * iz,
          .rho_rho = R / (rho * rho) + S_xx + 2 * S_xy * y_rho + S_yy * y_rho * y_rho + S_y * y_rho_rho};
}

TabulatedIsochore::TabulatedIsochore(EntropyTable const& table, double rho) : table_(&table), rho_(rho) {
  if (!(rho >= table.density.low && rho <= table.density.high))
    throw PhysicsError(fmt::format("table: density {} is outside {} <= rho <= {}", rho, table.density.low,
                                   table.density.high));
  auto const i = table.density.place(rho);
  e_0_ = dot(weights(i.t), row(&table.e_0[i.cell]));
  // A little inside, so that the logarithm of either is inside too.
  constexpr double inside = 1e-14;
  z_min_ = table.e_1 * std::exp(table.y.low) * (1 + inside);
  z_max_ = table.e_1 * std::exp(table.y.high) * (1 - inside);
}

void TabulatedIsochore::refuse(std::string_view quantity, double value) const {
  throw PhysicsError(fmt::format("table at density {}: {} {} is outside {} <= T <= {}", rho_, quantity, value,
                                 table_->T_min, table_->T_max));
}

double TabulatedIsochore::energy(double T) const {
  auto const jet = [this](double z) {
    auto const s = table_->at(e_0_ + z, rho_);
    double const T = 1 / s.e;
    return Jet{T, -T * T * s.ee, T * T * (2 * T * s.ee * s.ee - s.eee)};
  };
  auto const z = solve_increasing(jet, T, z_min_, z_max_, 1.5 * table_->R * T);
  if (!z)
    refuse("temperature", T);
  return e_0_ + *z;
}

double TabulatedIsochore::temperature_from_entropy(double s, double T_guess) const {
  auto const jet = [this](double z) {
    auto const at = table_->at(e_0_ + z, rho_);
    return Jet{at.s, at.e, at.ee};
  };
  auto const z = solve_increasing(jet, s, z_min_, z_max_, 1.5 * table_->R * T_guess);
  if (!z)
    refuse("entropy", s);
  return 1 / table_->at(e_0_ + *z, rho_).e;
}

double TabulatedIsochore::pressure(double T) const {
  auto const s = jet(T);
  return -rho_ * rho_ * s.rho / s.e;
}
double TabulatedIsochore::heat_capacity(double T) const {
  auto const s = jet(T);
  return -s.e * s.e / s.ee;
}
double TabulatedIsochore::heat_capacity_slope(double T) const {
  auto const s = jet(T);
  double const C = -s.e * s.e / s.ee;
  return C * (s.e * s.e * s.eee / (s.ee * s.ee) - 2 * s.e);
}
double TabulatedIsochore::pressure_slope(double T) const {
  auto const s = jet(T);
  double const P_e = -rho_ * rho_ * (s.e_rho - s.rho * s.ee / s.e) / s.e;
  return -s.e * s.e / s.ee * P_e;
}
double TabulatedIsochore::pressure_density_slope(double T) const {
  auto const s = jet(T);
  double const P_e = -rho_ * rho_ * (s.e_rho - s.rho * s.ee / s.e) / s.e;
  double const P_rho = -(2 * rho_ * s.rho + rho_ * rho_ * (s.rho_rho - s.rho * s.e_rho / s.e)) / s.e;
  return P_rho - P_e * s.e_rho / s.ee;
}

void Tabulated::require_temperature(double T, double rho) const {
  if (!(T >= table_->T_min && T <= table_->T_max))
    throw PhysicsError(fmt::format("table at density {}: temperature {} is outside {} <= T <= {}", rho, T,
                                   table_->T_min, table_->T_max));
}

Domain Tabulated::domain() const {
  return {.rho_min = table_->density.low,
          .rho_max = table_->density.high,
          .T_min = table_->T_min,
          .T_max = table_->T_max,
          .edge =
              fmt::format("other states are refused; inside, T and P are those of the model to {:.2g} and "
                          "{:.2g}, c_v to {:.2g}",
                          accuracy().T, accuracy().P, accuracy().C)};
}

namespace {

/// Axis::place for a register full of numbers on the axis.
struct Places {
  std::int64_t cell[Pack::size];
  Pack t;
};

Places place(quintic::Axis const& axis, double per_width, Pack x) {
  Places places;
  Pack const c = (x - axis.low) * per_width;
  auto cell = __builtin_convertvector(c.v, Pack::Integers);
  auto const last = cell - cell + (axis.cells - 1);
  cell = cell < last ? cell : last;
  places.t = c - Pack(__builtin_convertvector(cell, Pack::Vector));
  __builtin_memcpy(places.cell, &cell, sizeof cell);
  return places;
}

/// One number for each state: from[at[lane] + k].
Pack gather(double const* from, std::int64_t const* at, int k) {
  Pack p;
  for (int lane = 0; lane < Pack::size; ++lane)
    p.v[lane] = from[at[lane] + k];
  return p;
}

/// One row for each state (the rest stays zero). Transposed, the j-th holds the j-th number of every state.
using Rows = std::array<Row, quintic::lanes>;
static_assert(Pack::size <= quintic::lanes && quintic::lanes == 8);

/// Exchanges, in turn, the blocks of 4, of 2 and of 1 that lie on the wrong side of the diagonal.
void transpose(Rows& r) {
  for (int k : {0, 1, 2, 3}) {
    Row const a = r[k], b = r[k + 4];
    r[k] = __builtin_shufflevector(a, b, 0, 1, 2, 3, 8, 9, 10, 11);
    r[k + 4] = __builtin_shufflevector(a, b, 4, 5, 6, 7, 12, 13, 14, 15);
  }
  for (int k : {0, 1, 4, 5}) {
    Row const a = r[k], b = r[k + 2];
    r[k] = __builtin_shufflevector(a, b, 0, 1, 8, 9, 4, 5, 12, 13);
    r[k + 2] = __builtin_shufflevector(a, b, 2, 3, 10, 11, 6, 7, 14, 15);
  }
  for (int k : {0, 2, 4, 6}) {
    Row const a = r[k], b = r[k + 1];
    r[k] = __builtin_shufflevector(a, b, 0, 8, 2, 10, 4, 12, 6, 14);
    r[k + 1] = __builtin_shufflevector(a, b, 1, 9, 3, 11, 5, 13, 7, 15);
  }
}

/// sum_j w[j] (the j-th number of each state's row), of transposed rows.
Pack dot(std::array<Pack, order> const& w, Rows const& rows) {
  Pack sum = 0.0, numbers;
  for (int j = 0; j < order; ++j) {
    __builtin_memcpy(&numbers.v, &rows[j], sizeof numbers.v);
    sum += w[j] * numbers;
  }
  return sum;
}

/// What all batches of one table share.
struct Scales {
  double per_x, per_y, per_e;
};

/// A register full of states on its way. The functions below are applied to several batches in turn, so that
/// the processor overlaps the long chain of each with those of the others.
struct Batch {
  Pack e, rho;
  Places i, j; // cells in density and y
  std::array<Pack, order> x0, x1;
  Pack slope, z, y; // de_0/drho, e - e_0
  Rows v0, v1;      // sums over the density of S, dS/dx
  bool inside;
};

/// The height z of the energy above e_0(rho), and the cell in density.
void locate(EntropyTable const& table, Scales const& scale, Batch& b) {
  b.inside = all_within(b.rho, table.density.low, table.density.high);
  if (!b.inside)
    b.rho = table.density.low; // any that exists: the batch is refused
  b.i = place(table.density, scale.per_x, b.rho);
  b.x0 = quintic::weights_of<0>(b.i.t), b.x1 = quintic::weights_of<1>(b.i.t);
  Pack base = 0.0, slope = 0.0;
  for (int k = 0; k < order; ++k) {
    Pack const coefficient = gather(table.e_0.data(), b.i.cell, k);
    base += b.x0[k] * coefficient;
    slope += b.x1[k] * coefficient;
  }
  b.z = b.e - base;
  b.slope = slope * scale.per_x;
}

/// Its logarithm y, and the cell in y.
void take_logarithm(EntropyTable const& table, Scales const& scale, Batch& b) {
  b.inside =
      b.inside && all_within(b.z, std::numeric_limits<double>::min(), std::numeric_limits<double>::max());
  b.y = log(b.z * scale.per_e);
  b.inside = b.inside && all_within(b.y, table.y.low, table.y.high);
  if (!b.inside)
    b.y = table.y.low;
  b.j = place(table.y, scale.per_y, b.y);
}

/// The splines in y of each state, combined over the density.
void combine_rows(EntropyTable const& table, Batch& b) {
  b.v0 = {}, b.v1 = {};
  for (int lane = 0; lane < Pack::size; ++lane) {
    double const* const corner = &table.S[static_cast<std::size_t>(b.i.cell[lane]) * table.stride +
                                          static_cast<std::size_t>(b.j.cell[lane])];
    Row sum_0{}, sum_1{};
    for (int k = 0; k < order; ++k) {
      Row const r = row(corner + static_cast<std::size_t>(k) * table.stride);
      sum_0 += b.x0[k].v[lane] * r;
      sum_1 += b.x1[k].v[lane] * r;
    }
    b.v0[lane] = sum_0, b.v1[lane] = sum_1;
  }
  transpose(b.v0), transpose(b.v1);
}

struct Response {
  Pack T, P, C;
};

Response respond(EntropyTable const& table, Scales const& scale, Batch const& b) {
  Pack const S_y = dot(quintic::weights_of<1>(b.j.t), b.v0) * scale.per_y;
  Pack const S_yy = dot(quintic::weights_of<2>(b.j.t), b.v0) * (scale.per_y * scale.per_y);
  Pack const S_x = dot(quintic::weights_of<0>(b.j.t), b.v1) * scale.per_x;
  Pack const slower = S_y - S_yy, inverse = 1.0 / (S_y * slower); // one division for T and C
  Pack const T = b.z * slower * inverse;
  return {T, b.rho * (T * (table.R - b.rho * S_x) + b.rho * b.slope), S_y * S_y * S_y * inverse};
}

constexpr std::size_t batches = 8, block_size = batches * Pack::size;

/// At most block_size states, from the index `first` on.
void evaluate_block(EntropyTable const& table, Scales const& scale, EnergyStates const& in,
                    ThermalResponse const& out, std::size_t first) {
  std::size_t const count = std::min(block_size, in.e.size() - first);
  double e[block_size], rho[block_size], T[block_size], P[block_size], C[block_size];
  for (std::size_t k = 0; k < block_size; ++k) { // filled up with copies of the first
    std::size_t const from = first + (k < count ? k : 0);
    e[k] = in.e[from], rho[k] = in.rho[from];
  }
  std::array<Batch, batches> block;
  for (std::size_t b = 0; b < batches; ++b)
    block[b].e = Pack::load(e + b * Pack::size), block[b].rho = Pack::load(rho + b * Pack::size);
  for (auto& batch : block)
    locate(table, scale, batch);
  for (auto& batch : block)
    take_logarithm(table, scale, batch);
  for (auto& batch : block)
    combine_rows(table, batch);
  for (std::size_t b = 0; b < batches; ++b) {
    auto const response = respond(table, scale, block[b]);
    response.T.store(T + b * Pack::size);
    response.P.store(P + b * Pack::size);
    response.C.store(C + b * Pack::size);
    if (!block[b].inside)
      for (std::size_t k = b * Pack::size; k < (b + 1) * Pack::size; ++k)
        table.at(e[k], rho[k]); // names the state that is outside
  }
  std::copy_n(T, count, &out.T[first]);
  std::copy_n(P, count, &out.P[first]);
  std::copy_n(C, count, &out.C[first]);
}

} // namespace

void evaluate(Tabulated const& eos, EnergyStates const& in, ThermalResponse const& out) {
  auto const& table = eos.table();
  Scales const scale{1 / table.density.width(), 1 / table.y.width(), 1 / table.e_1};
  for (std::size_t first = 0; first < in.e.size(); first += block_size)
    evaluate_block(table, scale, in, out, first);
}

} // namespace mesobridge::fitting
