#include "coilwright/measurement/replay/declare.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

#include "coilwright/actuator/assemble.hpp"
#include "coilwright/actuator/heat.hpp"

namespace coilwright::measurement::replay {
namespace {

using actuator::Hinge;
using actuator::ModelSpec;

// A number of all joints: its mean, SI, and what each joint has of it.
struct SharedNumber {
  double Hinge::*member{};
  double mean{};
  std::vector<double> ratios{};
};

SharedNumber shared(const std::vector<Hinge>& hinges, double Hinge::*member) {
  SharedNumber number{.member = member};
  const double first = hinges.front().*member;
  const bool alike = std::ranges::all_of(hinges, [&](const Hinge& hinge) { return hinge.*member == first; });
  for (const Hinge& hinge : hinges) number.mean += hinge.*member / static_cast<double>(hinges.size());
  if (alike) number.mean = first;  // to the bit
  for (const Hinge& hinge : hinges) number.ratios.push_back(alike ? 1.0 : hinge.*member / number.mean);
  return number;
}

CalibrationParameter parameter_of(JointNumber which, const SharedNumber& number) {
  return {.key = which == JointNumber::stiffness ? "joint_stiffness_Nmm_rad" : "joint_damping_Nmms_rad",
          .declared = number.mean,
          .lower = 0.0,
          .upper = std::numeric_limits<double>::infinity(),
          .scale = number.mean};
}

// Numbers of declared effects that a fit could move and that stay as they are.
std::vector<std::string> uncalibrated_numbers(const std::vector<actuator::Effect>& effects) {
  std::vector<std::string> names;
  for (const actuator::Effect& effect : effects)
    for (const actuator::EffectParameter& number : effect.kind->parameters())
      if (number.choices.empty()) names.push_back(fmt::format("{} of {}", number.key, effect.kind->id()));
  return names;
}

}  // namespace

DeclaredModel declare(ModelSpec spec, const std::vector<JointNumber>& calibrated) {
  DeclaredModel declared;
  declared.uncalibrated_effect_numbers = uncalibrated_numbers(spec.effects);
  std::vector<SharedNumber> numbers;
  for (auto which = calibrated.begin(); which != calibrated.end(); ++which) {
    if (std::find(calibrated.begin(), which, *which) != which)
      throw std::invalid_argument("calibrated: must not name a number twice");
    const SharedNumber number =
        shared(spec.hinges, *which == JointNumber::stiffness ? &Hinge::stiffness : &Hinge::damping);
    if (number.mean == 0.0) continue;
    numbers.push_back(number);
    declared.calibration.push_back(parameter_of(*which, number));
  }
  declared.build = [spec = std::move(spec), numbers = std::move(numbers)](std::span<const double> values) {
    if (values.size() != numbers.size())
      throw std::invalid_argument(
          fmt::format("calibration must have {} values; got {}", numbers.size(), values.size()));
    ModelSpec built = spec;
    for (std::size_t i = 0; i < numbers.size(); ++i)
      for (std::size_t j = 0; j < built.hinges.size(); ++j)
        built.hinges[j].*numbers[i].member = values[i] * numbers[i].ratios[j];
    return built;
  };
  return declared;
}

DeclaredModel declare(const actuator::Design& design, const std::vector<JointNumber>& calibrated) {
  const actuator::Assembly assembly = actuator::assemble_or_throw(design);
  DeclaredModel declared = declare(assembly.model.nominal_spec(), calibrated);
  declared.heat = actuator::heat_network(design, assembly);
  return declared;
}

}  // namespace coilwright::measurement::replay
