#include "formats/study/system_block.hpp"

#include "coilwright/systems/crawl_quantities.hpp"

namespace coilwright::formats {
namespace {

using namespace text;
using systems::CrawlTask;

void require_no_terms(const actuator::Design& design) {
  require_without(
      design, [](const actuator::Model& model) { return model.has_terms(); }, "effects that act while it runs");
}

}  // namespace

SystemBlock read_crawler_block(const Node& node) {
  return read_object(node, [](ObjectReader& in) {
    const auto task = read_rows(in, crawl_rows(), CrawlTask{});
    const auto task_of = task_by("crawler", crawl_rows(), task);
    return SystemBlock{
        .quantities = systems::crawl_quantities(task_of),
        .variables = variables_of("crawler", crawl_rows(), task),
        .require_suitable = require_no_terms,
        .driven = {.drive = [task_of](const actuator::Assembly& assembly, const simulation::Settings& settings) {
          const systems::CrawlerParts parts = task_of(settings).parts;
          return sizing::DrivenCurrent::Drive{.current = systems::pulse_current(assembly, parts),
                                              .duty = parts.drive.duty};
        }}};
  });
}

}  // namespace coilwright::formats
