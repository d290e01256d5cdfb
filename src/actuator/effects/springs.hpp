#pragma once

#include <algorithm>
#include <optional>
#include <string>

#include "coilwright/actuator/model/model_spec.hpp"

namespace coilwright::actuator::effects {

/// Why an effect that scales with a joint's spring cannot be in `spec`; nothing where some joint has one.
[[nodiscard]] inline std::optional<std::string> without_springs(const ModelSpec& spec) {
  const bool any =
      std::any_of(spec.hinges.begin(), spec.hinges.end(), [](const Hinge& h) { return h.stiffness > 0.0; });
  if (any) return std::nullopt;
  return "no joint has a spring";
}

/// Stiffness of every joint, N m/rad.
[[nodiscard]] inline mechanics::JointVector stiffnesses(const ModelSpec& spec) {
  mechanics::JointVector k(static_cast<int>(spec.hinges.size()));
  for (int j = 0; j < k.size(); ++j) k[j] = spec.hinges[j].stiffness;
  return k;
}

}  // namespace coilwright::actuator::effects
