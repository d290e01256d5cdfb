#include "coilwright/formats/simulation/assumptions_json.hpp"

#include <utility>
#include <variant>

#include "coilwright/formats/simulation/performance_json.hpp"

namespace coilwright::formats {

using text::Json;

Json to_json(std::span<const simulation::PartLimit> limits) {
  return Json::list(limits, [](const simulation::PartLimit& limit) {
    return Json::object({{"quantity", limit.quantity},
                         {"value", limit.value},
                         {limit.at_most ? "at_most" : "at_least", limit.limit},
                         {"broken", limit.is_broken()},
                         {"conditional", limit.conditional},
                         {"consequence", limit.consequence}});
  });
}

Json to_json(const actuator::OtherChoice& choice) {
  return Json::object({{"subject", choice.subject},
                       {"taken", choice.taken},
                       {"otherwise", choice.otherwise},
                       {"settled_by", choice.settled_by}});
}

Json to_json(std::span<const simulation::ChoiceEffect> effects) {
  Json out = Json::array();
  for (const simulation::ChoiceEffect& effect : effects) {
    Json entry = to_json(effect.choice);
    if (const auto* why = std::get_if<simulation::NoPerformance>(&effect.result)) {
      entry.set("reason", why->reason);
    } else {
      const simulation::DesignView design = std::get<simulation::EvaluatedDesign>(effect.result).view();
      entry.set("part_limits", to_json(simulation::part_limits(design)));
      entry.set("performance", to_json(design));
    }
    out.add(std::move(entry));
  }
  return out;
}

}  // namespace coilwright::formats
