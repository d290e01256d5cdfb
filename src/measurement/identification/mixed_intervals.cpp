#include "measurement/identification/mixed_intervals.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

#include "measurement/identification/curvature.hpp"

namespace coilwright::measurement::identification {
namespace {

// A number of the reported hypothesis: a declared one, or one of an effect.
struct Number {
  const actuator::EffectKind* effect{};  // null: declared
  Eigen::Index at{};                     // among the declared numbers, or those of the effect
};

std::vector<Number> numbers_of(const fit::Hypothesis& hypothesis) {
  std::vector<Number> out;
  for (std::size_t i = 0; i < hypothesis.declared().calibration.size(); ++i)
    out.push_back({.effect = nullptr, .at = static_cast<Eigen::Index>(i)});
  for (std::size_t e = 0; e < hypothesis.effects().size(); ++e)
    for (std::size_t i = 0; i < hypothesis.parameters_of(e).numbers.size(); ++i)
      out.push_back({.effect = hypothesis.effects()[e].kind, .at = static_cast<Eigen::Index>(i)});
  return out;
}

// Where a hypothesis has it; nothing where it has not.
std::optional<Eigen::Index> place_in(const Number& number, const WeighedHypothesis& hypothesis,
                                     const WeighedFit& weighed) {
  if (number.effect == nullptr) return number.at;
  const auto found = std::ranges::find(hypothesis.effects, number.effect);
  if (found == hypothesis.effects.end()) return std::nullopt;
  return weighed.first_of_effects[static_cast<std::size_t>(found - hypothesis.effects.begin())] + number.at;
}

double variance_about(double value, const Number& number, const Attribution& attribution) {
  double squares = 0.0, weights = 0.0;
  for (std::size_t i = 0; i < attribution.weighed.size(); ++i) {
    const WeighedHypothesis& hypothesis = attribution.posterior.hypotheses[i];
    const WeighedFit& weighed = attribution.weighed[i];
    const auto place = place_in(number, hypothesis, weighed);
    if (!place) continue;
    squares +=
        hypothesis.probability * (weighed.covariance(*place, *place) + std::pow(weighed.values[*place] - value, 2));
    weights += hypothesis.probability;
  }
  return squares / weights;
}

}  // namespace

void widen_by_posterior(std::vector<Estimate>& estimates, const Attribution& attribution, double overdispersion) {
  const fit::Hypothesis& hypothesis = attribution.after.hypothesis;
  const Eigen::VectorXd own = standard_deviations(attribution.after, overdispersion);
  const std::vector<Number> numbers = numbers_of(hypothesis);
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const double deviation = own[static_cast<Eigen::Index>(i)];
    if (!std::isfinite(deviation)) continue;
    const double beyond = variance_about(estimates[i].value, numbers[i], attribution) - deviation * deviation;
    if (beyond > 0.0) widen(estimates[i], hypothesis.parameters()[i], beyond);
  }
}

}  // namespace coilwright::measurement::identification
