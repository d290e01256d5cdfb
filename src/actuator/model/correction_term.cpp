#include <fmt/format.h>

#include <stdexcept>
#include <vector>

#include "coilwright/actuator/model/model_spec.hpp"
#include "coilwright/actuator/model/torque_correction.hpp"

namespace coilwright::actuator {
namespace {

class CorrectionTerm final : public EffectTerm {
 public:
  CorrectionTerm(const TorqueCorrection& correction, const ModelSpec& spec)
      : surface_(correction), coil_of_joint_(static_cast<std::size_t>(spec.chain.joints()), -1) {
    for (const CorrectionAxis& axis : correction.axes) variables_.push_back(axis.variable);
    for (int j = 0; j < spec.chain.joints(); ++j)
      if (!correction.joint || *correction.joint == j) joints_.push_back(j);
    for (const HingePair& pair : spec.magnetics.hinge_pairs())
      coil_of_joint_[static_cast<std::size_t>(pair.joint)] = pair.coil;
  }

  void add_torques(const Kinematics& motion, const CoilCurrents& strength, InternalStateView /*own*/,
                   mechanics::JointVector& torques) const override {
    for (const int j : joints_) torques[j] += value_at(motion, strength, j).torque;
  }

  void add_damping(const Kinematics& motion, const CoilCurrents& strength,
                   mechanics::JointMatrix& damping) const override {
    for (std::size_t v = 0; v < variables_.size(); ++v) {
      if (variables_[v] != CorrectionVariable::rate) continue;
      for (const int j : joints_) damping(j, j) -= value_at(motion, strength, j).slopes[v];
    }
  }

 private:
  [[nodiscard]] double variable(std::size_t which, const Kinematics& motion, const CoilCurrents& strength,
                                int joint) const {
    switch (variables_[which]) {
      case CorrectionVariable::angle:
        return motion.angles[joint];
      case CorrectionVariable::rate:
        return motion.rates[joint];
      case CorrectionVariable::current:
        break;
    }
    const int coil = coil_of_joint_[static_cast<std::size_t>(joint)];
    return coil >= 0 ? strength[coil] : strength.mean();
  }
  [[nodiscard]] TorqueSurface::Value value_at(const Kinematics& motion, const CoilCurrents& strength, int joint) const {
    return surface_.at(variable(0, motion, strength, joint),
                       variables_.size() > 1 ? variable(1, motion, strength, joint) : 0.0);
  }

  TorqueSurface surface_;
  std::vector<CorrectionVariable> variables_;
  std::vector<int> joints_;
  std::vector<int> coil_of_joint_;  // -1: none
};

}  // namespace

std::unique_ptr<const EffectTerm> correction_term(const TorqueCorrection& correction, const ModelSpec& spec) {
  validate(correction);
  if (correction.joint && (*correction.joint < 0 || *correction.joint >= spec.chain.joints()))
    throw std::invalid_argument(
        fmt::format("torque_correction: joint must be 1 to {}; got {}", spec.chain.joints(), *correction.joint + 1));
  for (const CorrectionAxis& axis : correction.axes)
    if (axis.variable == CorrectionVariable::current && spec.coils == 0)
      throw std::invalid_argument("torque_correction: over the current needs coils, and the model has none");
  return std::make_unique<CorrectionTerm>(correction, spec);
}

}  // namespace coilwright::actuator
