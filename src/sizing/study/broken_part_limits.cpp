#include "coilwright/sizing/study/broken_part_limits.hpp"

#include <algorithm>
#include <utility>
#include <variant>

#include "coilwright/simulation/part_limits.hpp"

namespace coilwright::sizing {

std::vector<BrokenPartLimit> broken_part_limits(std::span<const DesignResult> designs) {
  std::vector<BrokenPartLimit> out;
  for (const DesignResult& result : designs) {
    const auto* evaluated = std::get_if<EvaluatedDesign>(&result);
    if (evaluated == nullptr) continue;
    for (simulation::PartLimit& limit : simulation::broken_part_limits(evaluated->view())) {
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
