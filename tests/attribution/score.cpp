#include "attribution/score.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "coilwright/units/unit.hpp"

namespace attribution {
namespace {

namespace measurement = coilwright::measurement;
using coilwright::measurement::Diagnosis;
using coilwright::measurement::identification::Estimate;

bool contains(const std::vector<std::string>& ids, const std::string& id) {
  return std::find(ids.begin(), ids.end(), id) != ids.end();
}

bool is_reported_by(const Outcome& outcome, const std::string& reported, const std::string& hidden) {
  if (reported == hidden) return true;
  return std::any_of(outcome.ambiguous.begin(), outcome.ambiguous.end(),
                     [&](const auto& set) { return contains(set, reported) && contains(set, hidden); });
}

bool is_found(const Outcome& outcome) {
  if (outcome.reported.empty() || outcome.answer.hidden.empty()) return false;
  if (outcome.answer.hidden.size() == 1)
    return is_reported_by(outcome, outcome.reported.front(), outcome.answer.hidden.front().id);
  return std::all_of(outcome.answer.hidden.begin(), outcome.answer.hidden.end(), [&](const auto& hidden) {
    return std::any_of(outcome.reported.begin(), outcome.reported.end(),
                       [&](const std::string& id) { return is_reported_by(outcome, id, hidden.id); });
  });
}

bool reports_exactly(const Outcome& outcome) {
  return outcome.reported.size() == outcome.answer.hidden.size() &&
         std::all_of(outcome.answer.hidden.begin(), outcome.answer.hidden.end(),
                     [&](const auto& hidden) { return contains(outcome.reported, hidden.id); });
}

bool inside(const Estimate& estimate, double value) {
  return estimate.lower <= value && value <= estimate.upper;
}

// An interval without bounds contains everything and is not counted.
bool is_bounded(const Estimate& estimate) {
  return estimate.determined && std::isfinite(estimate.lower) && std::isfinite(estimate.upper);
}

Count effect_intervals(const Outcome& outcome, const Diagnosis& diagnosis) {
  Count count;
  for (const measurement::AddedEffect& effect : diagnosis.effects)
    for (const truth::HiddenEffect& hidden : outcome.answer.hidden) {
      if (hidden.id != effect.kind->id()) continue;
      for (const Estimate& estimate : effect.parameters)
        for (const truth::HiddenEffect::Number& number : hidden.numbers) {
          // A side is one of two choices and has no interval.
          if (number.key != estimate.key || number.key == "side" || !is_bounded(estimate)) continue;
          count.add(inside(estimate, coilwright::units::to_memory(number.value, number.key)));
        }
    }
  return count;
}

Count calibration_intervals(const truth::Answer& answer, const Diagnosis& diagnosis) {
  Count count;
  for (const Estimate& estimate : diagnosis.calibration) {
    if (!is_bounded(estimate)) continue;
    if (estimate.key.starts_with("joint_stiffness")) count.add(inside(estimate, answer.joint_stiffness));
    if (estimate.key.starts_with("joint_damping")) count.add(inside(estimate, answer.joint_damping));
  }
  return count;
}

// Relative to the true noise of the file, rounding included, not to the noise that the diagnosis estimates.
std::optional<double> error_over_floor(const truth::Answer& answer, const Diagnosis& diagnosis) {
  std::optional<double> worst;
  for (const measurement::ErrorComparison& error : diagnosis.validate_errors)
    worst =
        std::max(worst.value_or(0.0), error.after.rmse / std::hypot(answer.noise, answer.resolution / std::sqrt(12.0)));
  return worst;
}

}  // namespace

Outcome score(const Case& asked, const truth::Answer& answer, const Diagnosis& diagnosis) {
  Outcome outcome{.number = asked.number, .category = asked.category, .answer = answer, .verdict = diagnosis.verdict};
  for (const measurement::AddedEffect& effect : diagnosis.effects) outcome.reported.emplace_back(effect.kind->id());
  for (const auto& set : diagnosis.indistinguishable) {
    std::vector<std::string>& ids = outcome.ambiguous.emplace_back();
    for (const auto* kind : set) ids.emplace_back(kind->id());
  }
  outcome.found = is_found(outcome);
  outcome.alone = !answer.hidden.empty() && reports_exactly(outcome) && outcome.ambiguous.empty();
  outcome.determined = std::all_of(answer.hidden.begin(), answer.hidden.end(),
                                   [](const auto& hidden) { return hidden.visible && hidden.confounders.empty(); });
  outcome.error_over_floor = error_over_floor(answer, diagnosis);
  if (reports_exactly(outcome)) {
    outcome.effect_intervals = effect_intervals(outcome, diagnosis);
    outcome.calibration_intervals = calibration_intervals(answer, diagnosis);
  }
  return outcome;
}

}  // namespace attribution
