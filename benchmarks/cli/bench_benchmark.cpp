#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <string>

#include "cli/bench/answers.hpp"

namespace coilwright::cli {
namespace {

// What the server of the bench computes and writes for one movement of a slider, as its page asks: no two designs
// alike.
void movement(benchmark::State& state, const char* configuration, bool with_curves) {
  const Bench bench = open_bench(FINGER, 0.8);
  NewestFirst newest;
  static int number = 0;
  for (auto _ : state) {
    const std::string gap = fmt::format("gap_mm={:.4f}", 1.0 + 1e-4 * (number++ % 1000));
    const Turned design = turned(bench, {fmt::format("configuration={}", configuration), gap});
    const NewestFirst::Turn turn(newest, "benchmark");
    benchmark::DoNotOptimize(answer_of(bench, design, turn).text());
    if (with_curves) benchmark::DoNotOptimize(curves_of(bench, design, turn).text());
  }
}

void measure(benchmark::internal::Benchmark* each) {
  each->Unit(benchmark::kMillisecond)
      ->UseRealTime()
      ->MeasureProcessCPUTime()
      ->Iterations(1)
      ->Repetitions(31)
      ->ReportAggregatesOnly();
}
BENCHMARK_CAPTURE(movement, B, "B", false)->Apply(measure);
BENCHMARK_CAPTURE(movement, B_with_curves, "B", true)->Apply(measure);
BENCHMARK_CAPTURE(movement, D, "D", false)->Apply(measure);
BENCHMARK_CAPTURE(movement, D_with_curves, "D", true)->Apply(measure);

}  // namespace
}  // namespace coilwright::cli
