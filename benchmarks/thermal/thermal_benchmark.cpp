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
                         .core_length = 12e-3,
                         .core_radius = 9.5e-3,
                         .bore_radius = 3e-3,
                         .core_conductivity = 0.55,
                         .core_heat_capacity = 7.8,
                         .wall = 0.3e-3,
                         .solid_end = 20e-3,
                         .resistance = 3.76,
                         .temperature_limit = class_f_enamel_limit};
  HeatSegment tip = coil;
  tip.solid_end = 8.6e-3;
  const HeatSegment magnet{.kind = NodeKind::magnet,
                           .core_length = 6e-3,
                           .core_radius = 10e-3,
                           .core_conductivity = 9.0,
                           .core_heat_capacity = 6.5,
                           .wall = 0.6e-3,
                           .temperature_limit = n_grade_magnet_limit};
  return {.width = 22e-3,
          .height = 24e-3,
          .hinge_layer = 2.5e-3,
          .axis_offset = 11.5e-3,
          .heat_transfer = 50.0,
          .silicone_conductivity = 0.2,
          .silicone_heat_capacity = 1.469e6,
          .ambient = 25.0,
          .temperature_coefficient = 3.93e-3,
          .segments = {coil, magnet, tip},
          .joint_angles = {0.5, 0.5}};
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
