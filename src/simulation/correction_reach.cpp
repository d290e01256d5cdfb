#include "coilwright/simulation/correction_reach.hpp"

#include <algorithm>
#include <cmath>

namespace coilwright::simulation {
namespace {

using actuator::CorrectionVariable;
using actuator::Model;
using actuator::TorqueCorrection;

class Reach {
 public:
  explicit Reach(const Model& model) : model_(model) {
    if (const auto& correction = model.nominal_spec().torque_correction)
      for (const actuator::CorrectionAxis& axis : correction->axes)
        out_.push_back(
            {.variable = axis.variable, .measured_from = axis.nodes.front(), .measured_to = axis.nodes.back()});
    used_.assign(out_.size(), false);
  }

  void add(CorrectionVariable variable, double value) {
    for (std::size_t i = 0; i < out_.size(); ++i) {
      if (out_[i].variable != variable) continue;
      out_[i].used_from = used_[i] ? std::min(out_[i].used_from, value) : value;
      out_[i].used_to = used_[i] ? std::max(out_[i].used_to, value) : value;
      used_[i] = true;
    }
  }
  void add_joints(CorrectionVariable variable, const mechanics::JointVector& values) {
    const std::optional<int> only = model_.nominal_spec().torque_correction->joint;
    for (int j = 0; j < values.size(); ++j)
      if (!only || *only == j) add(variable, values[j]);
  }
  void add_coils(const actuator::CoilCurrents& currents) {
    for (const double current : currents) add(CorrectionVariable::current, current);
  }
  [[nodiscard]] bool empty() const { return out_.empty(); }
  [[nodiscard]] std::vector<CorrectionReach> take() { return std::move(out_); }

 private:
  const Model& model_;
  std::vector<CorrectionReach> out_;
  std::vector<bool> used_;
};

}  // namespace

std::vector<CorrectionReach> correction_reach(const Model& model, std::span<const State> states,
                                              std::span<const actuator::CoilCurrents> currents) {
  Reach reach(model);
  if (reach.empty()) return {};
  for (const State& state : states) {
    reach.add_joints(CorrectionVariable::angle, state.angles);
    reach.add_joints(CorrectionVariable::rate, state.rates);
  }
  for (const actuator::CoilCurrents& each : currents) reach.add_coils(each);
  return reach.take();
}

std::vector<CorrectionReach> correction_reach(const Model& model, const FreeMotion& motion, double current) {
  Reach reach(model);
  if (reach.empty()) return {};
  reach.add_joints(CorrectionVariable::angle, motion.rest_angles);
  reach.add_joints(CorrectionVariable::angle, motion.steady_angles);
  // The largest magnitude may be on either side; a joint that bends beyond its end bends to this one.
  const double farthest = motion.steady_angles.size() > 0 ? motion.steady_angles.mean() : 0.0;
  reach.add(CorrectionVariable::angle, std::copysign(motion.peak_joint_angle, farthest));
  reach.add(CorrectionVariable::rate, 0.0);
  reach.add(CorrectionVariable::rate, motion.peak_bending_speed / model.joints());
  reach.add(CorrectionVariable::current, 0.0);
  reach.add_coils(model.strength(motion.steady_angles, model.all_coils(current)));
  return reach.take();
}

}  // namespace coilwright::simulation
