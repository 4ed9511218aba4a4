#include "sdpd/step/conduction.hpp"
#include "sdpd/for_each_block.hpp"
#include "sdpd/step/exact_pair.hpp"

namespace mesobridge::sdpd {
namespace {

/// What the sweep needs beside the pairs.
template <class Law>
struct Conduction {
  Law law;
  PairScheme scheme;
  double dt;
  NoiseSource noise, acceptance;
};

/// One block while its pairs exchange heat.
template <class Law>
class BlockConduction {
 public:
  BlockConduction(System& system, FluctuatingBlock& block, Conduction<Law> const& conduction,
                  PairCounts& counts, Failure& failure)
      : system_(system), block_(block), conduction_(conduction), counts_(counts), failure_(failure) {}

  /// False when a particle has left the equation of state.
  bool exchange(LocalPair pair, double weight, double G, std::uint32_t bits) {
    auto const &a = particle(pair.i), &b = particle(pair.j);
    PairTemperatures<double> const at{a.caloric.T(a.u), b.caloric.T(b.u), a.caloric.inverse_C(a.u),
                                      b.caloric.inverse_C(b.u)};
    HeatStep const step = conduction_.law.step(weight, conduction_.dt, at);
    double const heat = step.mean + std::sqrt(step.variance) * G;
    ++counts_.proposed;
    if (conduction_.scheme != PairScheme::ssa && !accept({pair, weight, G, bits, heat}, at, step))
      return true;
    particle(pair.i).u += heat, particle(pair.j).u -= heat;
    return in_reach(pair.i) && in_reach(pair.j);
  }

 private:
  struct Proposal {
    LocalPair pair;
    double weight, G;
    std::uint32_t bits;
    double heat;
  };
  struct Change {
    double T, inverse_C, entropy;
  };

  FluctuatingParticle& particle(std::size_t local) { return block_.particles()[local]; }

  /// Begins a new caloric expansion where the old one does not reach; false when there is no temperature.
  bool in_reach(std::size_t local) {
    auto const& [p, u, caloric] = particle(local);
    return (caloric.in_reach(u) && caloric.T(u) > 0) || block_.renew(system_, local, failure_);
  }

  /// Temperature, heat capacity and change of entropy of a particle with `heat` more than it has; throws
  /// PhysicsError when the equation of state has no such state.
  Change changed(std::size_t local, double heat) {
    auto const& [p, u, caloric] = particle(local);
    double const T = caloric.T(u), T_1 = caloric.T(u + heat);
    if (caloric.in_reach(u + heat) && T_1 > 0)
      return {T_1, caloric.inverse_C(u + heat), caloric.entropy_change(T, T_1)};
    Index const i = block_.index(local);
    double const eps = system_.particles.eps[i] + u;
    auto const before = system_.thermodynamics->state(system_.particles, i, eps),
               after = system_.thermodynamics->state(system_.particles, i, eps + heat);
    return {after.T, after.inverse_C, after.S - before.S};
  }

  bool accept(Proposal const& proposal, PairTemperatures<double> const& at, HeatStep const& step) {
    std::array<Change, 2> change;
    try {
      change = {changed(proposal.pair.i, proposal.heat), changed(proposal.pair.j, -proposal.heat)};
    } catch (PhysicsError const&) {
      ++counts_.out_of_domain;
      return false;
    }
    if (conduction_.scheme != PairScheme::ems || step.variance == 0 ||
        uniform(proposal) < std::exp(log_acceptance(proposal, at, step, change)))
      return true;
    ++counts_.metropolis;
    return false;
  }

  double log_acceptance(Proposal const& proposal, PairTemperatures<double> const& at, HeatStep const& there,
                        std::array<Change, 2> const& change) const {
    HeatStep const back =
        conduction_.law.step(proposal.weight, conduction_.dt,
                             {change[0].T, change[1].T, change[0].inverse_C, change[1].inverse_C});
    double const rest = proposal.heat + back.mean;
    return (change[0].entropy + change[1].entropy) / conduction_.law.boltzmann() +
           Law::log_measure(change[0].T) + Law::log_measure(change[1].T) - Law::log_measure(at.T_i) -
           Law::log_measure(at.T_j) +
           0.5 * (proposal.G * proposal.G - rest * rest / back.variance +
                  std::log(there.variance / back.variance));
  }

  double uniform(Proposal const& proposal) const {
    auto const a = block_.ids()[proposal.pair.i], b = block_.ids()[proposal.pair.j];
    return acceptance_uniform(conduction_.acceptance, std::min(a, b), std::max(a, b), proposal.bits);
  }

  System& system_;
  FluctuatingBlock& block_;
  Conduction<Law> const& conduction_;
  PairCounts& counts_;
  Failure& failure_;
};

template <class Law>
void conduct_block(System& system, std::size_t number, Conduction<Law> const& conduction, PairCounts& counts,
                   Failure& failure) {
  thread_local FluctuatingBlock block;
  thread_local PairInputs inputs;
  auto const pairs = system.neighbours.pairs(number);
  block.copy_in(system, number);
  prepare_pairs(system, conduction.law, block, pairs, conduction.noise, inputs);
  BlockConduction<Law> exchange(system, block, conduction, counts, failure);
  for (std::size_t k = 0; k < pairs.size(); ++k)
    if (!exchange.exchange(pairs[k], inputs.weight[k], inputs.G_x[k], inputs.bits[k]))
      return;
  block.copy_out(system);
}

template <class Law>
void conduct(System& system, Conduction<Law> const& conduction) {
  auto& particles = system.particles;
  auto const& grid = system.neighbours.grid();
  set_all(system, system.energy_gain, 0.0);
  std::vector<PairCounts> counts(grid.blocks().size());
  Failure failure;
  for_each_block(grid, system.threads, [&](std::size_t block) {
    conduct_block(system, block, conduction, counts[block], failure);
  });
  system.stop_at(failure);
  for (auto const& of_block : counts)
    system.conduction_counts += of_block;
  for_each_range(system, [&](Range range) {
    for (std::size_t i = range.begin; i < range.end; ++i) {
      particles.eps[i] += system.energy_gain[i];
      particles.T[i] = particles.caloric[i].T(system.energy_gain[i]);
    }
  });
}

} // namespace

namespace {

/// How the pairs' heat is treated by a scheme whose friction is not pair after pair.
PairScheme of_conduction(PairScheme scheme) {
  switch (scheme) {
  case PairScheme::ser:
  case PairScheme::hybrid:
  case PairScheme::entropy:
    return PairScheme::ssa;
  case PairScheme::ser_implicit:
    return PairScheme::ams;
  default:
    return scheme;
  }
}

} // namespace

void conduct(System& system, PairScheme scheme, double dt, bool second) {
  auto const pairs = second ? Stream::second_conduction : Stream::conduction,
             acceptance = second ? Stream::second_conduction_acceptance : Stream::conduction_acceptance;
  std::visit(
      [&]<class Law>(Law const& law) {
        if constexpr (!std::is_same_v<Law, std::monostate>)
          conduct(system, Conduction<Law>{.law = law,
                                          .scheme = of_conduction(scheme),
                                          .dt = dt,
                                          .noise = NoiseSource(system.seed, pairs, system.step),
                                          .acceptance = NoiseSource(system.seed, acceptance, system.step)});
      },
      system.conduction);
}

} // namespace mesobridge::sdpd
