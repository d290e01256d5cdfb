#include "coilwright/measurement/replay/declare.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

#include "coilwright/actuator/assemble.hpp"
#include "coilwright/actuator/heat.hpp"
#include "coilwright/measurement/replay/calibration_target.hpp"
#include "coilwright/measurement/replay/mean_of_joints.hpp"

namespace coilwright::measurement::replay {
namespace {

using actuator::Hinge;
using actuator::ModelSpec;

// A number of all joints that a fit may move.
struct SharedNumber {
  double Hinge::*member{};
  MeanOfJoints value{};
};

CalibrationParameter parameter_of(JointNumber which, double mean) {
  return {.key = which == JointNumber::stiffness ? "joint_stiffness_Nmm_rad" : "joint_damping_Nmms_rad",
          .declared = mean,
          .lower = 0.0,
          .upper = std::numeric_limits<double>::infinity(),
          .scale = mean};
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
    double Hinge::*const member = *which == JointNumber::stiffness ? &Hinge::stiffness : &Hinge::damping;
    const MeanOfJoints value = mean_of_joints(spec.hinges, member);
    if (value.mean == 0.0) continue;
    numbers.push_back({.member = member, .value = value});
    declared.calibration.push_back(parameter_of(*which, value.mean));
  }
  declared.build = [spec = std::move(spec), numbers = std::move(numbers)](std::span<const double> values) {
    require_values(values, numbers.size());
    ModelSpec built = spec;
    for (std::size_t i = 0; i < numbers.size(); ++i)
      for (std::size_t j = 0; j < built.hinges.size(); ++j)
        built.hinges[j].*numbers[i].member = values[i] * numbers[i].value.ratios[j];
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
