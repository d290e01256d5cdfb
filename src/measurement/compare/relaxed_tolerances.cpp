#include "measurement/compare/relaxed_tolerances.hpp"

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

#include "coilwright/measurement/compare/decision_thresholds.hpp"
#include "measurement/compare/curvature.hpp"
#include "measurement/compare/staged_fit.hpp"

namespace coilwright::measurement::compare {
namespace {

constexpr double wider = 3.0;
// A typical change of a number that is free again, in tolerances.
constexpr double typical_change = 10.0;
// How far a number has to be moved, in tolerances, to be tried as the one that is off, and how many are tried: against
// an effect those that chance would rarely move so far; where one is to be named all that may be it.
struct Tried {
  double moved{};
  std::size_t most{};
};
constexpr Tried against_an_effect{.moved = 2.0, .most = 4};
constexpr Tried to_be_named{.moved = 1.0, .most = 8};

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

bool is_named_by(const replay::CalibrationParameter& number, const std::vector<const actuator::EffectKind*>& kinds) {
  return std::ranges::any_of(kinds, [&](const actuator::EffectKind* kind) { return number.effect == kind->id(); });
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

// What a fit has moved far, the furthest first; without the numbers whose name one of these effects is.
std::vector<CalibrationGroup> groups_far_from_prior(const FittedHypothesis& fitted, const Tried& tried,
                                                    const std::vector<const actuator::EffectKind*>& kinds) {
  const auto& calibration = fitted.hypothesis.declared().calibration;
  const auto moved = [&](std::size_t i) {
    return std::abs(fitted.hypothesis.parameters()[i].distance(fitted.fit.values[static_cast<Eigen::Index>(i)]));
  };
  std::vector<std::size_t> numbers;
  for (std::size_t i = 0; i < calibration.size(); ++i)
    if (fitted.hypothesis.parameters()[i].has_prior() && moved(i) > tried.moved && !is_named_by(calibration[i], kinds))
      numbers.push_back(i);
  std::ranges::stable_sort(numbers, std::ranges::greater{}, moved);
  std::vector<CalibrationGroup> out;
  for (const std::size_t i : numbers) {
    CalibrationGroup group = group_of(calibration, i);
    if (std::ranges::find(out, group.name, &CalibrationGroup::name) == out.end()) out.push_back(std::move(group));
  }
  out.resize(std::min(out.size(), tried.most));
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

bool adds_the_name_of_a_number(const FittedHypothesis& without, const FittedHypothesis& with) {
  const std::vector<const actuator::EffectKind*> known = without.kinds();
  const auto& numbers = with.hypothesis.declared().calibration;
  return std::ranges::any_of(with.kinds(), [&](const actuator::EffectKind* kind) {
    if (std::ranges::find(known, kind) != known.end()) return false;
    return std::ranges::any_of(numbers, [&](const replay::CalibrationParameter& number) {
      return number.tolerance && number.effect == kind->id();
    });
  });
}

double gain_with_wide_tolerances(std::span<const replay::PreparedRun> runs, const FittedHypothesis& without,
                                 const FittedHypothesis& with, double overdispersion) {
  replay::DeclaredModel relaxed = without.hypothesis.declared();
  const auto has_tolerance = [](const replay::CalibrationParameter& number) { return number.tolerance.has_value(); };
  if (std::ranges::none_of(relaxed.calibration, has_tolerance))
    return quasi_bic(without, overdispersion) - quasi_bic(with, overdispersion);
  for (replay::CalibrationParameter& number : relaxed.calibration) {
    if (!has_tolerance(number)) continue;
    number.tolerance->deviation *= wider;
    number.scale *= wider;
  }
  const auto wide_without = fitted_under(relaxed, runs, without);
  const auto wide_with = fitted_under(relaxed, runs, with);
  return quasi_bic_of(wide_without, overdispersion) - quasi_bic_of(wide_with, overdispersion);
}

GainOverFreeNumber gain_over_a_free_number(std::span<const replay::PreparedRun> runs, const FittedHypothesis& without,
                                           const FittedHypothesis& with, double overdispersion) {
  GainOverFreeNumber out;
  const double charge = penalty_per_number(with, overdispersion);
  for (const CalibrationGroup& group : groups_far_from_prior(without, against_an_effect, with.kinds())) {
    const auto free = fitted_under(with_free(without.hypothesis.declared(), group), runs, without);
    const double gain = quasi_bic_of(free, overdispersion) + charge - quasi_bic(with, overdispersion);
    if (gain < out.gain) out = {.gain = gain, .number = group.name};
  }
  return out;
}

std::vector<NumberOff> numbers_that_may_be_off(std::span<const replay::PreparedRun> runs,
                                               const FittedHypothesis& fitted, double overdispersion) {
  std::vector<NumberOff> out;
  const double held = quasi_bic(fitted, overdispersion) - penalty_per_number(fitted, overdispersion);
  for (const CalibrationGroup& group : groups_far_from_prior(fitted, to_be_named, {})) {
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

}  // namespace coilwright::measurement::compare
