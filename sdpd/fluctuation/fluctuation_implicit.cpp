#include "sdpd/fluctuation/fluctuation_implicit.hpp"
#include "sdpd/conservative/conservative.hpp"
#include "sdpd/fluctuation/fluctuation.hpp"
#include "sdpd/fluctuation/frozen_pairs.hpp"
#include "sdpd/fluctuation/pair_scheme.hpp"
#include "sdpd/fluctuation/sweep.hpp"
#include "sdpd/system/selected_pairs.hpp"
#include "sdpd/system/sum_over_particles.hpp"

namespace mesobridge::sdpd {
namespace {

constexpr double tolerance = 1e-4; ///< of the conjugate gradients
constexpr int most_iterations = 200;

template <class Law>
void freeze(System const& system, Law const& law, double dt, NoiseSource const& source, std::size_t number,
            FrozenPairs& frozen) {
  thread_local FluctuatingBlock block;
  thread_local PairInputs inputs;
  auto const pairs = system.neighbours.pairs(number);
  block.copy_in(system, number);
  prepare_pairs(system, law, block, pairs, source, inputs);
  frozen.resize(pairs.size() + wide_count);
  auto const* const particles = block.particles().data();
  FloatLanes const duration = constant<FloatLanes>(dt);
  for_each_group(pairs, block.size(), [&](LocalPair const* pair, std::size_t first, std::size_t) {
    ParticleLanes const a(load_lines([&](std::size_t l) { return &particles[pair[l].i]; }));
    ParticleLanes const b(load_lines([&](std::size_t l) { return &particles[pair[l].j]; }));
    InputLanes<Law::across, FloatLanes> const input(inputs, first);
    auto const bath =
        law.template bath<FloatLanes>({to_float(a.caloric.T_0), to_float(b.caloric.T_0),
                                       to_float(a.caloric.inverse_C_0), to_float(b.caloric.inverse_C_0)});
    auto const [a_par, a_perp] = law.coefficients(input.weight);
    FloatLanes const par = a_par * bath.gamma_over_a * duration;
    FloatLanes const perp =
        Law::across == Transverse::none ? FloatLanes{} : a_perp * bath.gamma_over_a * duration;
    FloatLanes const kick = square_root(bath.thermal * perp), kick_par = square_root(bath.thermal * par);
    auto const &e = input.e, &G = input.G;
    FloatLanes const along = (kick_par - kick) * input.G_along;
    store(e.x, &frozen.e_x[first]), store(e.y, &frozen.e_y[first]), store(e.z, &frozen.e_z[first]);
    store(perp, &frozen.perp[first]), store(par - perp, &frozen.extra[first]);
    store(kick * G.x + along * e.x, &frozen.n_x[first]);
    store(kick * G.y + along * e.y, &frozen.n_y[first]);
    store(kick * G.z + along * e.z, &frozen.n_z[first]);
  });
  if (!system.particles.mass.empty())
    for (std::size_t k = 0; k < pairs.size(); ++k)
      frozen.scale(k, block.masses_of_pair(pairs[k]));
}

/// One implicit step; what it needs is kept from step to step by the caller.
class ImplicitStep {
 public:
  ImplicitStep(System& system, std::vector<FrozenPairs>& frozen) : system_(system), frozen_(frozen) {
    frozen_.resize(system.neighbours.grid().blocks().size());
  }

  template <class Law>
  void make(Law const& law, double dt, bool second) {
    auto const source = SweepNoise::of_fluctuation(system_, second);
    system_.energy_gain.assign(system_.size(), 0);
    for_each_block(system_.neighbours.grid(), system_.threads,
                   [&](std::size_t block) { freeze(system_, law, dt, source.pairs, block, frozen_[block]); });
    find_middle();
    taken_back_.assign(system_.size(), 0);
    do
      find_impulses_and_heat();
    while (take_back_what_leaves());
    apply();
    if (any_taken_back_)
      make_one_after_the_other(dt, second);
  }

 private:
  using Vectors = std::vector<Vec3>;

  template <class F>
  void for_each_particle(F const& f) const {
    for_each_range(system_, [&](Range range) {
      for (std::size_t i = range.begin; i < range.end; ++i)
        f(i);
    });
  }

  /// sums_i = sum_j of what impulse(frozen, first, v) gives to the first particle of each pair, v = x_i -
  /// x_j.
  template <class F>
  void sum_impulses(Vectors const& x, Vectors& sums, F const& impulse) const {
    sums.assign(system_.size(), {});
    for_each_block(system_.neighbours.grid(), system_.threads, [&](std::size_t number) {
      thread_local std::vector<Row> rows, totals;
      auto const members = system_.neighbours.members(number);
      std::size_t const n = size(members);
      copy_vectors(members, x, rows);
      totals.assign(n + 2, Row{});
      for_each_group(system_.neighbours.pairs(number), n,
                     [&](LocalPair const* pair, std::size_t first, std::size_t count) {
                       auto const dp = to_rows(impulses(rows, pair, number, first, impulse));
                       for (std::size_t l = 0; l < count; ++l) {
                         totals[pair[l].i] += dp[l];
                         totals[pair[l].j] -= dp[l];
                       }
                     });
      for_each_member(members, [&](std::size_t local, Index i, Vec3 const&) {
        sums[i] += Vec3{totals[local][0], totals[local][1], totals[local][2]};
      });
    });
  }

  static void copy_vectors(BlockMembers const& members, Vectors const& x, std::vector<Row>& rows) {
    rows.assign(size(members) + 2, Row{});
    for_each_member(members, [&](std::size_t local, Index i, Vec3 const&) {
      rows[local] = Row{x[i].x, x[i].y, x[i].z, 0};
    });
  }

  template <class F>
  [[gnu::always_inline]] RowLanes impulses(std::vector<Row> const& rows, LocalPair const* pair,
                                           std::size_t block, std::size_t first, F const& impulse) const {
    RowLanes const a = load_rows([&](std::size_t l) { return &rows[pair[l].i]; });
    RowLanes const b = load_rows([&](std::size_t l) { return &rows[pair[l].j]; });
    Impulse const dp = impulse(frozen_[block], first,
                               Impulse{to_float(a[0] - b[0]), to_float(a[1] - b[1]), to_float(a[2] - b[2])});
    return {to_double(dp.x), to_double(dp.y), to_double(dp.z), Lanes{}};
  }

  double product(Vectors const& a, Vectors const& b) const {
    return sum_over_particles(system_, [&](std::size_t i) { return dot(a[i], b[i]); });
  }

  double mass(std::size_t i) const { return system_.particles.mass_of(i); }

  /// (M + Gamma dt/2) v
  void apply_matrix(Vectors const& v, Vectors& result) const {
    sum_impulses(v, result, friction);
    for_each_particle([&](std::size_t i) { result[i] = mass(i) * v[i] - 0.5 * result[i]; });
  }

  /// The velocities in the middle of the step, by conjugate gradients.
  void find_middle() {
    Vectors const& p = system_.particles.p;
    Vectors rest, way, image;
    sum_impulses(p, rest,
                 [](FrozenPairs const& of, std::size_t first, Impulse const&) { return noise(of, first); });
    for_each_particle([&](std::size_t i) { rest[i] = p[i] + 0.5 * rest[i]; });
    double const enough = tolerance * tolerance * product(rest, rest);
    middle_.resize(p.size());
    for_each_particle([&](std::size_t i) { middle_[i] = p[i] / mass(i); });
    apply_matrix(middle_, image);
    for_each_particle([&](std::size_t i) { rest[i] -= image[i]; });
    way = rest;
    double square = product(rest, rest);
    for (int k = 0; square > enough; ++k) {
      if (k == most_iterations)
        throw PhysicsError(
            fmt::format("step {} (dt = {:.6g} reduced): the implicit friction was not solved in {} "
                        "iterations; take a shorter time step",
                        system_.step, system_.dt, most_iterations));
      apply_matrix(way, image);
      double const length = square / product(way, image);
      for_each_particle([&](std::size_t i) { middle_[i] += length * way[i], rest[i] -= length * image[i]; });
      double const next = product(rest, rest), share = next / square;
      for_each_particle([&](std::size_t i) { way[i] = rest[i] + share * way[i]; });
      square = next;
    }
  }

  static Impulse both(FrozenPairs const& of, std::size_t first, Impulse const& v) {
    return noise(of, first) + friction(of, first, v);
  }

  void find_impulses_and_heat() {
    sum_impulses(middle_, system_.impulse, both);
    system_.energy_gain.assign(system_.size(), 0);
    for_each_block(system_.neighbours.grid(), system_.threads, [&](std::size_t number) { add_heat(number); });
  }

  void add_heat(std::size_t number) {
    thread_local std::vector<Row> rows;
    thread_local std::vector<Vec3> mean;
    thread_local std::vector<double> heat;
    auto const members = system_.neighbours.members(number);
    std::size_t const n = size(members);
    copy_vectors(members, middle_, rows);
    mean.assign(n + 2, {}), heat.assign(n, 0);
    for_each_member(members, [&](std::size_t local, Index i, Vec3 const&) {
      mean[local] = (system_.particles.p[i] + 0.5 * system_.impulse[i]) / mass(i);
    });
    for_each_group(system_.neighbours.pairs(number), n,
                   [&](LocalPair const* pair, std::size_t first, std::size_t count) {
                     auto const dp = impulses(rows, pair, number, first, both);
                     for (std::size_t l = 0; l < count; ++l) {
                       Vec3 const v = mean[pair[l].i] - mean[pair[l].j];
                       double const given = -0.5 * dot(Vec3{dp[0][l], dp[1][l], dp[2][l]}, v);
                       heat[pair[l].i] += given, heat[pair[l].j] += given;
                     }
                   });
    for_each_member(members,
                    [&](std::size_t local, Index i, Vec3 const&) { system_.energy_gain[i] += heat[local]; });
  }

  bool leaves(std::size_t i) const {
    auto const& particles = system_.particles;
    auto const& caloric = particles.caloric[i];
    double const u = system_.energy_gain[i];
    if (caloric.in_reach(u))
      return !(caloric.T(u) > 0);
    try {
      system_.thermodynamics->state(particles, static_cast<Index>(i), particles.eps[i] + u);
      return false;
    } catch (PhysicsError const&) {
      return true;
    }
  }

  /// Takes back the steps of all pairs of the particles that leave the equation of state; false if there are
  /// none.
  bool take_back_what_leaves() {
    std::atomic<bool> any = false;
    for_each_particle([&](std::size_t i) {
      if (!taken_back_[i] && leaves(i))
        taken_back_[i] = 1, any = true;
    });
    if (!any)
      return false;
    any_taken_back_ = true;
    for_each_block(system_.neighbours.grid(), system_.threads, [&](std::size_t number) {
      auto const members = system_.neighbours.members(number);
      auto const pairs = system_.neighbours.pairs(number);
      for (std::size_t k = 0; k < pairs.size(); ++k)
        if (taken_back_[global_index(members, pairs[k].i)] || taken_back_[global_index(members, pairs[k].j)])
          frozen_[number].take_back(k);
    });
    return true;
  }

  void apply() {
    auto& particles = system_.particles;
    for_each_particle([&](std::size_t i) {
      particles.p[i] += system_.impulse[i];
      particles.eps[i] += system_.energy_gain[i];
      double const T = particles.caloric[i].T(system_.energy_gain[i]);
      particles.T[i] = T > 0 ? T : particles.T[i]; // where the expansion does not reach: a guess
    });
  }

  void make_one_after_the_other(double dt, bool second) {
    thermodynamics_from_energy(system_);
    SelectedPairs const selected(system_, [&](Index i, Index j) { return taken_back_[i] || taken_back_[j]; });
    fluctuate(system_, PairScheme::ams, dt, second);
  }

  System& system_;
  std::vector<FrozenPairs>& frozen_;
  Vectors middle_;
  std::vector<std::uint8_t> taken_back_; ///< particles whose pairs' steps were
  bool any_taken_back_ = false;
};

} // namespace

void fluctuate_implicit(System& system, double dt, bool second) {
  thread_local std::vector<FrozenPairs> frozen;
  std::visit(
      [&]<class Law>(Law const& law) {
        if constexpr (Law::has_energies)
          ImplicitStep(system, frozen).make(law, dt, second);
        else
          throw InputError(
              "scheme ser-implicit: must not be used with particles that have no internal energy");
      },
      system.law);
}

} // namespace mesobridge::sdpd
