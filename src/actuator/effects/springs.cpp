#include <algorithm>
#include <cmath>

#include "actuator/effects/effect_rows.hpp"

// The hinges' springs are not as declared. Those that change a spring stand before those that read it.
namespace coilwright::actuator::effects {
namespace {

using mechanics::JointVector;

// As far as the spring's slope stays positive, 1 + 3 beta theta^2 > 0; beyond, a softening spring keeps its torque
// instead of letting go. At the lowest beta that is one radian.
Term hardening(const JointVector& stiffness, double coefficient) {
  const double turn = coefficient < 0.0 ? 1.0 / std::sqrt(-3.0 * coefficient) : infinity;
  return added_torque([=](const EffectTerm::Kinematics& motion, JointVector& torques) {
    for (int j = 0; j < stiffness.size(); ++j) {
      const double angle = motion.angles[j];
      const double within = std::clamp(angle, -turn, turn);
      torques[j] -= stiffness[j] * (coefficient * within * within * within - (angle - within));
    }
  });
}

}  // namespace

EffectProperties joint_asymmetry() {
  return {.id = "joint_asymmetry",
          .stage = Stage::hinge,
          .description = "the joints are not alike",
          .equation = "k_2 -> rho k_2, of every second joint; k_2 = rho k_1 where they are declared alike",
          .source = "k ~ h_b^3 of a moulded hinge: 5 % in its height are 16 % in its stiffness",
          .check = "measure the stiffness of each joint by itself with a force gauge",
          .parameters = {about_one("stiffness_ratio", "of every second joint's stiffness to its declared one", 10.0)},
          .starts = always({0.8, 1.25}),
          .build = [](Values values, ModelSpec& spec) -> Term {
            for (std::size_t j = 1; j < spec.hinges.size(); j += 2) spec.hinges[j].stiffness *= values[0];
            return nullptr;
          },
          .inapplicable = [](const ModelSpec& spec) -> std::optional<std::string> {
            if (spec.hinges.size() < 2) return "the model has one joint only";
            for (std::size_t j = 1; j < spec.hinges.size(); j += 2)
              if (spec.hinges[j].stiffness > 0.0) return std::nullopt;
            return "no second joint has a spring";
          }};
}

EffectProperties rest_angle() {
  return {.id = "rest_angle",
          .stage = Stage::hinge,
          .description = "the hinges relax at an angle of their own: pre-stress, set",
          .equation = "q = -k (theta - theta_0), every joint",
          .source = "linear spring with a natural angle; definition",
          .check = "lay the finger on its side, without current, and read the angle of its joints",
          .parameters = {about_zero("angle_deg", "angle at which a hinge is relaxed, every joint", 45.0 / degrees)},
          .starts = always({2.0 / degrees, -2.0 / degrees}),
          .build = [](Values values, ModelSpec& spec) -> Term {
            for (Hinge& hinge : spec.hinges) hinge.torque_offset += hinge.stiffness * values[0];
            return nullptr;
          },
          .inapplicable = without_springs};
}

EffectProperties stiffness_hardening() {
  return {.id = "stiffness_hardening",
          .stage = Stage::hinge,
          .description = "the hinge is not linear: it stiffens (or softens) with the angle",
          .equation = "q -= k beta theta^3; where 1 + 3 beta theta^2 < 0 the whole spring's torque stays",
          .source = "first odd term of a hyperelastic spring: Duffing; Gent, Rubber Chem. Technol. 69 (1996) 59",
          .check = "measure the torque of a joint over its angle with a force gauge, up to the largest angle",
          .parameters = {{.key = "coefficient_1_rad2",
                          .text = "share of the stiffness gained at one radian",
                          .lower = -1.0 / 3.0,
                          .upper = 1e3,
                          .absent = 0.0}},
          .starts =
              [](const RigScale& scale) {
                const double square = scale.angle * scale.angle;
                return one_by_one({std::min(0.2 / square, 1e2), std::max(-0.05 / square, -0.2)});
              },
          .build = [](Values values, ModelSpec& spec) { return hardening(stiffnesses(spec), values[0]); },
          .inapplicable = without_springs};
}

}  // namespace coilwright::actuator::effects
