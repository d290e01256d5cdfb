#include "coilwright/sizing/study/front_part_limits.hpp"

#include <algorithm>
#include <variant>

#include "coilwright/simulation/part_limits.hpp"

namespace coilwright::sizing {

std::vector<FrontPartLimit> front_part_limits(const DesignProblem& problem, std::span<const Record> front) {
  std::vector<FrontPartLimit> out;
  for (const Record& record : front) {
    const DesignResult result = problem.evaluate(record.point);
    const auto* evaluated = std::get_if<EvaluatedDesign>(&result);
    if (evaluated == nullptr) continue;
    for (const simulation::PartLimit& limit : simulation::part_limits(evaluated->view())) {
      auto known = std::ranges::find(out, limit.quantity, &FrontPartLimit::quantity);
      if (known == out.end())
        known = out.insert(out.end(), {.quantity = limit.quantity, .consequence = limit.consequence});
      known->designs += limit.is_broken() ? 1 : 0;
    }
  }
  std::erase_if(out, [](const FrontPartLimit& each) { return each.designs == 0; });
  return out;
}

}  // namespace coilwright::sizing
