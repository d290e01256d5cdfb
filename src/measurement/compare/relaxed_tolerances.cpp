#include "measurement/compare/relaxed_tolerances.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "measurement/compare/staged_fit.hpp"

namespace coilwright::measurement::compare {
namespace {

constexpr double wider = 3.0;

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

}  // namespace coilwright::measurement::compare
