#include "coilwright/measurement/replay/mean_of_joints.hpp"

#include <algorithm>

namespace coilwright::measurement::replay {

MeanOfJoints mean_of_joints(const std::vector<actuator::Hinge>& hinges, double actuator::Hinge::*member) {
  const double first = hinges.front().*member;
  if (std::ranges::all_of(hinges, [&](const actuator::Hinge& hinge) { return hinge.*member == first; }))
    return {.mean = first, .ratios = std::vector<double>(hinges.size(), 1.0)};
  MeanOfJoints out;
  for (const actuator::Hinge& hinge : hinges) out.mean += hinge.*member / static_cast<double>(hinges.size());
  for (const actuator::Hinge& hinge : hinges) out.ratios.push_back(hinge.*member / out.mean);
  return out;
}

}  // namespace coilwright::measurement::replay
