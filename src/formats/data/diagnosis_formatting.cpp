#include "coilwright/formats/data/diagnosis_formatting.hpp"

#include <algorithm>

#include "coilwright/units/unit.hpp"

namespace coilwright::formats {
namespace {

using measurement::ErrorComparison;
using measurement::data::ChannelKind;

int rank(const ErrorComparison* comparison) {
  if (comparison->kind == ChannelKind::bending_angle) return 0;
  if (comparison->kind == ChannelKind::joint_angle) return 1;
  return 2;
}

}  // namespace

std::vector<std::string> ids(std::span<const actuator::EffectKind* const> kinds) {
  std::vector<std::string> out;
  for (const actuator::EffectKind* kind : kinds) out.emplace_back(kind->id());
  return out;
}

// The residual of any fit has a correlation time of at least one sample.
std::vector<const ErrorComparison*> main_first(std::span<const ErrorComparison> comparisons) {
  std::vector<const ErrorComparison*> out;
  for (const ErrorComparison& each : comparisons) out.push_back(&each);
  std::ranges::stable_sort(out, {}, rank);
  return out;
}

EstimateInUnit in_unit(const measurement::compare::Estimate& estimate) {
  const units::Unit unit{.suffix = estimate.key, .dimension = "", .denominator = estimate.denominator};
  return {.value = units::from_si(estimate.value, unit),
          .lower = units::from_si(estimate.lower, unit),
          .upper = units::from_si(estimate.upper, unit)};
}

}  // namespace coilwright::formats
