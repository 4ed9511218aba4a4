#include "fitting/eos/array.hpp"
#include "fitting/eos/list.hpp"
#include "fitting/eos/mixture_packed.hpp"
#include "workflows/command/options.hpp"
#include "workflows/shared_options.hpp"
#include <algorithm>
#include <chrono>
#include <random>

namespace mesobridge::workflows {
namespace {

constexpr char const* of_mixtures = "mixture";

struct BenchEosOptions {
  std::string model; ///< empty: all of them
  int states = 4096, repeats = 9;
};

/// States around the density that a model is made for, with their energies and entropies.
struct States {
  std::vector<double> rho, T, e, s;
};

template <class E>
double typical_density(E const& eos) {
  if constexpr (requires { eos.parameters().rho_0; })
    return eos.parameters().rho_0;
  else
    return std::isfinite(eos.domain().rho_max) ? 0.6 * eos.domain().rho_max : 1000;
}

template <class E>
States random_states(E const& eos, int n, std::uint64_t seed) {
  std::mt19937_64 generator(seed);
  std::uniform_real_distribution<double> relative_density(0.9, 1.2), relative_temperature(0.3, 1);
  double const rho_0 = typical_density(eos), T_max = eos.domain().T_max;
  double const T_0 = std::isfinite(T_max) ? 0.3 * T_max : 3000;
  States states;
  for (int i = 0; i < n; ++i) {
    states.rho.push_back(rho_0 * relative_density(generator));
    states.T.push_back(T_0 * relative_temperature(generator));
    states.e.push_back(eos.energy_from_temperature(states.T[i], states.rho[i]));
    states.s.push_back(eos.isochore(states.rho[i]).entropy(states.T[i]));
  }
  return states;
}

/// Median over the repeats of the time of one call; `all` makes n calls.
double ns_per_call(int n, int repeats, auto&& all) {
  using Clock = std::chrono::steady_clock;
  constexpr std::chrono::duration<double> enough(1e-3); // of one measurement
  std::vector<double> times;
  for (int repeat = 0; repeat < repeats; ++repeat) {
    auto const begin = Clock::now();
    int rounds = 0;
    do {
      all();
      ++rounds;
    } while (Clock::now() - begin < enough);
    std::chrono::duration<double, std::nano> const spent = Clock::now() - begin;
    times.push_back(spent.count() / (static_cast<double>(n) * rounds));
  }
  std::ranges::nth_element(times, times.begin() + repeats / 2);
  return times[static_cast<std::size_t>(repeats / 2)];
}

template <class E>
Json times_of(E const& eos, BenchEosOptions const& options, std::uint64_t seed) {
  auto const states = random_states(eos, options.states, seed);
  std::vector<double> T(states.e.size()), P(T), C(T);
  auto each = [&](auto&& call) {
    return ns_per_call(options.states, options.repeats, [&] {
      for (std::size_t i = 0; i < T.size(); ++i)
        T[i] = call(i);
    });
  };
  return {{"T_P_C_array", ns_per_call(options.states, options.repeats,
                                      [&] {
                                        evaluate(eos, {states.e, states.rho}, {T, P, C});
                                      })},
          {"temperature", each([&](auto i) { return eos.temperature(states.e[i], states.rho[i]); })},
          {"pressure", each([&](auto i) { return eos.pressure(states.e[i], states.rho[i]); })},
          {"entropy", each([&](auto i) { return eos.entropy(states.e[i], states.rho[i]); })},
          {"energy_from_entropy",
           each([&](auto i) { return eos.energy_from_entropy(states.s[i], states.rho[i]); })},
          {"energy_from_temperature",
           each([&](auto i) { return eos.energy_from_temperature(states.T[i], states.rho[i]); })}};
}

/// Two batches of mixtures near each other, as particles are from step to step: 0.1 % in density, 0.3 % in
/// energy. Each is solved from the solution of the other.
struct MixtureBatches {
  std::vector<double> lambda, rho[2], e[2], s[2], T, log_density_ratio, P, C, c_2;
  int now = 0;

  void next() { now = 1 - now; }
  fitting::MixtureSplit split(std::size_t i) const { return {T[i], log_density_ratio[i]}; }
  void take(std::size_t i, fitting::MixtureState const& state) {
    T[i] = state.T, log_density_ratio[i] = state.split.log_density_ratio;
    P[i] = state.P, C[i] = state.c_v, c_2[i] = state.sound_speed_squared;
  }
};

/// Of n states, or of so many more that they fill packs.
template <class A, class B>
MixtureBatches mixture_batches(fitting::Mixture<A, B> const& mixture, int n, std::uint64_t seed) {
  std::mt19937_64 generator(seed);
  std::uniform_real_distribution<double> progress(0.01, 0.99), density(1400, 1900), temperature(1500, 4500);
  MixtureBatches batches;
  for (int i = 0; i < n || i % fitting::Pack::size != 0; ++i) {
    double const lambda = progress(generator), rho = density(generator);
    auto const state = mixture.state_from_temperature(lambda, rho, temperature(generator));
    auto const near = mixture.state(lambda, 1.001 * rho, 1.003 * state.e, state.split);
    batches.lambda.push_back(lambda);
    batches.rho[0].push_back(rho), batches.e[0].push_back(state.e), batches.s[0].push_back(state.s);
    batches.rho[1].push_back(1.001 * rho), batches.e[1].push_back(near.e), batches.s[1].push_back(near.s);
    batches.T.push_back(state.T), batches.log_density_ratio.push_back(state.split.log_density_ratio);
  }
  for (auto* const out : {&batches.P, &batches.C, &batches.c_2})
    out->resize(batches.T.size());
  return batches;
}

/// Solves a batch by packs, as the engine does: solve(lambda, rho, place, guess) a pack, alone(place) the
/// states that it leaves.
template <class A, class B>
void solve_packs(fitting::PackedMixture<A, B> const& packed, MixtureBatches& of, auto&& solve, auto&& alone) {
  using fitting::Pack;
  of.next();
  for (std::size_t i = 0; i < of.T.size(); i += Pack::size) {
    Pack const lambda = Pack::load(&of.lambda[i]), rho = Pack::load(&of.rho[of.now][i]);
    auto const found = solve(
        lambda, rho, i, fitting::PackedSplit{Pack::load(&of.T[i]), Pack::load(&of.log_density_ratio[i])});
    if (!fitting::all_of(found.solved)) {
      for (std::size_t lane = 0; lane < Pack::size; ++lane)
        alone(i + lane);
      continue;
    }
    auto const at = packed.at(lambda, rho, found.split);
    found.split.T.store(&of.T[i]), found.split.log_density_ratio.store(&of.log_density_ratio[i]);
    at.pressure().store(&of.P[i]), at.heat_capacity().store(&of.C[i]);
    at.sound_speed_squared().store(&of.c_2[i]);
  }
}

/// Of the built-in explosive.
Json times_of_mixtures(BenchEosOptions const& options, std::uint64_t seed, fitting::VolumeLaw law) {
  using fitting::Pack;
  fitting::Mixture const mixture(std::get<fitting::Hz>(fitting::material("nitromethane").eos),
                                 std::get<fitting::Jwl>(fitting::material("nitromethane-products").eos), law);
  fitting::PackedMixture const packed(mixture);
  auto of = mixture_batches(mixture, options.states, seed);
  auto const time = [&](auto&& all) {
    return ns_per_call(static_cast<int>(of.T.size()), options.repeats, all);
  };
  auto const by_energy = [&](std::size_t i) {
    of.take(i, mixture.state(of.lambda[i], of.rho[of.now][i], of.e[of.now][i], of.split(i)));
  };
  auto const by_entropy = [&](std::size_t i) {
    of.take(i, mixture.state_from_entropy(of.lambda[i], of.rho[of.now][i], of.s[of.now][i], of.split(i)));
  };
  auto const packs_by_energy = [&](Pack lambda, Pack rho, std::size_t i, auto const& guess) {
    return packed.from_energy(lambda, rho, Pack::load(&of.e[of.now][i]), guess);
  };
  auto const packs_by_entropy = [&](Pack lambda, Pack rho, std::size_t i, auto const& guess) {
    return packed.from_entropy(lambda, rho, Pack::load(&of.s[of.now][i]), guess);
  };
  return {{"T_P_C_c_array", time([&] { solve_packs(packed, of, packs_by_energy, by_energy); })},
          {"energy_from_entropy_array", time([&] { solve_packs(packed, of, packs_by_entropy, by_entropy); })},
          {"state_alone", time([&] {
             of.next();
             for (std::size_t i = 0; i < of.T.size(); ++i)
               by_energy(i);
           })}};
}

void append(Result& result, std::string const& name, Json const& times) {
  result.json["ns_per_call"][name] = times;
  result.text += name + "\n";
  for (auto const& [call, time] : times.items())
    result.text += fmt::format("  {:<24} {:10.2f} ns\n", call, time.get<double>());
}

Result run(BenchEosOptions const& options, Context const& context) {
  bool const mixtures = options.model == of_mixtures;
  if (!options.model.empty() && !mixtures)
    fitting::material(options.model); // refuses unknown names
  auto const seed = context.options.seed.value_or(1);
  Result result;
  for (auto const& material : fitting::materials())
    if (options.model.empty() || options.model == material.name)
      append(result, material.name,
             std::visit([&](auto const& eos) { return times_of(eos, options, seed); }, material.eos));
  if (options.model.empty() || mixtures) {
    append(result, of_mixtures, times_of_mixtures(options, seed, fitting::VolumeLaw::additive_volume));
    append(result, "mixture, paper's volumes", times_of_mixtures(options, seed, fitting::VolumeLaw::paper));
  }
  result.json["states"] = options.states;
  result.json["repeats"] = options.repeats;
  return result;
}

void declare(CLI::App& app, BenchEosOptions& options) {
  app.add_option("--model", options.model,
                 "one name of `eos list` instead of all, or `mixture`: nitromethane with its products, from "
                 "nearby states");
  add_bounded(app, "--states", options.states, 1, 10000000, "states of one array");
  add_bounded(app, "--repeats", options.repeats, 1, 1000, "measurements, of which the median is given");
}

} // namespace

extern Declaration const bench_eos_command = with_options<BenchEosOptions, declare, run>;

} // namespace mesobridge::workflows
