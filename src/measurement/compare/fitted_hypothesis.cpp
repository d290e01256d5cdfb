#include "measurement/compare/fitted_hypothesis.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "coilwright/measurement/whiteness/correlation_time.hpp"

namespace coilwright::measurement::compare {

double Scored::excess() const {
  return fit.chi_square - static_cast<double>(fit.samples());
}

std::vector<const actuator::EffectKind*> Scored::kinds() const {
  std::vector<const actuator::EffectKind*> out;
  for (const actuator::Effect& effect : hypothesis.effects()) out.push_back(effect.kind);
  return out;
}

Scored scored(std::span<const replay::Record> records, fit::Hypothesis hypothesis, fit::Fit fitted) {
  const whiteness::Adequacy adequacy =
      whiteness::adequacy_of(fit::scaled_residuals(records, fitted), static_cast<int>(hypothesis.size()));
  return {.hypothesis = std::move(hypothesis), .fit = std::move(fitted), .adequacy = adequacy};
}

double unit_of_evidence(std::span<const replay::Record> records, const Scored& reference) {
  if (reference.adequacy.noise_only()) return 1.0;
  const double mean_square = reference.fit.chi_square / static_cast<double>(reference.fit.samples());
  return std::max(1.0, mean_square * whiteness::correlation_time(fit::scaled_residuals(records, reference.fit)));
}

double criterion(const Scored& s, double unit) {
  const auto samples = static_cast<double>(s.fit.samples());
  const double charge = std::log(std::max(std::exp(1.0), samples / unit));
  return s.fit.chi_square / unit + static_cast<double>(s.hypothesis.size()) * charge;
}

Evidence evidence(std::span<const replay::Record> records, const Scored& without, const Scored& with, double unit) {
  return {.chi_square_before = without.fit.chi_square,
          .chi_square_after = with.fit.chi_square,
          .criterion_gain = criterion(without, unit) - criterion(with, unit),
          .cross_validated_gain = std::numeric_limits<double>::quiet_NaN(),
          .correlation_time = whiteness::correlation_time(fit::scaled_residuals(records, with.fit))};
}

}  // namespace coilwright::measurement::compare
