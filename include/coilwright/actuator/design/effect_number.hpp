#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "coilwright/actuator/design/design.hpp"
#include "coilwright/actuator/model/effect.hpp"

namespace coilwright::actuator {

/// Name of the number with that index of an effect, among all numbers of a design: "dry_friction.torque_Nmm".
[[nodiscard]] std::string effect_number_name(const Effect& effect, std::size_t number);

/// A number of an effect of a design, and its rules.
struct EffectNumber {
  double* value{};  ///< SI; nullptr: the design has none of that name
  const EffectParameter* parameter{};
};

/// Finds the number of that name in `design`. The result refers to the design.
[[nodiscard]] EffectNumber find_effect_number(Design& design, std::string_view name);

}  // namespace coilwright::actuator
