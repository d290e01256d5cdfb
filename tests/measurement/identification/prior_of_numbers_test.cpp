#include "measurement/identification/prior_of_numbers.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "coilwright/actuator/model/effect_catalogue.hpp"

namespace coilwright::measurement::identification {
namespace {

using actuator::Effect;
using actuator::EffectKind;
using actuator::EffectParameter;

constexpr actuator::RigScale finger{.torque = 0.01,
                                    .angle = 0.6,
                                    .rate = 15.0,
                                    .current = 1.1,
                                    .interval = 2e-3,
                                    .duration = 2.0,
                                    .mean_angle = 0.1,
                                    .upper_angle = 0.5,
                                    .lower_angle = -0.2};

double density(const Effect& effect, std::size_t number) {
  const PriorOfNumbers prior = prior_of_numbers(effect, finger);
  std::size_t fitted = 0;
  for (std::size_t i = 0; i < number; ++i)
    if (effect.kind->parameters()[i].choices.empty()) ++fitted;
  return std::exp(prior.log_density) / prior.slopes[fitted];
}

// Over all values of one number, the others being as they are: on either side of where the effect is absent, by the
// logarithm of the distance.
double integral(Effect effect, std::size_t number) {
  const EffectParameter& parameter = effect.kind->parameters()[number];
  const double origin = parameter.absent && std::isfinite(*parameter.absent) ? *parameter.absent : 0.0;
  double sum = 0.0;
  for (const double sign : {-1.0, 1.0}) {
    const double reach = sign > 0.0 ? parameter.upper - origin : origin - parameter.lower;
    const double least = sign > 0.0 ? parameter.lower - origin : origin - parameter.upper;
    if (!(reach > 0.0)) continue;
    const double first = least > 0.0 ? std::log(least) : -40.0;
    const double last = std::min(std::log(reach), 40.0);
    constexpr int steps = 4000;
    const double step = (last - first) / steps;
    for (int i = 0; i <= steps; ++i) {
      const double away = std::exp(first + i * step);
      effect.values[number] = origin + sign * away;
      sum += (i == 0 || i == steps ? 0.5 : 1.0) * step * away * density(effect, number);
    }
  }
  return sum;
}

std::vector<const EffectKind*> kinds() {
  std::vector<const EffectKind*> out;
  for (const EffectKind* kind : actuator::standard_effects().kinds())
    if (!kind->parameters().empty()) out.push_back(kind);
  return out;
}

class PriorOfNumbersOf : public testing::TestWithParam<const EffectKind*> {};

// With l_i the logarithms of the densities of n independent numbers and L their sum, the integral over one of them is
// exp(L - l_i) if each density is one: their logarithms add up to (n - 1) L. Below a thousandth of a typical magnitude
// the density is held, which adds 0.0006 to a number without bounds; bounds cut off up to a half.
TEST_P(PriorOfNumbersOf, IsADensity) {
  const EffectKind& kind = *GetParam();
  const Effect effect{.kind = &kind, .values = kind.starts(finger).front()};
  double sum = 0.0;
  double choices = 0.0;
  int fitted = 0;
  for (std::size_t i = 0; i < effect.values.size(); ++i) {
    const EffectParameter& number = kind.parameters()[i];
    if (!number.choices.empty()) {
      choices += std::log(static_cast<double>(number.choices.size()));
      continue;
    }
    ++fitted;
    sum += std::log(integral(effect, i));
  }
  EXPECT_NEAR(sum, (fitted - 1) * prior_of_numbers(effect, finger).log_density - choices, 1.2e-3 * fitted);
}

INSTANTIATE_TEST_SUITE_P(Catalogue, PriorOfNumbersOf, testing::ValuesIn(kinds()),
                         [](const auto& each) { return std::string(each.param->id()); });

double log_density_of(const char* id, const std::vector<double>& values) {
  return prior_of_numbers({.kind = actuator::standard_effects().find(id), .values = values}, finger).log_density;
}

// A time constant of a second is no rarer for being far from the longest that a fit may try.
TEST(PriorOfNumbers, KnowsATimeConstantToAFactor) {
  const double typical = std::sqrt(0.1 * 6.0);  // s: the starts lie evenly from a twentieth of a run to three of them
  EXPECT_NEAR(
      log_density_of("coil_heating", {0.1, typical, 0.0}) - log_density_of("coil_heating", {0.1, 10.0 * typical, 0.0}),
      0.5, 1e-9);
}

}  // namespace
}  // namespace coilwright::measurement::identification
