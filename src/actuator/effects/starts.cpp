#include "actuator/effects/starts.hpp"

#include <cmath>

namespace coilwright::actuator::effects {

std::vector<double> log_spread(double low, double high, int count) {
  if (!(high > low)) return {low};
  std::vector<double> values;
  for (int i = 0; i < count; ++i) values.push_back(low * std::pow(high / low, static_cast<double>(i) / (count - 1)));
  return values;
}

std::vector<std::vector<double>> one_by_one(const std::vector<double>& values) {
  std::vector<std::vector<double>> out;
  for (const double value : values) out.push_back({value});
  return out;
}

std::vector<std::vector<double>> each_with_each(const std::vector<double>& first, const std::vector<double>& second) {
  std::vector<std::vector<double>> out;
  for (const double a : first)
    for (const double b : second) out.push_back({a, b});
  return out;
}

}  // namespace coilwright::actuator::effects
