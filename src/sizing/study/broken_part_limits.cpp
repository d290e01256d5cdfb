#include "coilwright/sizing/study/broken_part_limits.hpp"

#include <algorithm>
#include <utility>
#include <variant>

namespace coilwright::sizing {

std::optional<simulation::PartLimit> limit_of_pulses(const Study& study, const EvaluatedDesign& design) {
  if (!study.driver) return std::nullopt;
  return simulation::PartLimit{.quantity = study.driver->thermal_load.name,
                               .value = study.driver->thermal_load.value(design.view()),
                               .limit = 1.0,
                               .consequence =
                                   "with the ripple of the driver's pulses, of which no other quantity "
                                   "knows, coils or magnets overheat"};
}

std::vector<BrokenPartLimit> broken_part_limits(const Study& study, std::span<const DesignResult> designs) {
  std::vector<BrokenPartLimit> out;
  for (const DesignResult& result : designs) {
    const auto* evaluated = std::get_if<EvaluatedDesign>(&result);
    if (evaluated == nullptr) continue;
    std::vector<simulation::PartLimit> broken = simulation::broken_part_limits(evaluated->view());
    if (auto pulses = limit_of_pulses(study, *evaluated); pulses && pulses->is_broken())
      broken.push_back(std::move(*pulses));
    for (simulation::PartLimit& limit : broken) {
      auto known = std::ranges::find(out, limit.quantity, &BrokenPartLimit::quantity);
      if (known == out.end())
        known = out.insert(out.end(), {.quantity = limit.quantity,
                                       .consequence = std::move(limit.consequence),
                                       .conditional = limit.conditional});
      ++known->designs;
    }
  }
  std::ranges::stable_sort(out, {}, &BrokenPartLimit::conditional);
  return out;
}

}  // namespace coilwright::sizing
