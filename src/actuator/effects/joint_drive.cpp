#include "actuator/effects/joint_drive.hpp"

#include <algorithm>

#include "coilwright/actuator/model/model_spec.hpp"

namespace coilwright::actuator::effects {

std::optional<std::string> without_shafts(const ModelSpec& spec) {
  const auto is_across = [](const HingePair& pair) { return pair.parts != nullptr; };
  if (std::ranges::any_of(spec.magnetics.hinge_pairs(), is_across))
    return "coil and magnet act across the joint, without a motor's shaft";
  return std::nullopt;
}

}  // namespace coilwright::actuator::effects
