#include "sdpd/reaction/rates.hpp"
#include "sdpd/system/pair_loop.hpp"

namespace mesobridge::sdpd {
namespace {

constexpr double nothing = 1e-18; ///< change of lambda that no number of a run could tell

/// What a particle j gives to the rates of its neighbours beside T_j: w_ij = weight W_ij (Eq. (S62)).
double weight_of(Particles const& of, NeighbourWeights weights, Index j) {
  return weights == NeighbourWeights::kernel ? of.mass_of(j) : of.mass_of(j) / of.rho[j];
}

/// Progress and weights of a block's particles; those of the phantom pair are zero.
struct BlockReactants {
  std::vector<double> progress, weight;
  double hottest = 0, heaviest = 0, most_fuel = 0, most_product = 0;

  void copy_in(System const& system, BlockMembers const& members, NeighbourWeights weights) {
    auto const& of = system.particles;
    progress.assign(size(members) + 2, 0), weight.assign(size(members) + 2, 0);
    hottest = heaviest = most_fuel = most_product = 0;
    for_each_member(members, [&](std::size_t local, Index i, Vec3 const&) {
      progress[local] = of.progress[i], weight[local] = weight_of(of, weights, i);
      hottest = std::max(hottest, of.T[i]), heaviest = std::max(heaviest, weight[local]);
      most_fuel = std::max(most_fuel, 1 - of.progress[i]);
      most_product = std::max(most_product, of.progress[i]);
    });
  }
  /// No particle's lambda changes faster by the others.
  double fastest(SecondOrder const& law, double W_most) const {
    double const forward = law.forward(hottest) * most_fuel * most_fuel,
                 back = law.back.acts() ? law.back(hottest) * most_product * most_product : 0;
    return (forward + back) * heaviest * W_most * static_cast<double>(progress.size());
  }
};

/// Rates of both particles of a pair.
struct PairRates {
  Lanes forward_i, forward_j, backward_i, backward_j;
};

struct AddRates {
  using Sums = std::vector<Rates>;

  [[gnu::always_inline]] static void add(Rates* sums, PairLanes const& at, PairRates const& rates) {
    for (std::size_t l = 0; l < lane_count; ++l) {
      auto &i = sums[at.pair[l].i], &j = sums[at.pair[l].j];
      i.forward += rates.forward_i[l], i.backward += rates.backward_i[l];
      j.forward += rates.forward_j[l], j.backward += rates.backward_j[l];
    }
  }
};

template <class Kernel>
struct SecondOrderRates {
  SecondOrder const& law;
  Kernel const& kernel;
  BlockReactants const& block;

  [[gnu::always_inline]] PairRates operator()(PairLanes const& at) const {
    Lanes progress_i, progress_j, weight_i, weight_j;
    for (std::size_t l = 0; l < lane_count; ++l) {
      auto const [i, j] = at.pair[l];
      progress_i[l] = block.progress[i], progress_j[l] = block.progress[j];
      weight_i[l] = block.weight[i], weight_j[l] = block.weight[j];
    }
    Lanes const T = 0.5 * (at.of_i + at.of_j), W = kernel.W(at.r), K = law.forward(T) * W;
    PairRates rates{weight_j * K * (1.0 - progress_j), weight_i * K * (1.0 - progress_i), Lanes{}, Lanes{}};
    if (law.back.acts()) {
      Lanes const K_back = law.back(T) * W;
      rates.backward_i = weight_j * K_back * progress_j, rates.backward_j = weight_i * K_back * progress_i;
    }
    return rates;
  }
};

template <class Kernel>
void add_pairs(System& system, SecondOrder const& law, Kernel const& kernel, double h) {
  auto const& neighbours = system.neighbours;
  double const W_most = kernel.W(0.0);
  for_each_block(neighbours.grid(), system.threads, [&](std::size_t block) {
    thread_local BlockReactants reactants;
    thread_local std::vector<Row> rows;
    thread_local AddRates::Sums sums;
    auto const members = neighbours.members(block);
    reactants.copy_in(system, members, law.weights);
    if (reactants.fastest(law, W_most) * h < nothing)
      return;
    copy_rows(
        members, system.particles.q, [&](Index i) { return system.particles.T[i]; }, 0.5 * neighbours.range(),
        rows);
    SecondOrderRates<Kernel> of_pairs{law, kernel, reactants};
    sum_over_pairs<AddRates>(rows, neighbours.pairs(block), of_pairs, sums);
    for_each_member(members, [&](std::size_t local, Index i, Vec3 const&) {
      system.rates[i].forward += sums[local].forward, system.rates[i].backward += sums[local].backward;
    });
  });
}

/// Of particle i with one that lies where j, or its image, does.
void add_pair(System& system, SecondOrder const& law, Index i, Index j, double W) {
  auto const& of = system.particles;
  double const T = 0.5 * (of.T[i] + of.T[j]), w = weight_of(of, law.weights, j) * W;
  system.rates[i].forward += w * law.forward(T) * (1 - of.progress[j]);
  if (law.back.acts())
    system.rates[i].backward += w * law.back(T) * of.progress[j];
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
    system.rates[i] = law.rates({of.progress[i], of.T[i], of.P[i], of.rho[i]});
  });
}

template <>
void find_rates(System& system, SecondOrder const& law, double h) {
  set_all(system, system.rates, Rates{});
  std::visit(
      [&](auto const& kernel) {
        add_pairs(system, law, kernel, h);
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
