#include "measurement/diagnosis_warnings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace coilwright::measurement {
namespace {

// A residual or an error that exceeds the noise by this factor, or is smaller by it, is reported.
constexpr double notable_ratio = 1.5;
// An error on validate runs is larger than before if it grows by more than this fraction of the noise.
constexpr double notable_growth = 0.1;

// Why the error of a model that explains the fit runs is larger than the noise on others.
std::string reason_for_larger_error(const ErrorComparison& errors) {
  constexpr double deviations = 2.0;
  const double expected = std::hypot(errors.noise_floor_rmse, deviations * errors.uncertainty_rmse);
  return errors.after.rmse <= expected
             ? "no more than the uncertainty of the fitted numbers leaves open there; fit such a run too"
             : "another regime, a start that is not as declared, or another effect";
}

}  // namespace

std::vector<data::Warning> warnings_of(const Diagnosis& diagnosis, std::span<const replay::PreparedRun> runs,
                                       const replay::DeclaredModel& declared) {
  std::vector<data::Warning> out;
  const auto warn = [&](std::string text) { out.push_back({.run = "", .text = std::move(text)}); };
  const double level = diagnosis.after.level;
  const bool given =
      std::ranges::any_of(runs, [](const replay::PreparedRun& prepared) { return prepared.run->sigma.has_value(); });
  if (given && level > notable_ratio)
    warn(fmt::format("what is left is {:.3g} times the noise that the set gives", level));
  if (given && level < 1.0 / notable_ratio)
    warn(
        fmt::format("what is left is only {:.3g} times the noise that the set gives: an effect may hide in it", level));
  if (diagnosis.verdict != Verdict::no_missing_effect)
    for (const std::string& number : declared.uncalibrated_effect_numbers)
      warn(fmt::format("{} stays as declared; it is fitted anew if calibrate names it", number));
  for (const ErrorComparison& errors : diagnosis.validate_errors)
    if (errors.after.rmse > errors.before.rmse + notable_growth * errors.noise_floor_rmse)
      warn("on the runs that no fit has seen the effects make the error larger");
  if (diagnosis.verdict == Verdict::partly_explained || diagnosis.verdict == Verdict::unexplained) return out;
  for (const ErrorComparison& errors : diagnosis.validate_errors)
    if (errors.after.rmse > notable_ratio * errors.noise_floor_rmse)
      warn(fmt::format("on the runs that no fit has seen the error is {:.3g} times the noise: {}",
                       errors.after.rmse / errors.noise_floor_rmse, reason_for_larger_error(errors)));
  return out;
}

}  // namespace coilwright::measurement
