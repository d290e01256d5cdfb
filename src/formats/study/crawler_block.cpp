#include "formats/study/system_block.hpp"

#include "coilwright/systems/crawl_quantities.hpp"

namespace coilwright::formats {
namespace {

using namespace text;
using systems::CrawlTask;
using CrawlerNumber = BlockNumber<CrawlTask>;

// As `crawl` has options.
std::vector<CrawlerNumber> numbers() {
  using enum CrawlerNumber::Kind;
  return {
      block_number<CrawlTask>(
          "friction_forwards", up_to(10.0), [](auto& task) -> auto& { return task.parts.friction.forwards; }, required),
      block_number<CrawlTask>(
          "friction_backwards", up_to(10.0), [](auto& task) -> auto& { return task.parts.friction.backwards; },
          required),
      block_number<CrawlTask>(
          "frequency_Hz", Rule::between(0.1, 1000.0), [](auto& task) -> auto& { return task.parts.drive.frequency; }),
      block_number<CrawlTask>(
          "duty", positive.and_also(Rule::below(1.0)), [](auto& task) -> auto& { return task.parts.drive.duty; }),
      block_number<CrawlTask>(
          "cell_voltage_V", up_to(100.0), [](auto& task) -> auto& { return task.parts.cell.voltage; }),
      block_number<CrawlTask>(
          "cell_capacity_mAh", up_to(1e6), [](auto& task) -> auto& { return task.parts.cell.capacity; }),
      block_number<CrawlTask>(
          "cell_limit_A", up_to(1e3), [](auto& task) -> auto& { return task.parts.cell.current_limit; }),
      block_number<CrawlTask>(
          "lead_resistance_Ohm", Rule::between(0.0, 1e3),
          [](auto& task) -> auto& { return task.parts.drive.lead_resistance; }),
      block_number<CrawlTask>(
          "payload_mass_g", up_to(1e4), [](auto& task) -> auto& { return task.parts.payload.mass; }),
      block_number<CrawlTask>(
          "payload_length_mm", up_to(1e3), [](auto& task) -> auto& { return task.parts.payload.length; }),
      block_number<CrawlTask>(
          "step_ms", Rule::between(1e-3, 1.0), [](auto& task) -> auto& { return task.timing.step; }, of_computation),
      block_number<CrawlTask>(
          "settling_periods", Rule::between(0, 10000), [](auto& task) -> auto& { return task.timing.settling_periods; },
          whole_step),
      block_number<CrawlTask>(
          "periods", Rule::between(1, 10000), [](auto& task) -> auto& { return task.timing.periods; }, whole_step)};
}

void require_no_terms(const actuator::Design& design) {
  require_without(
      design, [](const actuator::Model& model) { return model.has_terms(); }, "effects that act while it runs");
}

}  // namespace

SystemBlock read_crawler_block(const Node& node) {
  return read_object(node, [](ObjectReader& in) {
    CrawlTask task;
    const std::vector<CrawlerNumber> all = numbers();
    read_numbers<CrawlTask>(in, all, task);
    const auto task_of = task_by("crawler", all, task);
    return SystemBlock{
        .quantities = systems::crawl_quantities(task_of),
        .variables = variables_of<CrawlTask>("crawler", all, task),
        .require_suitable = require_no_terms,
        .driven = {.drive = [task_of](const actuator::Assembly& assembly, const simulation::Settings& settings) {
          const systems::CrawlerParts parts = task_of(settings).parts;
          return sizing::DrivenCurrent::Drive{.current = systems::pulse_current(assembly, parts),
                                              .duty = parts.drive.duty};
        }}};
  });
}

}  // namespace coilwright::formats
