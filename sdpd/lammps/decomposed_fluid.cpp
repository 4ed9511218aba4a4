#include "sdpd/lammps/decomposed_fluid.hpp"
#include "sdpd/conservative/pair_forces.hpp"
#include "sdpd/fluctuation/ser_change.hpp"
#include "sdpd/state/random_lanes.hpp"
#include <algorithm>
#include <numeric>

namespace mesobridge::sdpd {
namespace {

MethodParts parts_of(SimulationSettings const& settings) {
  return std::visit([&](auto const& method) { return method.parts(settings); }, settings.method);
}

/// The noise of sixteen pairs, vectors that point from the smaller id to the larger one.
struct PairNoiseLanes {
  WideFloats x, y, z;

  PairNoiseLanes(NoiseLanes const& source, RankParticles const& particles, SixteenPairs const& of,
                 PairNoise kind) {
    WideBits a, b;
    for (std::size_t l = 0; l < wide_count; ++l)
      a[l] = particles.id(of.i[l]), b[l] = particles.id(of.j[l]);
    GaussianLanes const G(source, a < b ? a : b, a < b ? b : a);
    auto const plus = constant<WideFloats>(1);
    WideFloats const sign = kind == PairNoise::along || a < b ? plus : -plus;
    x = sign * G.x, y = sign * G.y, z = sign * G.z;
  }
  VectorLanes<Lanes> half(std::size_t from) const {
    auto of = [&](WideFloats const& all) { return to_double(from == 0 ? low_half(all) : high_half(all)); };
    return {of(x), of(y), of(z)};
  }
};

} // namespace

DecomposedFluid::DecomposedFluid(SimulationSettings const& settings)
    : parts_(parts_of(settings)), range_(settings.range()), skin_(skin_of(settings)), dt_(settings.dt),
      fluctuate_every_(settings.scheme.verlet_steps), seed_(settings.seed), row_(has_energies() ? 4 : 3) {}

void DecomposedFluid::kick(RankParticles const& particles) const {
  for (std::size_t k = 0; k < 3 * particles.owned; ++k)
    particles.v[k] += particles.f[k] * (dt_ / 2);
}

void DecomposedFluid::kick_and_drift(RankParticles const& particles, double* q) const {
  kick(particles);
  for (std::size_t k = 0; k < 3 * particles.owned; ++k)
    q[k] += particles.v[k] * dt_;
}

void DecomposedFluid::stop_at(Failure const& failure, std::uint64_t step) const {
  if (failure.any())
    throw PhysicsError(fmt::format("particle {} at step {} (dt = {:.6g} reduced): {}", failure.id(), step,
                                   dt_, failure.message()));
}

void DecomposedFluid::add_forces(RankParticles const& particles, std::uint64_t step) {
  pairs_.clear();
  for_each_sixteen(particles, range_, [&](SixteenPairs const& group) { pairs_.push_back(group); });
  Failure failure;
  std::visit(
      [&]<class Potential>(Potential const& potential) {
        if constexpr (!std::is_same_v<Potential, NoPotential>)
          for_each_eight(pairs_, [&](EightPairs const& at) {
            for (std::size_t l = 0; l < at.count; ++l)
              if (at.r[l] < potential.inner())
                report_too_near(failure, particles.id(at.i[l]), particles.id(at.j[l]), at.r[l],
                                potential.inner());
            Lanes const zero{}, s = potential(at.r, at.inverse_r).strength;
            Lanes const strength = at.r < broadcast(potential.cutoff()) ? s : zero;
            add_opposite(particles.f, at, strength * at.x, strength * at.y, strength * at.z);
          });
      },
      parts_.potential);
  stop_at(failure, step);
}

/// Calls f(pairs, v, change) for the pairs in range, eight at a time: relative velocities at the start, and
/// what the first particle of each gains.
template <class Law, class F>
void DecomposedFluid::for_each_change(Law const& law, RankParticles const& particles, std::uint64_t step,
                                      F const& f) const {
  NoiseLanes const source(NoiseSource(seed_, fluctuation_noise.first, step));
  double const time = fluctuate_every_ * dt_;
  double const* const start = start_.data();
  std::visit(
      [&](auto const& shape) {
        for (auto const& group : pairs_) {
          PairNoiseLanes const noise(source, particles, group, Law::noise);
          for (std::size_t from = 0; from < group.count; from += lane_count) {
            EightPairs const at(group, from);
            auto of = [&](std::uint32_t const* who, std::size_t column)
                          [[gnu::always_inline]] { return gather_column(start, row_, column, who); };
            VectorLanes<Lanes> const v{of(at.i, 0) - of(at.j, 0), of(at.i, 1) - of(at.j, 1),
                                       of(at.i, 2) - of(at.j, 2)};
            Bath<Lanes> bath;
            if constexpr (Law::has_energies)
              bath = law.template bath<Lanes>(
                  PairTemperatures<Lanes>{of(at.i, 3), of(at.j, 3), Lanes{}, Lanes{}});
            else
              bath = law.template bath<Lanes>();
            InputLanes<Law::across, Lanes> const input(
                shape(at.r), {at.x * at.inverse_r, at.y * at.inverse_r, at.z * at.inverse_r},
                noise.half(from));
            f(at, v, ser_change(law, bath, input, v, time));
          }
        }
      },
      law.shape);
}

void DecomposedFluid::fluctuate(RankParticles const& particles, GhostExchange& ghosts, std::uint64_t step) {
  if (step % fluctuate_every_ != fluctuate_every_ - 1)
    return;
  std::visit(
      [&]<class Law>(Law const& law) {
        if constexpr (!std::is_same_v<Law, SdpdLaw>)
          fluctuate(law, particles, ghosts, step);
      },
      parts_.law);
}

template <class Law>
void DecomposedFluid::fluctuate(Law const& law, RankParticles const& particles, GhostExchange& ghosts,
                                std::uint64_t step) {
  start_.resize(row_ * particles.all);
  for (std::size_t i = 0; i < particles.owned; ++i) {
    std::copy_n(particles.v + 3 * i, 3, &start_[row_ * i]);
    if constexpr (Law::has_energies)
      start_[row_ * i + 3] = carried[i].T;
  }
  ghosts.forward(start_.data(), static_cast<int>(row_));
  impulse_.assign(3 * particles.all, 0);
  for_each_change(law, particles, step,
                  [&](EightPairs const& at, VectorLanes<Lanes> const&, VectorLanes<Lanes> const& change) {
                    add_opposite(impulse_.data(), at, change.x, change.y, change.z);
                  });
  ghosts.reverse(impulse_.data(), 3);
  if constexpr (Law::has_energies) {
    ghosts.forward(impulse_.data(), 3);
    heat_.assign(particles.all, 0);
    auto const of = [&](std::uint32_t i) {
      return Vec3{impulse_[3 * i], impulse_[3 * i + 1], impulse_[3 * i + 2]};
    };
    for_each_change(law, particles, step,
                    [&](EightPairs const& at, VectorLanes<Lanes> const& v, VectorLanes<Lanes> const& change) {
                      for (std::size_t l = 0; l < at.count; ++l) {
                        double const given = ser_heat({change.x[l], change.y[l], change.z[l]},
                                                      {v.x[l], v.y[l], v.z[l]}, of(at.i[l]) - of(at.j[l]));
                        heat_[at.i[l]] += given, heat_[at.j[l]] += given;
                      }
                    });
    ghosts.reverse(heat_.data(), 1);
    add_heat(particles, step);
  }
  for (std::size_t k = 0; k < 3 * particles.owned; ++k)
    particles.v[k] += impulse_[k];
}

/// The energies, and the temperatures that belong to them.
void DecomposedFluid::add_heat(RankParticles const& particles, std::uint64_t step) {
  std::size_t const n = particles.owned;
  own_.resize(n, {.energies = true, .densities = false});
  for (std::size_t i = 0; i < n; ++i)
    own_.id[i] = particles.id(i), own_.eps[i] = carried[i].eps, own_.T[i] = carried[i].T;
  Failure failure;
  parts_.thermodynamics->response(own_, {0, n}, failure);
  for (std::size_t i = 0; i < n; ++i)
    gain_of_ser(own_, i, heat_[i], failure);
  stop_at(failure, step);
  parts_.thermodynamics->from_energy(own_, {0, n}, failure);
  stop_at(failure, step);
  for (std::size_t i = 0; i < n; ++i)
    carried[i] = {own_.eps[i], own_.T[i]};
}

} // namespace mesobridge::sdpd
