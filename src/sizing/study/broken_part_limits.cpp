#include "coilwright/sizing/study/broken_part_limits.hpp"

#include <algorithm>
#include <variant>

#include "coilwright/simulation/part_limits.hpp"

namespace coilwright::sizing {

std::vector<BrokenPartLimit> broken_part_limits(std::span<const DesignResult> designs) {
  std::vector<BrokenPartLimit> out;
  for (const DesignResult& result : designs) {
    const auto* evaluated = std::get_if<EvaluatedDesign>(&result);
    if (evaluated == nullptr) continue;
    for (const simulation::PartLimit& limit : simulation::part_limits(evaluated->view())) {
      auto known = std::ranges::find(out, limit.quantity, &BrokenPartLimit::quantity);
      if (known == out.end())
        known = out.insert(out.end(), {.quantity = limit.quantity, .consequence = limit.consequence});
      known->designs += limit.is_broken() ? 1 : 0;
    }
  }
  std::erase_if(out, [](const BrokenPartLimit& each) { return each.designs == 0; });
  return out;
}

}  // namespace coilwright::sizing
