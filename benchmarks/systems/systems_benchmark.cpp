#include <benchmark/benchmark.h>

#include <numbers>

#include "coilwright/systems/crawl.hpp"
#include "coilwright/systems/gripper/grasp.hpp"
#include "coilwright/systems/validation/paper_finger.hpp"

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

// The paper's gripper on a ball of 60 mm and 40 g; the argument is whether it is loaded on until it slips.
void grasp_of_a_ball(benchmark::State& state) {
  const gripper::Gripper fingers(validation::paper_finger(), {.angle = std::numbers::pi / 6.0, .spacing = 0.07});
  const gripper::Object ball{
      .shape = gripper::ObjectShape::sphere, .width = 0.06, .mass = 0.04, .friction = 0.8, .centre = {0.0, -0.016}};
  const gripper::GraspTask task{.current = 1.4, .find_capacity = state.range(0) != 0};
  for (auto _ : state) benchmark::DoNotOptimize(gripper::grasp(fingers, ball, task));
}
BENCHMARK(grasp_of_a_ball)->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace coilwright::systems
