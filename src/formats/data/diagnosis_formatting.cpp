#include "coilwright/formats/data/diagnosis_formatting.hpp"

#include <algorithm>

#include "coilwright/text/json/json_pointer.hpp"
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

std::string_view key_with_unit(std::string_view name) {
  const std::size_t slash = name.rfind('/');
  return slash != std::string_view::npos && text::array_index(name.substr(slash + 1)) ? name.substr(0, slash) : name;
}

EstimateInUnit in_unit(const measurement::compare::Estimate& estimate) {
  const std::string_view key = key_with_unit(estimate.key);
  return {.value = units::from_memory(estimate.value, key),
          .lower = units::from_memory(estimate.lower, key),
          .upper = units::from_memory(estimate.upper, key)};
}

}  // namespace coilwright::formats
