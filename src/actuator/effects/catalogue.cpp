#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "coilwright/actuator/effect.hpp"

// The whole list: a line declares an effect and puts it in its place. In the order of the stages; within a stage, in
// the order in which the effects act and are built in, so that those that change a spring stand before those that read
// it.
#define COILWRIGHT_EFFECTS(EFFECT) \
  EFFECT(driver_deadband)          \
  EFFECT(driver_saturation)        \
  EFFECT(current_offset)           \
  EFFECT(coil_heating)             \
  EFFECT(coil_lag)                 \
  EFFECT(off_axis_force)           \
  EFFECT(coil_coil_force)          \
  EFFECT(force_gain)               \
  EFFECT(magnet_heating)           \
  EFFECT(static_attraction)        \
  EFFECT(back_emf)                 \
  EFFECT(joint_asymmetry)          \
  EFFECT(rest_angle)               \
  EFFECT(stiffness_hardening)      \
  EFFECT(viscoelastic_creep)       \
  EFFECT(hysteresis)               \
  EFFECT(dry_friction)             \
  EFFECT(quadratic_drag)           \
  EFFECT(end_stop)                 \
  EFFECT(added_mass)               \
  EFFECT(base_tilt)                \
  EFFECT(measurement_delay)        \
  EFFECT(angle_scale)              \
  EFFECT(angle_offset)

namespace coilwright::actuator {
namespace effects {

// Each is defined in the file of its name.
#define COILWRIGHT_DECLARE(id) const EffectKind& id();
COILWRIGHT_EFFECTS(COILWRIGHT_DECLARE)
#undef COILWRIGHT_DECLARE

}  // namespace effects

namespace {

std::string rule_of(const EffectParameter& parameter) {
  if (!parameter.choices.empty()) {
    std::vector<double> choices(parameter.choices.begin(), parameter.choices.end());
    for (double& choice : choices) choice *= parameter.denominator;
    return fmt::format("{}", fmt::join(choices, " or "));
  }
  const double lower = parameter.lower * parameter.denominator;
  const double upper = parameter.upper * parameter.denominator;
  if (std::isinf(lower) && std::isinf(upper)) return "finite";
  if (std::isinf(upper)) return fmt::format(">= {:.6g}", lower);
  if (std::isinf(lower)) return fmt::format("<= {:.6g}", upper);
  return fmt::format("from {:.6g} to {:.6g}", lower, upper);
}

bool keeps_rule(const EffectParameter& parameter, double value) {
  if (!std::isfinite(value)) return false;
  if (!parameter.choices.empty())
    return std::find(parameter.choices.begin(), parameter.choices.end(), value) != parameter.choices.end();
  return parameter.lower <= value && value <= parameter.upper;
}

}  // namespace

std::span<const EffectKind* const> effect_catalogue() {
#define COILWRIGHT_LIST(id) &effects::id(),
  static const std::array list = {COILWRIGHT_EFFECTS(COILWRIGHT_LIST)};
#undef COILWRIGHT_LIST
  return list;
}

const EffectKind* find_effect(std::string_view id) {
  const std::span<const EffectKind* const> all = effect_catalogue();
  const auto found = std::find_if(all.begin(), all.end(), [&](const EffectKind* kind) { return kind->id() == id; });
  return found == all.end() ? nullptr : *found;
}

void check(const Effect& effect) {
  if (effect.kind == nullptr) throw std::invalid_argument("effect: must be one of the catalogue; got none");
  const EffectKind& kind = *effect.kind;
  const std::span<const EffectParameter> parameters = kind.parameters();
  if (effect.values.size() != parameters.size())
    throw std::invalid_argument(fmt::format("effect {}: must have {} value{}; got {}", kind.id(), parameters.size(),
                                            parameters.size() == 1 ? "" : "s", effect.values.size()));
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const EffectParameter& parameter = parameters[i];
    if (!keeps_rule(parameter, effect.values[i]))
      throw std::invalid_argument(fmt::format("effect {}: {} must be {}; got {:.6g}", kind.id(), parameter.key,
                                              rule_of(parameter), effect.values[i] * parameter.denominator));
  }
}

}  // namespace coilwright::actuator
