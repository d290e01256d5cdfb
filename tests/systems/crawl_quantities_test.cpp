#include "coilwright/systems/crawl_quantities.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <memory>

#include "coilwright/simulation/evaluate.hpp"
#include "coilwright/systems/validation/paper_finger.hpp"

namespace coilwright::systems {
namespace {

CrawlTask short_crawl() {
  return {.parts = {.friction = {.forwards = 0.3, .backwards = 0.6}},
          .timing = {.settling_periods = 1, .periods = 2, .step = 2e-4}};
}

simulation::QuantityTable table_of(const CrawlTask& task, std::atomic<int>* calls = nullptr) {
  return simulation::QuantityTable(crawl_quantities([task, calls](const simulation::Settings&) {
    if (calls != nullptr) ++*calls;
    return task;
  }));
}

simulation::EvaluatedDesign finger_at_one_ampere() {
  return simulation::evaluate(validation::paper_finger(), {.current = 1.0});
}

TEST(CrawlQuantities, AreThoseOfTheCrawl) {
  const auto design = finger_at_one_ampere();
  const CrawlTask task = short_crawl();
  const Crawl found = crawl(Crawler(design.design, design.assembly, task.parts), task.timing);
  const simulation::QuantityTable table = table_of(task);
  const auto value = [&](const char* name) { return table.at(name).value(design.view()).value(); };
  EXPECT_EQ(value("crawl_speed_mm_s"), 1e3 * found.speed);
  EXPECT_EQ(value("crawl_power_W"), found.powers.electrical);
  EXPECT_EQ(value("crawl_run_time_s"), found.run_time);
  EXPECT_EQ(value("crawl_distance_per_charge_m"), found.speed * found.run_time);
  EXPECT_EQ(value("crawl_coil_current_A"), found.pulse_current);
  EXPECT_EQ(value("crawl_cell_load"), 2.0 * found.pulse_current / 3.0);
  EXPECT_NEAR(value("crawler_mass_g"), 1e3 * Crawler(design.design, design.assembly, task.parts).mass(),
              1e-12 * 91.0);  // sums of the same parts in another order
}

TEST(CrawlQuantities, LetTheRobotCrawlOnce) {
  const auto design = finger_at_one_ampere();
  std::atomic<int> calls = 0;
  const simulation::QuantityTable table = table_of(short_crawl(), &calls);
  for (const char* name : {"crawl_speed_mm_s", "crawl_power_W", "crawl_distance_per_charge_m"})
    (void)table.at(name).value(design.view());
  EXPECT_EQ(calls, 1);
}

TEST(CrawlQuantities, SayWhatACellCannotSupply) {
  const auto design = finger_at_one_ampere();
  CrawlTask task = short_crawl();
  task.parts.cell.current_limit = 1.5;
  const simulation::QuantityTable table = table_of(task);
  EXPECT_FALSE(table.at("crawl_speed_mm_s").value(design.view()));
  const simulation::NoValue why = table.at("crawl_speed_mm_s").why_absent(design.view());
  EXPECT_EQ(why.reason, "cell: the current of a pulse, 2.099 A through 2 coils, must not exceed its limit of 1.5 A");
  // The paper's 1.05 A a coil has three digits.
  EXPECT_NEAR(why.infeasibility, 2.1 / 1.5, 5e-3);
  EXPECT_NEAR(table.at("crawl_cell_load").value(design.view()).value(), 2.1 / 1.5, 5e-3);
}

}  // namespace
}  // namespace coilwright::systems
