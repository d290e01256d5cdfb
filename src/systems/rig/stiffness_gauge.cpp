#include "coilwright/systems/rig/stiffness_gauge.hpp"

#include <cmath>

#include "coilwright/actuator/assemble.hpp"
#include "coilwright/units/angle.hpp"
#include "systems/check.hpp"
#include "systems/rig/models_of.hpp"

namespace coilwright::systems::rig {
namespace {

using actuator::Model;
using mechanics::JointVector;

int joint_of(const Model& model, const StiffnessGauge& gauge) {
  const int joint = gauge.joint.value_or(model.joints() - 1);
  if (joint < 0 || joint >= model.joints())
    throw std::invalid_argument(fmt::format("joint must be from 1 to {}; got {}", model.joints(), joint + 1));
  return joint;
}

double arm_of(const Model& model, const StiffnessGauge& gauge, int joint) {
  const double tip = model.tip().along;
  const double height = gauge.height.value_or(tip);
  require(height > 0.0, "gauge height", "finite and > 0", height * 1e3, "mm");
  if (height > tip * (1.0 + rounding))
    throw std::invalid_argument(fmt::format(
        "gauge height must not lie beyond the tip, {:.6g} mm from its joint; got {:.6g} mm", tip * 1e3, height * 1e3));
  double arm = height;
  for (int link = joint; link < model.joints() - 1; ++link) arm += model.chain().link(link).length;
  return arm;
}

void check(const StiffnessGauge& gauge) {
  require_some(!gauge.angles.empty(), "the angles");
  for (const double angle : gauge.angles)
    require(angle > 0.0 && angle <= 120.0 * units::degree + rounding, "angle", "> 0 and at most 120 deg",
            angle / units::degree, "deg");
}

JointVector open_at(const Model& model, int joint, double angle) {
  JointVector angles = JointVector::Zero(model.joints());
  angles[joint] = angle;
  return angles;
}

}  // namespace

StiffnessGauge paper_stiffness_gauge() {
  StiffnessGauge gauge;
  for (int step = 1; step <= 6; ++step) gauge.angles.push_back(15.0 * step * units::degree);
  return gauge;
}

StiffnessReadings readings(const actuator::Design& design, const StiffnessGauge& gauge) {
  check(gauge);
  const auto models = models_of(design);
  const Model& own = models.of(design.choices.torque);
  StiffnessReadings out{.joint = joint_of(own, gauge)};
  out.arm = arm_of(own, gauge, out.joint);
  for (const double angle : gauge.angles) {
    const auto reading = [&](double torque) {
      return StiffnessReading{.force = torque / out.arm, .stiffness = torque / angle};
    };
    // What the gauge must bring to bear against hinge, magnets and weight.
    const auto posed = [&](bool hangs) {
      return per_fidelity([&](magnetics::Fidelity fidelity) {
        const Model& model = models.of(fidelity);
        const JointVector angles = open_at(model, out.joint, angle);
        const double torque = -model.static_residual(angles, model.all_coils(0.0))[out.joint];
        return reading(hangs ? torque : torque - model.chain().gravity_torques(angles)[out.joint]);
      });
    };
    out.points.push_back({.angle = angle,
                          .level = posed(false),
                          .hanging = posed(true),
                          .hinge_torque = -own.hinge_torques(open_at(own, out.joint, angle))[out.joint],
                          .first_hinge_torque = -own.hinge_torques(open_at(own, 0, angle))[0]});
  }
  return out;
}

StiffnessSpread spread(const StiffnessReadings& readings, PerFidelity<StiffnessReading> StiffnessPoint::*posture,
                       magnetics::Fidelity fidelity) {
  StiffnessSpread out;
  const auto count = static_cast<double>(readings.points.size());
  for (const StiffnessPoint& point : readings.points) out.mean += (point.*posture).of(fidelity).stiffness / count;
  double square = 0.0;
  for (const StiffnessPoint& point : readings.points) {
    const double difference = (point.*posture).of(fidelity).stiffness - out.mean;
    square += difference * difference / count;
  }
  out.deviation = std::sqrt(square);
  return out;
}

}  // namespace coilwright::systems::rig
