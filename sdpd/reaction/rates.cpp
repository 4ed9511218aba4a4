#include "sdpd/reaction/rates.hpp"
#include "sdpd/neighbours/pair_values.hpp"
#include "sdpd/system/pair_loop.hpp"
#include "sdpd/system/sum_over_particles.hpp"

namespace mesobridge::sdpd {
namespace {

constexpr double nothing = 1e-18; ///< change of lambda that no number of a run could tell

/// What a particle j gives to the rates of its neighbours beside T_j: w_ij = weight W_ij (Eq. (S62)).
double weight_of(Particles const& of, NeighbourWeights weights, Index j) {
  return weights == NeighbourWeights::kernel ? of.mass_of(j) : of.mass_of(j) / of.rho[j];
}

/// What no particle's rates exceed by a law, from bounds of its neighbours.
struct RateBound {
  SecondOrder const& law;
  double each; ///< heaviest weight times W(0)

  double operator()(double hottest, double most_fuel, double most_product, std::size_t neighbours) const {
    double const forward = law.forward(hottest) * most_fuel * most_fuel,
                 back = law.back.acts() ? law.back(hottest) * most_product * most_product : 0;
    return (forward + back) * each * static_cast<double>(neighbours);
  }
};

double heaviest(System const& system, NeighbourWeights weights) {
  auto const& of = system.particles;
  if (weights == NeighbourWeights::kernel && of.mass.empty())
    return 1;
  return fold_over_particles(
      system, [&](std::size_t i) { return weight_of(of, weights, static_cast<Index>(i)); }, 0,
      [](double most, double value) { return std::max(most, value); });
}

/// What the particles of a block give to their neighbours' rates; the phantom pair gives nothing.
struct BlockReactants {
  std::vector<double> fuel, product; ///< weight (1 - lambda) and, where there is a way back, weight lambda

  void copy_in(System const& system, BlockMembers const& members, SecondOrder const& law) {
    auto const& of = system.particles;
    fuel.assign(size(members) + 2, 0);
    if (law.back.acts())
      product.assign(size(members) + 2, 0);
    for_each_member(members, [&](std::size_t local, Index i, Vec3 const&) {
      double const weight = weight_of(of, law.weights, i);
      fuel[local] = weight * (1 - of.progress[i]);
      if (law.back.acts())
        product[local] = weight * of.progress[i];
    });
  }
};

/// Whether some particle of a block reacts by the others so fast that a number of a run could tell.
bool reacts(System const& system, BlockMembers const& members, RateBound const& bound, double h) {
  auto const& of = system.particles;
  std::size_t const n = size(members);
  double hottest = 0, least = 1, most = 0;
  for (auto const& cell : members)
    for (Index i = cell.begin; i < cell.end; ++i)
      hottest = std::max(hottest, of.T[i]);
  if (bound(hottest, 1, 1, n) * h < nothing)
    return false;
  for (auto const& cell : members)
    for (Index i = cell.begin; i < cell.end; ++i)
      least = std::min(least, of.progress[i]), most = std::max(most, of.progress[i]);
  return !(bound(hottest, 1 - least, most, n) * h < nothing);
}

template <bool there_and_back>
struct AddRates;

/// What both particles of a pair get, of a law without a way back.
struct ForwardRates {
  Lanes i, j;
};

template <>
struct AddRates<false> {
  using Sums = std::vector<double>;

  [[gnu::always_inline]] static void add(double* sums, PairLanes const& at, ForwardRates const& rates) {
    for (std::size_t l = 0; l < lane_count; ++l) {
      sums[at.pair[l].i] += rates.i[l];
      sums[at.pair[l].j] += rates.j[l];
    }
  }
  static void give(Rates& rates, double sum) { rates.forward += sum; }
};

/// And of one with a way back.
struct PairRates {
  ForwardRates forward, backward;
};

template <>
struct AddRates<true> {
  using Sums = std::vector<Rates>;

  [[gnu::always_inline]] static void add(Rates* sums, PairLanes const& at, PairRates const& rates) {
    for (std::size_t l = 0; l < lane_count; ++l) {
      auto &i = sums[at.pair[l].i], &j = sums[at.pair[l].j];
      i.forward += rates.forward.i[l], i.backward += rates.backward.i[l];
      j.forward += rates.forward.j[l], j.backward += rates.backward.j[l];
    }
  }
  static void give(Rates& rates, Rates const& sum) {
    rates.forward += sum.forward, rates.backward += sum.backward;
  }
};

template <class Kernel, bool there_and_back>
struct SecondOrderRates {
  SecondOrder const& law;
  Kernel const& kernel;
  BlockReactants const& block;

  [[gnu::always_inline]] auto operator()(PairLanes const& at) const {
    Lanes const T = 0.5 * (at.of_i + at.of_j), W = kernel.W(at.r);
    auto const forward = given(at, block.fuel, law.forward(T) * W);
    if constexpr (there_and_back)
      return PairRates{forward, given(at, block.product, law.back(T) * W)};
    else
      return forward;
  }

 private:
  [[gnu::always_inline]] static ForwardRates given(PairLanes const& at, std::vector<double> const& by,
                                                   Lanes const& K) {
    auto const of = values_of(by.data(), at.pair);
    return {K * of.j, K * of.i};
  }
};

template <bool there_and_back, class Kernel>
void add_pairs(System& system, SecondOrder const& law, Kernel const& kernel, double h) {
  auto const& neighbours = system.neighbours;
  RateBound const bound{law, heaviest(system, law.weights) * kernel.W(0.0)};
  for_each_block(neighbours.grid(), system.threads, [&](std::size_t block) {
    using Add = AddRates<there_and_back>;
    thread_local BlockReactants reactants;
    thread_local std::vector<Row> rows;
    thread_local typename Add::Sums sums;
    auto const members = neighbours.members(block);
    if (!reacts(system, members, bound, h))
      return;
    reactants.copy_in(system, members, law);
    copy_rows(
        members, system.particles.q, [&](Index i) { return system.particles.T[i]; }, 0.5 * neighbours.range(),
        rows);
    SecondOrderRates<Kernel, there_and_back> of_pairs{law, kernel, reactants};
    sum_over_pairs<Add>(rows, neighbours.pairs(block), of_pairs, sums);
    for_each_member(members, [&](std::size_t local, Index i, Vec3 const&) {
      Add::give(system.rates[system.particles.id[i]], sums[local]);
    });
  });
}

/// Of particle i with one that lies where j, or its image, does.
void add_pair(System& system, SecondOrder const& law, Index i, Index j, double W) {
  auto const& of = system.particles;
  double const T = 0.5 * (of.T[i] + of.T[j]), w = weight_of(of, law.weights, j) * W;
  auto& rates = system.rates[of.id[i]];
  rates.forward += w * law.forward(T) * (1 - of.progress[j]);
  if (law.back.acts())
    rates.backward += w * law.back(T) * of.progress[j];
}

template <class Kernel>
void add_images(System& system, SecondOrder const& law, Kernel const& kernel) {
  for (auto const& wall : system.walls)
    for_each_index(wall.layer.particles.size(), system.threads, [&](std::size_t k) {
      wall.layer.for_each_image(k, [&](Index j, Vec3 const& r) {
        add_pair(system, law, wall.layer.particles[k], j, kernel.W(norm(r)));
      });
    });
}

} // namespace

template <class Law>
void find_rates(System& system, Law const& law, double) {
  auto const& of = system.particles;
  system.rates.resize(system.size());
  for_each_index(system.size(), system.threads, [&](std::size_t i) {
    system.rates[of.id[i]] = law.rates({of.progress[i], of.T[i], of.P[i], of.rho[i]});
  });
}

template <>
void find_rates(System& system, SecondOrder const& law, double h) {
  set_all(system, system.rates, Rates{});
  std::visit(
      [&](auto const& kernel) {
        if (law.back.acts())
          add_pairs<true>(system, law, kernel, h);
        else
          add_pairs<false>(system, law, kernel, h);
        add_images(system, law, kernel);
      },
      system.kernel);
  if (law.weights == NeighbourWeights::normalised)
    for_each_index(system.size(), system.threads, [&](std::size_t i) {
      add_pair(system, law, static_cast<Index>(i), static_cast<Index>(i), system.self_density);
    });
}

template void find_rates(System&, FirstOrder const&, double);
template void find_rates(System&, PressureBurn const&, double);

} // namespace mesobridge::sdpd
