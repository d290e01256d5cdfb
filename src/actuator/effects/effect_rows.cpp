#include "actuator/effects/effect_rows.hpp"

#include <algorithm>
#include <cmath>

namespace coilwright::actuator::effects {

std::vector<double> log_spread(double low, double high, int count) {
  if (!(high > low)) return {low};
  std::vector<double> values;
  for (int i = 0; i < count; ++i) values.push_back(low * std::pow(high / low, static_cast<double>(i) / (count - 1)));
  return values;
}

Starts one_by_one(const std::vector<double>& values) {
  Starts out;
  for (const double value : values) out.push_back({value});
  return out;
}

Starts each_with_each(const std::vector<double>& first, const std::vector<double>& second) {
  Starts out;
  for (const double a : first)
    for (const double b : second) out.push_back({a, b});
  return out;
}

std::optional<std::string> without_coils(const ModelSpec& spec) {
  return spec.coils > 0 ? std::nullopt : std::optional<std::string>("the model has no coils");
}

std::optional<std::string> without_springs(const ModelSpec& spec) {
  if (std::ranges::any_of(spec.hinges, [](const Hinge& hinge) { return hinge.stiffness > 0.0; })) return std::nullopt;
  return "no joint has a spring";
}

std::optional<std::string> without_shafts(const ModelSpec& spec) {
  const auto is_across = [](const HingePair& pair) { return pair.parts != nullptr; };
  if (std::ranges::any_of(spec.magnetics.hinge_pairs(), is_across))
    return "coil and magnet act across the joint, without a motor's shaft";
  return std::nullopt;
}

mechanics::JointVector stiffnesses(const ModelSpec& spec) {
  mechanics::JointVector k(static_cast<int>(spec.hinges.size()));
  for (int j = 0; j < k.size(); ++j) k[j] = spec.hinges[j].stiffness;
  return k;
}

}  // namespace coilwright::actuator::effects
