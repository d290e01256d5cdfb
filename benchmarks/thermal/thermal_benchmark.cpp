#include <benchmark/benchmark.h>

#include "coilwright/thermal/chain.hpp"
#include "coilwright/thermal/limits.hpp"
#include "coilwright/thermal/steady_state.hpp"
#include "coilwright/thermal/transient.hpp"

namespace coilwright::thermal {
namespace {

// The prototype finger: coil, magnet, coil.
HeatChain finger() {
  const HeatSegment coil{.kind = NodeKind::coil,
                         .length = 12.6e-3,
                         .core_radius = 9.5e-3,
                         .solid_end = 20e-3,
                         .resistance = 3.76,
                         .heat_capacity = 12.0,
                         .temperature_limit = class_f_enamel_limit};
  HeatSegment tip = coil;
  tip.solid_end = 8.6e-3;
  const HeatSegment magnet{.kind = NodeKind::magnet,
                           .length = 7.2e-3,
                           .core_radius = 10e-3,
                           .solid_end = 0.0,
                           .resistance = 0.0,
                           .heat_capacity = 9.4,
                           .temperature_limit = n_grade_magnet_limit};
  return {.width = 22e-3,
          .height = 24e-3,
          .heat_transfer = 40.0,
          .silicone_conductivity = 0.2,
          .ambient = 25.0,
          .temperature_coefficient = 3.93e-3,
          .segments = {coil, magnet, tip},
          .gaps = {{.silicone = 0.9e-3}, {.silicone = 0.9e-3}}};
}

void assemble_chain(benchmark::State& state) {
  const HeatChain chain = finger();
  for (auto _ : state) benchmark::DoNotOptimize(build_network(chain));
}
BENCHMARK(assemble_chain);

void steady_temperatures(benchmark::State& state) {
  const Network network = build_network(finger());
  const NodeVector load = same_in_every_coil(network, 0.9);
  for (auto _ : state) benchmark::DoNotOptimize(steady_state(network, load));
}
BENCHMARK(steady_temperatures);

void largest_continuous_current(benchmark::State& state) {
  const Network network = build_network(finger());
  for (auto _ : state) benchmark::DoNotOptimize(continuous_current(network, LimitedParts::everything));
}
BENCHMARK(largest_continuous_current);

void time_of_an_overload(benchmark::State& state) {
  const Network network = build_network(finger());
  for (auto _ : state) {
    benchmark::DoNotOptimize(time_to_limit(network, {.holding_current = 0.4, .overload_current = 1.4}));
  }
}
BENCHMARK(time_of_an_overload);

void calibration(benchmark::State& state) {
  const HeatChain chain = finger();
  for (auto _ : state) benchmark::DoNotOptimize(calibrate_heat_transfer(chain, 1.1));
}
BENCHMARK(calibration);

}  // namespace
}  // namespace coilwright::thermal
