#include <benchmark/benchmark.h>

#include "coilwright/systems/crawl.hpp"
#include "coilwright/validation/paper_finger.hpp"

namespace coilwright::systems {
namespace {

// One second of the paper's robot at 10 Hz; the argument is the time step in microseconds.
void crawler_second(benchmark::State& state) {
  const actuator::Design design = validation::paper_finger();
  CrawlerParts parts;
  parts.friction = {.forwards = 0.3, .backwards = 0.6};
  const Crawler crawler(design, actuator::assemble_or_throw(design), parts);
  const CrawlTiming timing{.settling_periods = 0, .periods = 10, .step = 1e-6 * static_cast<double>(state.range(0))};
  for (auto _ : state) benchmark::DoNotOptimize(crawl(crawler, timing));
}
BENCHMARK(crawler_second)->Arg(100)->Arg(200)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace coilwright::systems
