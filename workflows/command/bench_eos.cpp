#include "fitting/eos/array.hpp"
#include "fitting/eos/list.hpp"
#include "workflows/command/options.hpp"
#include "workflows/shared_options.hpp"
#include <algorithm>
#include <chrono>
#include <random>

namespace mesobridge::workflows {
namespace {

struct Options {
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
Json times_of(E const& eos, Options const& options, std::uint64_t seed) {
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

void append(Result& result, std::string const& name, Json const& times) {
  result.json["ns_per_call"][name] = times;
  result.text += name + "\n";
  for (auto const& [call, time] : times.items())
    result.text += fmt::format("  {:<24} {:10.2f} ns\n", call, time.get<double>());
}

Result run(Options const& options, Context const& context) {
  if (!options.model.empty())
    fitting::material(options.model); // refuses unknown names
  auto const seed = context.options.seed.value_or(1);
  Result result;
  for (auto const& material : fitting::materials())
    if (options.model.empty() || options.model == material.name)
      append(result, material.name,
             std::visit([&](auto const& eos) { return times_of(eos, options, seed); }, material.eos));
  result.json["states"] = options.states;
  result.json["repeats"] = options.repeats;
  return result;
}

void declare(CLI::App& app, Options& options) {
  app.add_option("--model", options.model, "one name of `eos list` instead of all");
  add_bounded(app, "--states", options.states, 1, 10000000, "states of one array");
  add_bounded(app, "--repeats", options.repeats, 1, 1000, "measurements, of which the median is given");
}

} // namespace

Command::Action bench_eos_command(CLI::App& app) {
  return with_options(app, declare, run);
}

} // namespace mesobridge::workflows
