#include "coilwright/formats/data/diagnosis_formatting.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

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

// What the report calls a quantity, and the unit of its errors.
struct ReportedQuantity {
  ChannelKind kind;
  std::string_view name, unit;
};
constexpr std::array reported_quantities = {ReportedQuantity{ChannelKind::bending_angle, "angle", "deg"},
                                            ReportedQuantity{ChannelKind::joint_angle, "angle", "deg"},
                                            ReportedQuantity{ChannelKind::joint_rate, "joint_rate", "deg_s"},
                                            ReportedQuantity{ChannelKind::torque, "torque", "Nmm"},
                                            ReportedQuantity{ChannelKind::force, "force", "N"},
                                            ReportedQuantity{ChannelKind::temperature, "temperature", "K"}};

constexpr units::Unit as_it_is{.suffix = "", .dimension = ""};

units::Unit unit_named(std::string_view suffix) {
  for (const units::Unit& unit : units::all_units())
    if (unit.suffix == suffix) return unit;
  return as_it_is;
}

}  // namespace

std::vector<std::string> ids(std::span<const actuator::EffectKind* const> kinds) {
  std::vector<std::string> out;
  for (const actuator::EffectKind* kind : kinds) out.emplace_back(kind->id());
  return out;
}

std::vector<const ErrorComparison*> main_first(std::span<const ErrorComparison> comparisons) {
  std::vector<const ErrorComparison*> out;
  for (const ErrorComparison& each : comparisons) out.push_back(&each);
  std::ranges::stable_sort(out, {}, rank);
  return out;
}

EstimateInUnit in_unit(const measurement::identification::Estimate& estimate) {
  const std::string_view key = units::key_with_unit(estimate.key);
  return {.value = units::from_memory(estimate.value, key),
          .lower = units::from_memory(estimate.lower, key),
          .upper = units::from_memory(estimate.upper, key),
          .declared = estimate.declared ? std::optional(units::from_memory(*estimate.declared, key)) : std::nullopt};
}

MovedNumberInUnit in_unit(const measurement::MovedNumber& number) {
  const std::string_view key = units::key_with_unit(number.estimate.key);
  return {.declared = units::from_memory(number.declared, key),
          .tolerance = units::from_si(number.tolerance, units::difference_unit(key)),
          .idle_from = number.idle_from ? std::optional(units::from_memory(*number.idle_from, key)) : std::nullopt};
}

double tolerances_moved(const measurement::MovedNumber& number) {
  return (number.idle_from.value_or(number.estimate.value) - number.declared) / number.tolerance;
}

bool is_reported(const measurement::Diagnosis& diagnosis, std::span<const actuator::EffectKind* const> kinds) {
  return !kinds.empty() && kinds.size() == diagnosis.effects.size() &&
         std::ranges::all_of(diagnosis.effects, [&](const measurement::AddedEffect& effect) {
           return std::ranges::find(kinds, effect.kind) != kinds.end();
         });
}

const measurement::identification::WeighedHypothesis* reported_hypothesis(const measurement::Diagnosis& diagnosis) {
  const auto found =
      std::ranges::find_if(diagnosis.odds.hypotheses, [&](const measurement::identification::WeighedHypothesis& each) {
        return diagnosis.effects.empty() ? each.effects.empty() : is_reported(diagnosis, each.effects);
      });
  return found == diagnosis.odds.hypotheses.end() ? nullptr : &*found;
}

double chi_square_without_effects(const measurement::Diagnosis& diagnosis) {
  for (const measurement::identification::WeighedHypothesis& each : diagnosis.odds.hypotheses)
    if (each.effects.empty()) return each.chi_square;
  return std::numeric_limits<double>::quiet_NaN();
}

double probability_of(const measurement::Diagnosis& diagnosis, const actuator::EffectKind& kind) {
  for (const auto& [effect, probability] : diagnosis.odds.effects())
    if (effect == kind.id()) return probability;
  return 0.0;
}

std::string_view name_of(ChannelKind quantity) {
  return std::ranges::find(reported_quantities, quantity, &ReportedQuantity::kind)->name;
}

units::Unit error_unit(ChannelKind quantity) {
  return unit_named(std::ranges::find(reported_quantities, quantity, &ReportedQuantity::kind)->unit);
}

units::Unit variable_unit(std::string_view variable) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 5> table = {
      {{"angle", "deg"}, {"rate", "deg_s"}, {"current", "A"}, {"time", "s"}, {"frequency", "Hz"}}};
  for (const auto& [name, suffix] : table)
    if (name == variable) return unit_named(suffix);
  return as_it_is;
}

std::string with_unit(std::string_view name, const units::Unit& unit) {
  return unit.suffix.empty() ? std::string(name) : fmt::format("{}_{}", name, unit.suffix);
}

}  // namespace coilwright::formats
