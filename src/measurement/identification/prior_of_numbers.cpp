#include "measurement/identification/prior_of_numbers.hpp"

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <numbers>
#include <optional>
#include <span>

namespace coilwright::measurement::identification {
namespace {

using actuator::Effect;
using actuator::EffectKind;
using actuator::EffectParameter;

// What a magnitude is known to before the records are seen: a factor of ten either way.
constexpr double log_deviation = std::numbers::ln10;
// A magnitude counts as no smaller than this fraction of a typical one: a fit that ends where its effect is absent.
constexpr double least_magnitude = 1e-3;

double normal_log_density(double u) {
  return -0.5 * (u * u + std::log(2.0 * std::numbers::pi));
}

// The value at which the effect is absent, of a magnitude; nothing of a shape, or where it is at infinity.
std::optional<double> origin_of(const EffectParameter& number) {
  return number.absent && std::isfinite(*number.absent) ? number.absent : std::nullopt;
}

// Geometric mean of the catalogue's starts, from the origin.
double typical(const EffectKind& kind, std::size_t number, const actuator::RigScale& scale) {
  const double origin = origin_of(kind.parameters()[number]).value_or(0.0);
  double sum = 0.0;
  int count = 0;
  for (const std::vector<double>& start : kind.starts(scale)) {
    const double away = std::abs(start[number] - origin);
    if (!(away > 0.0)) continue;
    sum += std::log(away);
    ++count;
  }
  return count == 0 ? 1.0 : std::exp(sum / count);
}

// Standard normal coordinate of a magnitude, >= 0.
double log_coordinate(double magnitude, double about) {
  return std::log(magnitude / about) / log_deviation;
}

// Probability that a magnitude lies between two bounds, of which the upper one may be infinite.
double probability_between(double low, double high, double about) {
  const boost::math::normal standard;
  return boost::math::cdf(standard, log_coordinate(high, about)) -
         boost::math::cdf(standard, log_coordinate(low, about));
}

// `possible`: the probability of all that its bounds allow.
void add_log_normal(double magnitude, double about, double possible, PriorOfNumbers& out) {
  const double held = std::max(magnitude, least_magnitude * about);
  out.log_density += normal_log_density(log_coordinate(held, about)) - std::log(possible);
  out.slopes.push_back(held * log_deviation);
  out.precisions.push_back(1.0);
}

void add_number(const Effect& effect, std::size_t index, const actuator::RigScale& scale, PriorOfNumbers& out) {
  const EffectParameter& number = effect.kind->parameters()[index];
  const double value = effect.values[index];
  const double about = typical(*effect.kind, index, scale);
  if (number.deviation) {
    out.log_density += normal_log_density((value - number.absent.value_or(0.0)) / *number.deviation);
    out.slopes.push_back(*number.deviation);
    out.precisions.push_back(1.0);
  } else if (const std::optional<double> origin = origin_of(number)) {
    const double possible = probability_between(0.0, number.upper - *origin, about) +
                            probability_between(0.0, *origin - number.lower, about);
    add_log_normal(std::abs(value - *origin), about, possible, out);
  } else if (number.lower < 0.0) {
    // What Laplace's approximation makes of a uniform prior is right where the data know more.
    out.slopes.push_back(number.upper - number.lower);
    out.precisions.push_back(12.0);
  } else {
    add_log_normal(value, about, probability_between(number.lower, number.upper, about), out);
  }
}

}  // namespace

PriorOfNumbers prior_of_numbers(const Effect& effect, const actuator::RigScale& scale) {
  PriorOfNumbers out;
  const std::span<const EffectParameter> numbers = effect.kind->parameters();
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (numbers[i].choices.empty())
      add_number(effect, i, scale, out);
    else
      out.log_density -= std::log(static_cast<double>(numbers[i].choices.size()));
  }
  return out;
}

}  // namespace coilwright::measurement::identification
