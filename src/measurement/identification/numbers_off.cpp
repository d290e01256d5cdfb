#include "measurement/identification/numbers_off.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "coilwright/measurement/identification/decision_thresholds.hpp"
#include "measurement/identification/curvature.hpp"
#include "measurement/identification/staged_fit.hpp"

namespace coilwright::measurement::identification {
namespace {

// A typical change of a number that is free again, in tolerances.
constexpr double typical_change = 10.0;
// How far a number has to be moved, in tolerances, to be tried as the one that is off, and how many are tried.
constexpr double moved_far = 1.0;
constexpr std::size_t most_tried = 8;

// A hypothesis under another declared model, fitted from where it was; nothing where there is no fit.
std::optional<FittedHypothesis> fitted_under(const replay::DeclaredModel& declared,
                                             std::span<const replay::PreparedRun> runs,
                                             const FittedHypothesis& fitted) {
  return fit_exactly(runs, {.hypothesis = fit::Hypothesis(declared, fitted.hypothesis.effects_at(fitted.fit.values)),
                            .start = fitted.fit.values,
                            .local_numbers_from = &fitted.fit});
}

double quasi_bic_of(const std::optional<FittedHypothesis>& fitted, double overdispersion) {
  return fitted ? quasi_bic(*fitted, overdispersion) : std::numeric_limits<double>::infinity();
}

// A number by itself, or the coefficients of one function.
struct CalibrationGroup {
  std::string name{};
  std::vector<std::size_t> numbers{};  // places among the calibration
};

CalibrationGroup group_of(const std::vector<replay::CalibrationParameter>& calibration, std::size_t number) {
  const std::string_view function = calibration[number].function;
  if (function.empty()) return {.name = calibration[number].key, .numbers = {number}};
  CalibrationGroup out{.name = std::string(function)};
  for (std::size_t i = 0; i < calibration.size(); ++i)
    if (calibration[i].function == function && calibration[i].tolerance) out.numbers.push_back(i);
  return out;
}

// What a fit has moved far, the furthest first.
std::vector<CalibrationGroup> groups_far_from_prior(const FittedHypothesis& fitted) {
  const auto& calibration = fitted.hypothesis.declared().calibration;
  const auto moved = [&](std::size_t i) {
    return std::abs(fitted.hypothesis.parameters()[i].distance(fitted.fit.values[static_cast<Eigen::Index>(i)]));
  };
  std::vector<std::size_t> numbers;
  for (std::size_t i = 0; i < calibration.size(); ++i)
    if (fitted.hypothesis.parameters()[i].has_prior() && moved(i) > moved_far) numbers.push_back(i);
  std::ranges::stable_sort(numbers, std::ranges::greater{}, moved);
  std::vector<CalibrationGroup> out;
  for (const std::size_t i : numbers) {
    CalibrationGroup group = group_of(calibration, i);
    if (std::ranges::find(out, group.name, &CalibrationGroup::name) == out.end()) out.push_back(std::move(group));
  }
  out.resize(std::min(out.size(), most_tried));
  return out;
}

// A declared model in which one group is free: a number has no tolerance any more, coefficients of a function wide
// ones.
replay::DeclaredModel with_free(replay::DeclaredModel declared, const CalibrationGroup& group) {
  for (const std::size_t i : group.numbers) {
    replay::CalibrationParameter& number = declared.calibration[i];
    number.scale *= typical_change;
    if (number.function.empty())
      number.tolerance.reset();
    else
      number.tolerance->deviation *= typical_change;
  }
  return declared;
}

}  // namespace

std::vector<NumberOff> numbers_that_may_be_off(std::span<const replay::PreparedRun> runs,
                                               const FittedHypothesis& fitted, double overdispersion) {
  std::vector<NumberOff> out;
  const double held = quasi_bic(fitted, overdispersion) - penalty_per_number(fitted, overdispersion);
  for (const CalibrationGroup& group : groups_far_from_prior(fitted)) {
    const auto free = fitted_under(with_free(fitted.hypothesis.declared(), group), runs, fitted);
    const double gain = held - quasi_bic_of(free, overdispersion);
    if (gain < decision_thresholds.decisive_gain) continue;
    out.push_back({.name = group.name, .gain = gain});
    const std::size_t first = group.numbers.front();
    if (!fitted.hypothesis.declared().calibration[first].function.empty()) continue;
    const auto number = static_cast<Eigen::Index>(first);
    out.back().estimate = local_estimate(free->hypothesis.parameters()[first], free->fit.values[number],
                                         standard_deviations(*free, overdispersion)[number]);
  }
  std::ranges::stable_sort(out, std::ranges::greater{}, &NumberOff::gain);
  if (out.empty()) return out;
  const double least = out.front().gain - decision_thresholds.decisive_gain;
  std::erase_if(out, [&](const NumberOff& each) { return each.gain < least; });
  return out;
}

}  // namespace coilwright::measurement::identification
