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

#include "measurement/compare/staged_fit.hpp"

namespace coilwright::measurement::compare {
namespace {

constexpr double wider = 3.0;
// A typical change of a number that is free again, in tolerances.
constexpr double typical_change = 10.0;
// How far a number has to be moved, in tolerances, to be tried as the one that is off, and how many are tried.
constexpr double moved_far = 2.0;
constexpr std::size_t most_tried = 4;

// Quasi-BIC of a hypothesis under another declared model, from where it was fitted; infinite where there is no fit.
fit::Counted<double> quasi_bic_under(const replay::DeclaredModel& declared, std::span<const replay::PreparedRun> runs,
                                     const FittedHypothesis& fitted, double overdispersion) {
  const auto anew =
      fit_exactly(runs, {.hypothesis = fit::Hypothesis(declared, fitted.hypothesis.effects_at(fitted.fit.values)),
                         .start = fitted.fit.values,
                         .local_numbers_from = &fitted.fit});
  return {.value = anew.value ? quasi_bic(*anew.value, overdispersion) : std::numeric_limits<double>::infinity(),
          .simulated_runs = anew.simulated_runs};
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

// The places among its calibration of the numbers that a fit has moved far, the furthest first.
std::vector<std::size_t> numbers_moved_far(const FittedHypothesis& fitted) {
  const auto moved = [&](std::size_t i) {
    return std::abs(fitted.hypothesis.parameters()[i].distance(fitted.fit.values[static_cast<Eigen::Index>(i)]));
  };
  std::vector<std::size_t> out;
  for (std::size_t i = 0; i < fitted.hypothesis.declared().calibration.size(); ++i)
    if (fitted.hypothesis.parameters()[i].has_prior() && moved(i) > moved_far) out.push_back(i);
  std::ranges::stable_sort(out, std::ranges::greater{}, moved);
  return out;
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
  const auto bic_without = quasi_bic_under(relaxed, runs, without, overdispersion);
  const auto bic_with = quasi_bic_under(relaxed, runs, with, overdispersion);
  return {.value = bic_without.value - bic_with.value,
          .simulated_runs = bic_without.simulated_runs + bic_with.simulated_runs};
}

fit::Counted<GainOverFreeNumber> gain_over_a_free_number(std::span<const replay::PreparedRun> runs,
                                                         const FittedHypothesis& without, const FittedHypothesis& with,
                                                         double overdispersion) {
  const replay::DeclaredModel& declared = without.hypothesis.declared();
  std::vector<std::size_t> tried = numbers_moved_far(without);
  const std::vector<const actuator::EffectKind*> kinds = with.kinds();
  std::erase_if(tried, [&](std::size_t i) { return is_named_by(declared.calibration[i], kinds); });
  std::vector<DeclaredThing> things;
  for (const std::size_t i : tried) {
    DeclaredThing thing = thing_of(declared.calibration, i);
    if (std::ranges::find(things, thing.name, &DeclaredThing::name) == things.end()) things.push_back(std::move(thing));
  }
  things.resize(std::min(things.size(), most_tried));
  fit::Counted<GainOverFreeNumber> out;
  const double charge = penalty_per_number(with, overdispersion);
  for (const DeclaredThing& thing : things) {
    replay::DeclaredModel freed = declared;
    for (const std::size_t i : thing.numbers) {
      replay::CalibrationParameter& number = freed.calibration[i];
      number.scale *= typical_change;
      if (number.function.empty())
        number.tolerance.reset();
      else
        number.tolerance->deviation *= typical_change;
    }
    const auto bic = quasi_bic_under(freed, runs, without, overdispersion);
    out.simulated_runs += bic.simulated_runs;
    const double gain = bic.value + charge - quasi_bic(with, overdispersion);
    if (gain < out.value.gain) out.value = {.gain = gain, .number = thing.name};
  }
  return out;
}

}  // namespace coilwright::measurement::compare
