#include "formats/study/crawler_block.hpp"

#include "coilwright/systems/crawl_quantities.hpp"

namespace coilwright::formats {
namespace {

using namespace text;
using systems::CrawlTask;
using CrawlerNumber = BlockNumber<CrawlTask>;

// As `crawl` has options.
std::vector<CrawlerNumber> numbers() {
  constexpr auto required = CrawlerNumber::Presence::required;
  return {{.key = "friction_forwards",
           .rule = up_to(10.0),
           .get = [](const CrawlTask& task) { return task.parts.friction.forwards; },
           .set = [](CrawlTask& task, double value) { task.parts.friction.forwards = value; },
           .presence = required},
          {.key = "friction_backwards",
           .rule = up_to(10.0),
           .get = [](const CrawlTask& task) { return task.parts.friction.backwards; },
           .set = [](CrawlTask& task, double value) { task.parts.friction.backwards = value; },
           .presence = required},
          {.key = "frequency_Hz",
           .rule = Rule::between(0.1, 1000.0),
           .get = [](const CrawlTask& task) { return task.parts.drive.frequency; },
           .set = [](CrawlTask& task, double value) { task.parts.drive.frequency = value; }},
          {.key = "duty",
           .rule = positive.and_also(Rule::below(1.0)),
           .get = [](const CrawlTask& task) { return task.parts.drive.duty; },
           .set = [](CrawlTask& task, double value) { task.parts.drive.duty = value; }},
          {.key = "cell_voltage_V",
           .rule = up_to(100.0),
           .get = [](const CrawlTask& task) { return task.parts.cell.voltage; },
           .set = [](CrawlTask& task, double value) { task.parts.cell.voltage = value; }},
          {.key = "cell_capacity_mAh",
           .rule = up_to(1e6),
           .get = [](const CrawlTask& task) { return task.parts.cell.capacity; },
           .set = [](CrawlTask& task, double value) { task.parts.cell.capacity = value; }},
          {.key = "cell_limit_A",
           .rule = up_to(1e3),
           .get = [](const CrawlTask& task) { return task.parts.cell.current_limit; },
           .set = [](CrawlTask& task, double value) { task.parts.cell.current_limit = value; }},
          {.key = "lead_resistance_Ohm",
           .rule = Rule::between(0.0, 1e3),
           .get = [](const CrawlTask& task) { return task.parts.drive.lead_resistance; },
           .set = [](CrawlTask& task, double value) { task.parts.drive.lead_resistance = value; }},
          {.key = "payload_mass_g",
           .rule = up_to(1e4),
           .get = [](const CrawlTask& task) { return task.parts.payload.mass; },
           .set = [](CrawlTask& task, double value) { task.parts.payload.mass = value; }},
          {.key = "payload_length_mm",
           .rule = up_to(1e3),
           .get = [](const CrawlTask& task) { return task.parts.payload.length; },
           .set = [](CrawlTask& task, double value) { task.parts.payload.length = value; }},
          {.key = "step_ms",
           .rule = Rule::between(1e-3, 1.0),
           .get = [](const CrawlTask& task) { return task.timing.step; },
           .set = [](CrawlTask& task, double value) { task.timing.step = value; },
           .kind = CrawlerNumber::Kind::of_computation},
          {.key = "settling_periods",
           .rule = Rule::between(0, 10000),
           .get = [](const CrawlTask& task) { return static_cast<double>(task.timing.settling_periods); },
           .set = [](CrawlTask& task, double value) { task.timing.settling_periods = static_cast<int>(value); },
           .kind = CrawlerNumber::Kind::whole_step},
          {.key = "periods",
           .rule = Rule::between(1, 10000),
           .get = [](const CrawlTask& task) { return static_cast<double>(task.timing.periods); },
           .set = [](CrawlTask& task, double value) { task.timing.periods = static_cast<int>(value); },
           .kind = CrawlerNumber::Kind::whole_step}};
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

std::vector<std::string> crawler_quantity_names() {
  std::vector<std::string> names;
  for (const simulation::ResultQuantity& each :
       systems::crawl_quantities([](const simulation::Settings&) { return CrawlTask{}; }))
    names.push_back(each.name);
  return names;
}

}  // namespace coilwright::formats
