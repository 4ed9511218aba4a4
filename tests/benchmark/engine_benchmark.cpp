#include "sdpd/friction/sdpd_friction.hpp"
#include "sdpd/method/settings.hpp"
#include "sdpd/state/random_lanes.hpp"
#include "sdpd_fixtures.hpp"
#include <benchmark/benchmark.h>

namespace mesobridge::sdpd {
namespace {

void gaussian_triples(benchmark::State& state) {
  WideBits a{}, b{};
  for (std::uint32_t lane = 0; lane < wide_count; ++lane)
    a[lane] = lane, b[lane] = 1000 + lane;
  NoiseLanes const source(NoiseSource(1, Stream::fluctuation, 7));
  for (auto _ : state) {
    GaussianLanes G(source, a, b);
    benchmark::DoNotOptimize(G);
    ++a;
  }
  state.SetItemsProcessed(state.iterations() * wide_count);
}
BENCHMARK(gaussian_triples);

void gaussian_triples_by_the_library(benchmark::State& state) {
  NoiseSource const source(1, Stream::fluctuation, 7);
  std::uint32_t id = 0;
  for (auto _ : state)
    benchmark::DoNotOptimize(gaussians_reference(source, ++id, 5));
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(gaussian_triples_by_the_library);

template <class X>
void ornstein_uhlenbeck(benchmark::State& state) {
  X T = constant<X>(1);
  X const other = constant<X>(1.1), inverse_C = constant<X>(0.7), a = constant<X>(0.2);
  for (auto _ : state) {
    PairBath<X> const bath(0.01, T, other, inverse_C, inverse_C);
    benchmark::DoNotOptimize(bath.step(a, a, true, 0.05));
    T += constant<X>(1e-6);
  }
  state.SetItemsProcessed(state.iterations() * (std::is_same_v<X, double> ? 1 : lane_count)); // pairs
}
BENCHMARK(ornstein_uhlenbeck<double>);
BENCHMARK(ornstein_uhlenbeck<FloatLanes>);

/// One whole step; the argument is the number of threads.
void step(benchmark::State& state, SimulationSettings settings) {
  settings.lattice = {20, 20, 20};
  settings.disorder = 0.15;
  settings.threads = static_cast<int>(state.range(0));
  Simulation simulation(settings);
  simulation.advance(20);
  for (auto _ : state)
    simulation.advance(1);
  state.SetItemsProcessed(state.iterations() *
                          static_cast<std::int64_t>(simulation.size())); // particle steps
}
BENCHMARK_CAPTURE(step, ideal_gas, ideal_gas(100, 0.1))
    ->Arg(1)
    ->Arg(2)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(step, argon, argon(100, 0.05))
    ->Arg(1)
    ->Arg(2)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

} // namespace
} // namespace mesobridge::sdpd
