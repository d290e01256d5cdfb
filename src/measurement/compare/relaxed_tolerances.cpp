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

#include "measurement/compare/curvature.hpp"
#include "measurement/compare/search_effort.hpp"
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
fit::Counted<std::optional<FittedHypothesis>> fitted_under(const replay::DeclaredModel& declared,
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
struct DeclaredThing {
  std::string name{};
  std::vector<std::size_t> numbers{};  // places among the calibration
};

DeclaredThing thing_of(const std::vector<replay::CalibrationParameter>& calibration, std::size_t number) {
  const std::string_view function = calibration[number].function;
  if (function.empty()) return {.name = calibration[number].key, .numbers = {number}};
  DeclaredThing out{.name = std::string(function)};
  for (std::size_t i = 0; i < calibration.size(); ++i)
    if (calibration[i].function == function && calibration[i].tolerance) out.numbers.push_back(i);
  return out;
}

// What a fit has moved far, the furthest first; without the numbers whose name one of these effects is.
std::vector<DeclaredThing> things_moved_far(const FittedHypothesis& fitted, const Tried& tried,
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
  std::vector<DeclaredThing> out;
  for (const std::size_t i : numbers) {
    DeclaredThing thing = thing_of(calibration, i);
    if (std::ranges::find(out, thing.name, &DeclaredThing::name) == out.end()) out.push_back(std::move(thing));
  }
  out.resize(std::min(out.size(), tried.most));
  return out;
}

// A declared model in which one thing is free: a number has no tolerance any more, coefficients of a function wide
// ones.
replay::DeclaredModel with_free(replay::DeclaredModel declared, const DeclaredThing& thing) {
  for (const std::size_t i : thing.numbers) {
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

fit::Counted<double> gain_with_wide_tolerances(std::span<const replay::PreparedRun> runs,
                                               const FittedHypothesis& without, const FittedHypothesis& with,
                                               double overdispersion) {
  replay::DeclaredModel relaxed = without.hypothesis.declared();
  const auto has_tolerance = [](const replay::CalibrationParameter& number) { return number.tolerance.has_value(); };
  if (std::ranges::none_of(relaxed.calibration, has_tolerance))
    return {.value = quasi_bic(without, overdispersion) - quasi_bic(with, overdispersion)};
  for (replay::CalibrationParameter& number : relaxed.calibration) {
    if (!has_tolerance(number)) continue;
    number.tolerance->deviation *= wider;
    number.scale *= wider;
  }
  const auto wide_without = fitted_under(relaxed, runs, without);
  const auto wide_with = fitted_under(relaxed, runs, with);
  return {.value = quasi_bic_of(wide_without.value, overdispersion) - quasi_bic_of(wide_with.value, overdispersion),
          .simulated_runs = wide_without.simulated_runs + wide_with.simulated_runs};
}

fit::Counted<GainOverFreeNumber> gain_over_a_free_number(std::span<const replay::PreparedRun> runs,
                                                         const FittedHypothesis& without, const FittedHypothesis& with,
                                                         double overdispersion) {
  fit::Counted<GainOverFreeNumber> out;
  const double charge = penalty_per_number(with, overdispersion);
  for (const DeclaredThing& thing : things_moved_far(without, against_an_effect, with.kinds())) {
    const auto free = fitted_under(with_free(without.hypothesis.declared(), thing), runs, without);
    out.simulated_runs += free.simulated_runs;
    const double gain = quasi_bic_of(free.value, overdispersion) + charge - quasi_bic(with, overdispersion);
    if (gain < out.value.gain) out.value = {.gain = gain, .number = thing.name};
  }
  return out;
}

fit::Counted<std::vector<NumberOff>> numbers_that_may_be_off(std::span<const replay::PreparedRun> runs,
                                                             const FittedHypothesis& fitted, double overdispersion) {
  fit::Counted<std::vector<NumberOff>> out;
  const double held = quasi_bic(fitted, overdispersion) - penalty_per_number(fitted, overdispersion);
  for (const DeclaredThing& thing : things_moved_far(fitted, to_be_named, {})) {
    const auto free = fitted_under(with_free(fitted.hypothesis.declared(), thing), runs, fitted);
    out.simulated_runs += free.simulated_runs;
    const double gain = held - quasi_bic_of(free.value, overdispersion);
    if (gain < decision_thresholds.decisive_gain) continue;
    out.value.push_back({.name = thing.name, .gain = gain});
    const std::size_t first = thing.numbers.front();
    if (!fitted.hypothesis.declared().calibration[first].function.empty()) continue;
    const auto number = static_cast<Eigen::Index>(first);
    out.value.back().estimate =
        local_estimate(free.value->hypothesis.parameters()[first], free.value->fit.values[number],
                       standard_deviations(*free.value, overdispersion)[number]);
  }
  std::ranges::stable_sort(out.value, std::ranges::greater{}, &NumberOff::gain);
  if (out.value.empty()) return out;
  const double least = out.value.front().gain - decision_thresholds.decisive_gain;
  std::erase_if(out.value, [&](const NumberOff& each) { return each.gain < least; });
  return out;
}

}  // namespace coilwright::measurement::compare
