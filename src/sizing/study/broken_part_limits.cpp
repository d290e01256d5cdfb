#include "coilwright/sizing/study/broken_part_limits.hpp"

#include <algorithm>
#include <optional>
#include <utility>
#include <variant>

namespace coilwright::sizing {

std::vector<simulation::PartLimit> limits_of_pulses(const Study& study, const EvaluatedDesign& design) {
  if (!study.driver) return {};
  std::vector<simulation::PartLimit> out{
      {.quantity = study.driver->thermal_load.name,
       .value = study.driver->thermal_load.value(design.view()),
       .limit = 1.0,
       .consequence = "with the ripple of the driver's pulses, of which no other quantity knows, coils or magnets "
                      "overheat"}};
  if (const std::optional<double> peak = study.driver->peak_over_limit.value(design.view()))
    out.push_back({.quantity = study.driver->peak_over_limit.name,
                   .value = peak,
                   .limit = 1.0,
                   .consequence = "the driver's pulses are beyond its most_current_A"});
  return out;
}

std::vector<simulation::PartLimit> broken_limits(const Study& study, const EvaluatedDesign& design) {
  std::vector<simulation::PartLimit> out = simulation::broken_part_limits(design.view());
  for (simulation::PartLimit& limit : limits_of_pulses(study, design))
    if (limit.is_broken()) out.push_back(std::move(limit));
  return out;
}

std::vector<BrokenPartLimit> broken_part_limits(const Study& study, std::span<const DesignResult> designs) {
  std::vector<BrokenPartLimit> out;
  for (const DesignResult& result : designs) {
    const auto* evaluated = std::get_if<EvaluatedDesign>(&result);
    if (evaluated == nullptr) continue;
    for (const simulation::PartLimit& limit : broken_limits(study, *evaluated)) {
      auto known = std::ranges::find(out, limit.quantity, &BrokenPartLimit::quantity);
      if (known == out.end())
        known = out.insert(out.end(), {.quantity = limit.quantity,
                                       .consequence = told({limit}, evaluated->view()).front().consequence,
                                       .conditional = limit.conditional});
      ++known->designs;
    }
  }
  std::ranges::stable_sort(out, {}, &BrokenPartLimit::conditional);
  return out;
}

}  // namespace coilwright::sizing
