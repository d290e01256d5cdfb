#include "coilwright/measurement/corrected_model.hpp"

#include <algorithm>
#include <utility>

namespace coilwright::measurement {
namespace {

std::vector<double> values_of(const std::vector<identification::Estimate>& estimates) {
  std::vector<double> values;
  for (const identification::Estimate& each : estimates) values.push_back(each.value);
  return values;
}

}  // namespace

std::vector<actuator::Effect> effects_of(const Diagnosis& diagnosis) {
  std::vector<actuator::Effect> effects;
  for (const AddedEffect& each : diagnosis.effects)
    effects.push_back({.kind = each.kind, .values = values_of(each.parameters)});
  return effects;
}

std::vector<double> calibration_of(const Diagnosis& diagnosis) {
  std::vector<double> values = values_of(diagnosis.calibration);
  for (const MovedNumber& number : diagnosis.nominal) values.push_back(number.estimate.value);
  return values;
}

actuator::ModelSpec corrected_model(const replay::DeclaredModel& declared, const Diagnosis& diagnosis) {
  actuator::ModelSpec spec = declared.build(calibration_of(diagnosis));
  for (actuator::Effect& effect : effects_of(diagnosis)) {
    const auto same = std::ranges::find(spec.effects, effect.kind, &actuator::Effect::kind);
    if (same == spec.effects.end())
      spec.effects.push_back(std::move(effect));
    else
      *same = std::move(effect);
  }
  return spec;
}

}  // namespace coilwright::measurement
