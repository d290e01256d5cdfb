#include <benchmark/benchmark.h>

#include "coilwright/winding/inductance.hpp"
#include "coilwright/winding/winding.hpp"

namespace coilwright::winding {
namespace {

void inductance_of_the_prototype(benchmark::State& state) {
  CoilSection section{.inner_radius = 3e-3, .outer_radius = 9.5e-3, .length = 12e-3, .turns = 450};
  for (auto _ : state) {
    benchmark::DoNotOptimize(section);
    benchmark::DoNotOptimize(inductance(section));
  }
}
BENCHMARK(inductance_of_the_prototype);

void winding_of_the_prototype(benchmark::State& state) {
  Winding::Spec spec{.inner_radius = 3e-3, .turns_radial = 15, .turns_axial = 30, .wire = gauge(28)};
  for (auto _ : state) {
    benchmark::DoNotOptimize(spec);
    const Winding winding{spec};
    benchmark::DoNotOptimize(winding.outer_radius() + winding.copper_mass() + winding.resistance(20.0));
  }
}
BENCHMARK(winding_of_the_prototype);

}  // namespace
}  // namespace coilwright::winding
