#include "sdpd/lammps/block_sweep.hpp"
#include "sdpd/fluctuation/metropolis_lanes.hpp"
#include "sdpd/lammps/pair_noise.hpp"
#include <algorithm>
#include <bit>
#include <fmt/format.h>
#include <ranges>

namespace mesobridge::sdpd {
namespace {

Vec3 lane(VectorLanes<Lanes> const& of, std::size_t l) {
  return {of.x[l], of.y[l], of.z[l]};
}

SweepNoise noise_of(BlockSweep::Inputs const& in) {
  return {in.seed, in.step, fluctuation_noise.first, acceptance_noise.first};
}

} // namespace

/// What a sweep leaves as it is, and the state that it begins from; owners tell their ghosts.
template <class Law>
void BlockSweep::begin(Inputs const& in) {
  auto const owned = in.particles.owned, all = in.particles.all;
  state_.assign(all, Row{}), fixed_.assign(fixed_stride * all, 1);
  for (std::size_t i = 0; i < owned; ++i) {
    double const* const v = in.particles.v + 3 * i;
    state_[i] = Row{v[0], v[1], v[2], 0};
    double* const fixed = &fixed_[fixed_stride * i];
    fixed[cell] = number(cell_of(in.particles.q + 3 * i));
    if constexpr (Law::has_energies) {
      auto const& caloric = in.own.caloric[i];
      fixed[T_0] = caloric.T_0, fixed[inverse_C_0] = caloric.inverse_C_0;
      fixed[curvature] = caloric.curvature, fixed[limit] = caloric.limit;
      fixed[density] = in.own.rho.empty() ? 1 : in.own.rho[i], fixed[energy] = in.own.eps[i];
    }
  }
  in.ghosts.forward({fixed_.data(), fixed_stride, Law::has_energies ? int{fixed_width} : 1});
  if constexpr (Law::has_energies) {
    seen_.T.resize(all), seen_.rho.resize(all), seen_.eps.resize(all);
    for (std::size_t i = 0; i < all; ++i) {
      double const* const fixed = &fixed_[fixed_stride * i];
      seen_.T[i] = fixed[T_0], seen_.rho[i] = fixed[density], seen_.eps[i] = fixed[energy];
    }
  }
}

template <class Law>
void BlockSweep::draw_noise(Law const&, Inputs const& in) {
  NoiseLanes const source(NoiseSource(in.seed, fluctuation_noise.first, in.step));
  for (auto& of_axis : noise_)
    of_axis.resize(ordered_.size() + 2 * wide_count);
  bits_.resize(ordered_.size() + 2 * wide_count);
  std::array<std::uint32_t, wide_count> i{}, j{};
  for (std::size_t first = 0; first < ordered_.size(); first += wide_count) {
    for (std::size_t l = 0; l < wide_count && first + l < ordered_.size(); ++l)
      i[l] = block_[ordered_[first + l].i].place, j[l] = block_[ordered_[first + l].j].place;
    PairNoiseLanes const G(source, in.particles, i.data(), j.data(), Law::noise);
    store(G.x, &noise_[0][first]), store(G.y, &noise_[1][first]), store(G.z, &noise_[2][first]);
    store(G.bits, &bits_[first]);
  }
}

/// Where a particle's expansion does not reach, temperatures are found exactly, so that they depend on its
/// state alone. What has none is reported.
BlockSweep::ThermalLanes BlockSweep::thermal(Inputs const& in, ParticleLanes const& of,
                                             std::uint32_t const* who, Failure& failure) const {
  ThermalLanes found{of.caloric.T(of.u), of.caloric.inverse_C(of.u)};
  auto const report = [&](std::size_t l, std::string_view why) {
    auto const& member = block_[who[l]];
    failure.report(member.id,
                   fmt::format("what it exchanged with its neighbours took its internal energy to {:.6g} "
                               "(in K k_B T): {}; take a shorter time step or larger particles",
                               fixed_[fixed_stride * member.place + energy] + of.u[l], why));
    found.T[l] = 1;
  };
  for (unsigned out = ~of.caloric.in_reach(found.T) & 0xffu; out != 0; out &= out - 1) {
    auto const l = static_cast<std::size_t>(std::countr_zero(out));
    auto const place = block_[who[l]].place;
    try {
      auto const exact =
          in.parts.thermodynamics->state(seen_, place, fixed_[fixed_stride * place + energy] + of.u[l]);
      found.T[l] = exact.T, found.inverse_C[l] = exact.inverse_C;
    } catch (PhysicsError const& error) {
      report(l, error.what());
    }
  }
  for (unsigned cold = ~less(Lanes{}, found.T) & 0xffu; cold != 0; cold &= cold - 1)
    report(static_cast<std::size_t>(std::countr_zero(cold)), "its temperature is not positive there");
  return found;
}

template <class Law>
Bath<Lanes> BlockSweep::bath_of(Law const& law, Inputs const& in, ParticleLanes const& a,
                                ParticleLanes const& b, EightPairs const& at, Failure& failure) const {
  if constexpr (Law::has_energies) {
    ThermalLanes const of_a = thermal(in, a, at.i, failure), of_b = thermal(in, b, at.j, failure);
    return law.template bath<Lanes>({of_a.T, of_b.T, of_a.inverse_C, of_b.inverse_C});
  } else {
    return law.template bath<Lanes>();
  }
}

template <class Law>
unsigned BlockSweep::judge(Law const& law, Inputs const& in, Proposed<Law> const& of, Failure& failure) {
  unsigned const present = (1u << of.at.count) - 1;
  in.counts.proposed += of.at.count;
  if constexpr (!Law::has_energies) {
    return present;
  } else {
    if (in.scheme == PairScheme::ssa)
      return present;
    Lanes const T_a = of.a.caloric.T(of.a.u + of.heat), T_b = of.b.caloric.T(of.b.u + of.heat), zero{};
    unsigned const reach = of.a.caloric.in_reach(T_a) & of.b.caloric.in_reach(T_b) &
                           of.a.caloric.in_reach(of.a.caloric.T(of.a.u)) &
                           of.b.caloric.in_reach(of.b.caloric.T(of.b.u));
    unsigned const in_domain = less(zero, T_a) & less(zero, T_b);
    in.counts.out_of_domain += static_cast<unsigned>(std::popcount(present & reach & ~in_domain));
    unsigned made = present & reach & in_domain;
    if (in.scheme == PairScheme::ems)
      made = pass_metropolis(law, in, of, made);
    for (unsigned far = present & ~reach; far != 0; far &= far - 1)
      step_exactly(law, in, of, static_cast<std::size_t>(std::countr_zero(far)), failure);
    return made;
  }
}

/// Those of the proposed steps that pass the test of EMS (S24).
template <class Law>
unsigned BlockSweep::pass_metropolis(Law const& law, Inputs const& in, Proposed<Law> const& of,
                                     unsigned made) const {
  auto const& [a, b] = std::tie(of.a.caloric, of.b.caloric);
  Lanes const u_a = of.a.u + of.heat, u_b = of.b.u + of.heat;
  Lanes const T_a = a.T(of.a.u), T_b = b.T(of.b.u), T_a1 = a.T(u_a), T_b1 = b.T(u_b);
  auto const back = step_in(law.template bath<Lanes>({T_a1, T_b1, a.inverse_C(u_a), b.inverse_C(u_b)}), law,
                            of.input.weight, in.time);
  auto const noise =
      noise_terms<Lanes>({of.step.par.variance, of.step.perp.variance}, back, of.input, of.v, of.dv);
  auto const measure = pair_change(a, b, T_a, T_b, T_a1, T_b1);
  Lanes exponent = 0.5 * (logarithm(noise.widths) + noise.squares) + measure.entropy / law.boltzmann;
  if constexpr (Law::measure_over_T)
    exponent -= measure.log_T;
  auto const source = noise_of(in);
  for (unsigned left = made; left != 0; left &= left - 1) {
    auto const l = static_cast<std::size_t>(std::countr_zero(left));
    double const uniform = source.uniform(block_[of.at.i[l]].id, block_[of.at.j[l]].id, bits_[of.first + l]);
    if (!(uniform < std::exp(exponent[l])))
      made &= ~(1u << l), ++in.counts.metropolis;
  }
  return made;
}

template <class Law>
void BlockSweep::step_exactly(Law const& law, Inputs const& in, Proposed<Law> const& of, std::size_t l,
                              Failure& failure) {
  auto const i = of.at.i[l], j = of.at.j[l];
  Sweep<Law> const sweep{law, in.time, noise_of(in)};
  Vec3 const e = lane(of.input.e, l);
  // Along the line of centres alone the noise is one number.
  Vec3 const G = Law::across == Transverse::none ? of.input.G_along[l] * e : lane(of.input.G, l);
  try {
    PairStates const states(*in.parts.thermodynamics, seen_, {&states_[i], &states_[j]},
                            {block_[i].place, block_[j].place});
    ExactPair<Law>(states, law.boltzmann)
        .step(in.scheme, {e, {of.input.weight.par[l], of.input.weight.perp[l]}},
              {G, sweep.noise.uniform(block_[i].id, block_[j].id, bits_[of.first + l])}, sweep, in.counts);
  } catch (PhysicsError const& error) {
    failure.report(std::min(block_[i].id, block_[j].id), error.what());
  }
}

/// Eq. (S22), (S23), one matching after the other.
template <class Law>
void BlockSweep::step_pairs(Law const& law, Inputs const& in, Failure& failure) {
  auto const n = static_cast<std::uint32_t>(block_.size());
  with_weights(in.parts.kernel, law, [&](auto const& weights) {
    std::size_t begin = 0;
    for (std::size_t const end : ends_)
      for (; begin < end; begin += std::min(lane_count, end - begin)) {
        std::size_t const count = std::min(lane_count, end - begin);
        std::array<std::uint32_t, lane_count> i, j;
        for (std::size_t l = 0; l < lane_count; ++l)
          i[l] = l < count ? ordered_[begin + l].i : n, j[l] = l < count ? ordered_[begin + l].j : n + 1;
        ParticleLanes const a(load_lines([&](std::size_t l) { return &states_[i[l]]; }));
        ParticleLanes const b(load_lines([&](std::size_t l) { return &states_[j[l]]; }));
        EightPairs const at(rows_.data(), i.data(), j.data(), count);
        auto const G = [&](std::size_t axis) { return to_double(load<FloatLanes>(&noise_[axis][begin])); };
        auto const weight = not_negative(weights(at.r, at.inverse_r, at.of_i, at.of_j));
        InputLanes<Law::across, Lanes> const input(
            weight, {at.x * at.inverse_r, at.y * at.inverse_r, at.z * at.inverse_r}, {G(0), G(1), G(2)});
        VectorLanes<Lanes> const v{a.p_x - b.p_x, a.p_y - b.p_y, a.p_z - b.p_z};
        auto const bath = bath_of(law, in, a, b, at, failure);
        auto const step = step_in(bath, law, weight, in.time);
        auto const dv = velocity_change(step, input, v);
        Lanes const heat =
            -0.125 * dot(dv, VectorLanes<Lanes>{2.0 * v.x + dv.x, 2.0 * v.y + dv.y, 2.0 * v.z + dv.z});
        auto const changes = to_rows({0.5 * dv.x, 0.5 * dv.y, 0.5 * dv.z, heat});
        for (unsigned made = judge<Law>(law, in, {begin, a, b, at, input, step, v, dv, heat}, failure);
             made != 0; made &= made - 1) {
          auto const l = static_cast<std::size_t>(std::countr_zero(made));
          Vec3 const dp{changes[l][0], changes[l][1], changes[l][2]};
          states_[i[l]].p += dp, states_[j[l]].p -= dp;
          states_[i[l]].u += changes[l][3], states_[j[l]].u += changes[l][3];
        }
      }
  });
  for (std::size_t k = 0; k < n; ++k) {
    auto const& of = states_[k];
    state_[block_[k].place] = Row{of.p.x, of.p.y, of.p.z, of.u};
  }
}

template <class Law>
void BlockSweep::step_blocks(Law const& law, Inputs const& in, Failure& failure) {
  finish_blocks();
  draw_noise(law, in);
  step_pairs(law, in, failure);
  block_.clear(), rows_.clear(), states_.clear(), pairs_.clear();
}

template <class Law>
std::vector<Row> const& BlockSweep::run(Law const& law, Inputs const& in, Failure& failure) {
  begin<Law>(in);
  sort_into_cells(in.particles);
  auto const blocks = own_blocks(in.particles);
  auto const owned = in.particles.owned;
  constexpr int width = Law::has_energies ? 4 : 3;
  constexpr std::size_t enough = 500; // particles: their copies stay in the cache
  auto rows = [](std::vector<Row>& of) {
    return TravellingRows{reinterpret_cast<double*>(of.data()), 4, width};
  };
  for (unsigned phase = 0; phase < 8; ++phase) {
    in.ghosts.forward(rows(state_));
    before_.assign(state_.begin() + static_cast<std::ptrdiff_t>(owned), state_.end());
    auto const turn = [&](unsigned axis) {
      return std::views::filter(blocks[axis],
                                [=](std::uint32_t k) { return (k & 1u) == (phase >> axis & 1u); });
    };
    for (auto const z : turn(2))
      for (auto const y : turn(1))
        for (auto const x : turn(0)) {
          add_block(in.particles, {x, y, z});
          if (block_.size() > enough)
            step_blocks(law, in, failure);
        }
    step_blocks(law, in, failure);
    for (std::size_t i = owned; i < in.particles.all; ++i)
      state_[i] -= before_[i - owned];
    in.ghosts.reverse(rows(state_));
  }
  return state_;
}

template std::vector<Row> const& BlockSweep::run(SdpdLaw const&, Inputs const&, Failure&);
template std::vector<Row> const& BlockSweep::run(DpdeLaw<Transverse::none> const&, Inputs const&, Failure&);
template std::vector<Row> const& BlockSweep::run(DpdeLaw<Transverse::own> const&, Inputs const&, Failure&);
template std::vector<Row> const& BlockSweep::run(DpdLaw<Transverse::none> const&, Inputs const&, Failure&);
template std::vector<Row> const& BlockSweep::run(DpdLaw<Transverse::own> const&, Inputs const&, Failure&);

} // namespace mesobridge::sdpd
