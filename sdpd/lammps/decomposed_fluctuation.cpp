#include "sdpd/fluctuation/ser_change.hpp"
#include "sdpd/lammps/decomposed_fluid.hpp"
#include "sdpd/lammps/pair_noise.hpp"

// Friction and noise of a rank's particles: all pairs at once, explicitly (sdpd/README.md, Eq. (S25)).

namespace mesobridge::sdpd {
namespace {

TravellingRows vectors_of(std::vector<Row>& rows) {
  return {.rows = reinterpret_cast<double*>(rows.data()), .stride = 4, .width = 3};
}

/// What the step begins from: rows of `stride` numbers for each particle, of which `width` travel to ghosts.
/// DPD: velocity. DPDE: velocity and temperature. SDPD: these, 1/C and 1/rho.
template <class Law>
struct StartRows {
  static constexpr bool has_densities = std::is_same_v<Law, SdpdLaw>;
  static constexpr int stride = has_densities ? 8 : 4, width = has_densities ? 6 : Law::has_energies ? 4 : 3;
};

/// Eight particles of them.
template <class Law>
struct StartLanes {
  VectorLanes<Lanes> v;
  Lanes T{}, inverse_C{}, inverse_rho{};

  using Rows = StartRows<Law>;
  using Columns = std::array<Lanes, Rows::stride>;

  [[gnu::always_inline]] explicit StartLanes(Columns const& all) : v{all[0], all[1], all[2]}, T(all[3]) {
    if constexpr (Rows::has_densities)
      inverse_C = all[4], inverse_rho = all[5];
  }
  [[gnu::always_inline]] static StartLanes of(double const* rows, std::uint32_t const* who) {
    auto const row = [&](std::size_t l) { return rows + std::size_t{who[l]} * Rows::stride; };
    if constexpr (Rows::has_densities)
      return StartLanes(load_lines(row));
    else
      return StartLanes(load_rows(row));
  }
  /// Of first particles, which often are one.
  [[gnu::always_inline]] static StartLanes of_first(double const* rows, std::uint32_t const* who) {
    if (!are_one(who))
      return of(rows, who);
    Columns columns;
    for (std::size_t c = 0; c < columns.size(); ++c)
      columns[c] = broadcast(rows[std::size_t{who[0]} * Rows::stride + c]);
    return StartLanes(columns);
  }
};

template <class Law>
[[gnu::always_inline]] inline Bath<Lanes> bath_of(Law const& law, StartLanes<Law> const& a,
                                                  StartLanes<Law> const& b) {
  if constexpr (Law::has_energies)
    return law.template bath<Lanes>({a.T, b.T, a.inverse_C, b.inverse_C});
  else
    return law.template bath<Lanes>();
}

} // namespace

/// Calls f(pairs, change) for the pairs in range, eight at a time, with what the first particle of each
/// gains.
template <class Law, class F>
void DecomposedFluid::for_each_change(Law const& law, RankParticles const& particles, std::uint64_t step,
                                      F const& f) const {
  NoiseLanes const source(NoiseSource(seed_, fluctuation_noise.first, step));
  double const time = fluctuate_every_ * dt_;
  double const* const start = start_.data();
  with_weights(parts_.kernel, law, [&](auto const& weights) {
    pairs_.for_each_sixteen([&](std::uint32_t const* i, std::uint32_t const* j, std::size_t count) {
      PairNoiseLanes const noise(source, particles, i, j, Law::noise);
      for (std::size_t from = 0; from < count; from += lane_count) {
        EightPairs const at(rows_.data(), i + from, j + from, count - from);
        auto const a = StartLanes<Law>::of_first(start, at.i), b = StartLanes<Law>::of(start, at.j);
        VectorLanes<Lanes> const v{a.v.x - b.v.x, a.v.y - b.v.y, a.v.z - b.v.z};
        auto const weight = not_negative(weights(at.r, at.inverse_r, a.inverse_rho, b.inverse_rho));
        InputLanes<Law::across, Lanes> const input(
            weight, {at.x * at.inverse_r, at.y * at.inverse_r, at.z * at.inverse_r}, noise.half(from));
        f(at, ser_change(law, bath_of(law, a, b), input, v, time));
      }
    });
  });
}

void DecomposedFluid::fluctuate(RankParticles const& particles, GhostExchange& ghosts, std::uint64_t step) {
  if (step % fluctuate_every_ != fluctuate_every_ - 1)
    return;
  std::visit(
      [&](auto const& law) {
        if (blocks_)
          step_in_turn(law, particles, ghosts, step);
        else
          fluctuate(law, particles, ghosts, step);
      },
      parts_.law);
  if (!has_energies())
    return;
  add_heat(particles, step);
  if (!has_densities())
    return;
  add_pressure_forces(particles, ghosts);
  ghosts.reverse(vectors_of(sums_));
  for (std::size_t i = 0; i < particles.owned; ++i)
    for (std::size_t c = 0; c < 3; ++c)
      particles.f[3 * i + c] = sums_[i][c];
}

template <class Law>
void DecomposedFluid::start(RankParticles const& particles, GhostExchange& ghosts) {
  using Rows = StartRows<Law>;
  start_.resize(Rows::stride * particles.all);
  for (std::size_t i = 0; i < particles.owned; ++i) {
    double* const row = &start_[Rows::stride * i];
    std::copy_n(particles.v + 3 * i, 3, row);
    if constexpr (Law::has_energies)
      row[3] = own_.T[i];
    if constexpr (Rows::has_densities)
      row[4] = own_.caloric[i].inverse_C_0, row[5] = 1 / own_.rho[i];
  }
  ghosts.forward({start_.data(), Rows::stride, Rows::width});
}

template <class Law>
void DecomposedFluid::fluctuate(Law const& law, RankParticles const& particles, GhostExchange& ghosts,
                                std::uint64_t step) {
  start<Law>(particles, ghosts);
  sums_.assign(particles.all, Row{});
  changes_.clear();
  for_each_change(law, particles, step, [&](EightPairs const& at, VectorLanes<Lanes> const& change) {
    add_opposite(sums_, at, change.x, change.y, change.z);
    if constexpr (Law::has_energies)
      changes_.push_back(change);
  });
  ghosts.reverse(vectors_of(sums_));
  for (std::size_t i = 0; i < particles.owned; ++i)
    for (std::size_t c = 0; c < 3; ++c)
      particles.v[3 * i + c] += sums_[i][c];
  if constexpr (Law::has_energies) {
    ghosts.forward(vectors_of(sums_));
    find_heat<Law>(particles.all, ghosts);
  }
}

/// By the impulses that all pairs together give, of ghosts, too.
template <class Law>
void DecomposedFluid::find_heat(std::size_t all, GhostExchange& ghosts) {
  mean_.resize(all);
  for (std::size_t i = 0; i < all; ++i) {
    double const* const v = &start_[StartRows<Law>::stride * i];
    mean_[i] = Row{v[0], v[1], v[2], 0} + 0.5 * sums_[i];
  }
  heat_.assign(all, 0);
  auto change = changes_.begin();
  for_each_eight(pairs_, mean_, [&](EightPairs const& at) {
    add_to_both(heat_, at, ser_heat(*change++, VectorLanes<Lanes>{at.x, at.y, at.z}));
  });
  ghosts.reverse({heat_.data(), 1, 1});
}

/// One pair after the other.
template <class Law>
void DecomposedFluid::step_in_turn(Law const& law, RankParticles const& particles, GhostExchange& ghosts,
                                   std::uint64_t step) {
  Failure failure;
  auto const& rows = blocks_->run(law,
                                  {.parts = parts_,
                                   .particles = particles,
                                   .own = own_,
                                   .ghosts = ghosts,
                                   .seed = seed_,
                                   .step = step,
                                   .time = fluctuate_every_ * dt_,
                                   .scheme = scheme_,
                                   .counts = counts_},
                                  failure);
  stop_at(failure, step);
  heat_.resize(particles.owned);
  for (std::size_t i = 0; i < particles.owned; ++i) {
    for (std::size_t c = 0; c < 3; ++c)
      particles.v[3 * i + c] = rows[i][c];
    heat_[i] = rows[i][3];
  }
}

/// The energies, and the temperatures that belong to them, which are looked for from those of the expansions.
void DecomposedFluid::add_heat(RankParticles const& particles, std::uint64_t step) {
  Failure failure;
  for (std::size_t i = 0; i < particles.owned; ++i)
    if (!blocks_) {
      gain_of_ser(own_, i, heat_[i], failure);
    } else {
      own_.eps[i] += heat_[i];
      if (double const T = own_.caloric[i].T(heat_[i]); T > 0 && own_.caloric[i].in_reach(heat_[i]))
        own_.T[i] = T;
    }
  stop_at(failure, step);
  renew_thermodynamics(particles.owned, Given::energies, step);
}

} // namespace mesobridge::sdpd
