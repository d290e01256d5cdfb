#include "coilwright/actuator/model/effect.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "coilwright/actuator/model/described_effect.hpp"
#include "coilwright/actuator/model/model_spec.hpp"
#include "coilwright/units/unit.hpp"

namespace coilwright::actuator {
namespace {

std::string rule_of(const EffectParameter& parameter) {
  if (!parameter.choices.empty()) {
    std::vector<double> choices(parameter.choices.begin(), parameter.choices.end());
    for (double& choice : choices) choice = units::from_memory(choice, parameter.key);
    return fmt::format("{}", fmt::join(choices, " or "));
  }
  const double lower = units::from_memory(parameter.lower, parameter.key);
  const double upper = units::from_memory(parameter.upper, parameter.key);
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

void EffectTerm::settle(const Kinematics& /*motion*/, const CoilCurrents& /*currents*/, double* out) const {
  std::fill_n(out, states(), 0.0);
}

void EffectTerm::drive(InternalStateView /*own*/, CoilCurrents& /*currents*/) const {}

void EffectTerm::magnetize(InternalStateView /*own*/, const CoilCurrents& /*currents*/,
                           CoilCurrents& /*strength*/) const {}

void EffectTerm::add_torques(const Kinematics& /*motion*/, const CoilCurrents& /*strength*/, InternalStateView /*own*/,
                             mechanics::JointVector& /*torques*/) const {}

void EffectTerm::add_damping(const Kinematics& /*motion*/, const CoilCurrents& /*strength*/,
                             mechanics::JointMatrix& /*damping*/) const {}

void EffectTerm::describe_bodies(const Kinematics& /*motion*/, const CoilCurrents& /*strength*/,
                                 const double* /*states*/, Body* /*out*/) const {}

void EffectTerm::show(InternalStateView /*own*/, mechanics::JointVector& /*angles*/,
                      mechanics::JointVector& /*rates*/) const {}

std::optional<std::string> EffectKind::inapplicable(const ModelSpec& spec) const {
  if ((stage() == Stage::drive || stage() == Stage::magnetics) && spec.coils == 0) return "the model has no coils";
  return std::nullopt;
}

std::optional<std::string> DescribedEffect::inapplicable(const ModelSpec& spec) const {
  return properties_.inapplicable ? properties_.inapplicable(spec) : EffectKind::inapplicable(spec);
}

std::unique_ptr<const EffectTerm> DescribedEffect::build(std::span<const double> values, ModelSpec& spec) const {
  const auto first =
      std::ranges::find_if(properties_.parameters, [](const EffectParameter& each) { return each.absent.has_value(); });
  if (first != properties_.parameters.end() &&
      values[static_cast<std::size_t>(first - properties_.parameters.begin())] == *first->absent)
    return nullptr;
  return properties_.build(values, spec);
}

void validate_effect(const Effect& effect) {
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
                                              rule_of(parameter), units::from_memory(effect.values[i], parameter.key)));
  }
}

}  // namespace coilwright::actuator
