#include "formats/data/calibrate_names.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "coilwright/text/json/json_pointer.hpp"
#include "coilwright/text/one_line.hpp"
#include "coilwright/units/unit.hpp"

namespace coilwright::formats {

using namespace text;

std::vector<std::string> CalibrateNames::steps(std::size_t i) const {
  auto steps = pointer_steps(name(i));
  if (!steps || steps->empty())
    throw error(i, R"(must be "joint_stiffness", "joint_damping" or a JSON pointer into the actuator file)");
  return *std::move(steps);
}

void CalibrateNames::claim(std::size_t i, const std::vector<std::string>& pointers) {
  for (const std::string& pointer : pointers) {
    const auto [claimed, is_new] = claimed_.emplace(pointer, i);
    if (!is_new) throw error(i, "must not mean a number that another name means: " + in_quotes(name(claimed->second)));
  }
}

InputError CalibrateNames::error(std::size_t i, const std::string& rule) const {
  const CalibrateName& each = names_[i];
  return InputError({.file = dataset_,
                     .place = each.place,
                     .rule = rule,
                     .value = each.is_value ? "text " + in_quotes(each.name) : std::string()});
}

InputError CalibrateNames::leads_nowhere(std::size_t i) const {
  return error(i, "must lead to a number of " + one_line(actuator_) + ", and leads nowhere");
}

InputError CalibrateNames::cannot_move(std::size_t i, const std::string& why) const {
  return error(i, "must lead to a number that a fit can move: " + why);
}

std::optional<measurement::replay::EffectNumber> CalibrateNames::effect_number(
    std::size_t i, std::span<const std::string> steps, const std::vector<actuator::Effect>& effects) const {
  if (steps.front() != "effects") return std::nullopt;
  if (steps.size() != 4 || steps[2] != "parameters") throw leads_nowhere(i);
  const auto index = array_index(steps[1]);
  if (!index || *index >= effects.size()) throw leads_nowhere(i);
  const auto parameters = effects[*index].kind->parameters();
  const auto found = std::ranges::find(parameters, steps[3], &actuator::EffectParameter::key);
  if (found == parameters.end()) throw leads_nowhere(i);
  if (!found->choices.empty()) throw cannot_move(i, "this one is a choice");
  return measurement::replay::EffectNumber{.effect = *index,
                                           .parameter = static_cast<std::size_t>(found - parameters.begin())};
}

measurement::replay::CalibrationParameter calibration_parameter(std::string name, std::string_view key, double declared,
                                                                const Rule& rule, double usual) {
  // Where a rule leaves out its end, as for a mass, the nearest number that still makes a model.
  constexpr double nearly_nothing = 1e-9;
  const double scale = declared != 0.0 ? std::abs(declared) : usual;
  double lower = units::to_memory(rule.lower(), key);
  if (std::isfinite(lower) && !rule.allows(rule.lower())) lower += nearly_nothing * scale;
  return {.key = std::move(name),
          .declared = declared,
          .lower = lower,
          .upper = units::to_memory(rule.upper(), key),
          .scale = scale};
}

measurement::replay::CalibrationParameter calibration_parameter(const std::string& pointer,
                                                                const actuator::Effect& effect, std::size_t parameter) {
  const actuator::EffectParameter& known = effect.kind->parameters()[parameter];
  const double declared = effect.values[parameter];
  return {.key = pointer,
          .declared = declared,
          .lower = known.lower,
          .upper = known.upper,
          .scale = declared != 0.0 ? std::abs(declared) : units::to_memory(1.0, known.key)};
}

}  // namespace coilwright::formats
