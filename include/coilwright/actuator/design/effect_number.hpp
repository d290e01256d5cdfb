#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "coilwright/actuator/design/design.hpp"
#include "coilwright/actuator/model/effect.hpp"

namespace coilwright::actuator {

/// What the number of an effect at that index is called among all numbers of a design: "dry_friction.torque_Nmm".
[[nodiscard]] std::string effect_number_name(const Effect& effect, std::size_t number);

/// A number of an effect of a design, and its rules.
struct EffectNumber {
  double* value{};  ///< SI; nullptr: the design has none of that name
  const EffectParameter* parameter{};
};

/// The number that has that name in `design`, which it refers to.
[[nodiscard]] EffectNumber find_effect_number(Design& design, std::string_view name);

}  // namespace coilwright::actuator
