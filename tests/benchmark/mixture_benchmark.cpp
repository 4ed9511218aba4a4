#include "fitting/eos/list.hpp"
#include "fitting/eos/mixture.hpp"
#include <benchmark/benchmark.h>

namespace mesobridge::fitting {
namespace {

/// One warm solution after another, each a step of the given relative size from the last.
void warm_mixture_state(benchmark::State& state) {
  Mixture const mixture(std::get<Hz>(material("nitromethane").eos),
                        std::get<Jwl>(material("nitromethane-products").eos));
  double const step = 1.0 / double(state.range(0)), lambda = 0.3, rho = 1400, e = 3e6;
  auto split = mixture.state(lambda, rho, e).split;
  double sign = 1;
  for (auto _ : state) {
    auto const found = mixture.state(lambda, rho * (1 + sign * step), e * (1 - sign * step), split);
    benchmark::DoNotOptimize(found);
    split = found.split;
    sign = -sign;
  }
}
BENCHMARK(warm_mixture_state)->Arg(100)->Arg(1000)->Arg(100000);

void cold_mixture_state(benchmark::State& state) {
  Mixture const mixture(std::get<Hz>(material("nitromethane").eos),
                        std::get<Jwl>(material("nitromethane-products").eos));
  for (auto _ : state)
    benchmark::DoNotOptimize(mixture.state(0.3, 1400, 3e6));
}
BENCHMARK(cold_mixture_state);

} // namespace
} // namespace mesobridge::fitting
