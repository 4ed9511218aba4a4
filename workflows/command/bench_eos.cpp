#include "fitting/eos/array.hpp"
#include "fitting/eos/list.hpp"
#include "fitting/eos/mixture_array.hpp"
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

  fitting::MixtureStates next() {
    now = 1 - now;
    return {lambda, rho[now], e[now], s[now], T, log_density_ratio, P, C, c_2};
  }
};

template <class A, class B>
MixtureBatches mixture_batches(fitting::Mixture<A, B> const& mixture, int n, std::uint64_t seed) {
  std::mt19937_64 generator(seed);
  std::uniform_real_distribution<double> progress(0.01, 0.99), density(1400, 1900), temperature(1500, 4500);
  MixtureBatches batches;
  for (int i = 0; i < n; ++i) {
    double const lambda = progress(generator), rho = density(generator);
    auto const state = mixture.state_from_temperature(lambda, rho, temperature(generator));
    auto const near = mixture.state(lambda, 1.001 * rho, 1.003 * state.e, state.split);
    batches.lambda.push_back(lambda);
    batches.rho[0].push_back(rho), batches.e[0].push_back(state.e), batches.s[0].push_back(state.s);
    batches.rho[1].push_back(1.001 * rho), batches.e[1].push_back(near.e), batches.s[1].push_back(near.s);
    batches.T.push_back(state.T), batches.log_density_ratio.push_back(state.split.log_density_ratio);
  }
  for (auto* const out : {&batches.P, &batches.C, &batches.c_2})
    out->resize(static_cast<std::size_t>(n));
  return batches;
}

/// Of the built-in explosive.
Json times_of_mixtures(BenchEosOptions const& options, std::uint64_t seed, fitting::VolumeLaw law) {
  fitting::Mixture const mixture(std::get<fitting::Hz>(fitting::material("nitromethane").eos),
                                 std::get<fitting::Jwl>(fitting::material("nitromethane-products").eos), law);
  fitting::MixtureArray const array(mixture);
  auto batches = mixture_batches(mixture, options.states, seed);
  auto const n = static_cast<std::size_t>(options.states);
  auto const failed = [](std::size_t, PhysicsError const& error) { throw error; };
  auto const time = [&](auto&& all) { return ns_per_call(options.states, options.repeats, all); };
  return {{"T_P_C_c_array", time([&] { array.from_energy(batches.next(), 0, n, failed); })},
          {"energy_from_entropy_array", time([&] { array.from_entropy(batches.next(), 0, n, failed); })},
          {"state_alone", time([&] {
             auto const states = batches.next();
             for (std::size_t i = 0; i < n; ++i) {
               auto const found =
                   mixture.state(states.lambda[i], states.rho[i], states.e[i],
                                 fitting::MixtureSplit{states.T[i], states.log_density_ratio[i]});
               states.T[i] = found.T, states.log_density_ratio[i] = found.split.log_density_ratio;
             }
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

Command::Action bench_eos_command(CLI::App& app) {
  return with_options<BenchEosOptions>(app, declare, run);
}

} // namespace mesobridge::workflows
