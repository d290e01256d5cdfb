#include "held_joints.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>

namespace coilwright::simulation {

using mechanics::JointMatrix;
using mechanics::JointVector;

// Slopes with some joints at rest as functions of the shares y of friction on them: they are linear in these.
struct HeldJoints::Pull {
  PackedState free;                   // without friction on them
  std::vector<PackedState> by_share;  // what the whole friction of each adds
  JointVector acceleration;           // of them, rad/s^2: acceleration + matrix y
  JointMatrix matrix;
};

HeldJoints::HeldJoints(const actuator::Model& model) : model_(model), signs_(JointVector::Zero(model.joints())) {}

bool HeldJoints::holds(int joint) const {
  return std::ranges::find(held_, joint) != held_.end();
}

void HeldJoints::set(const JointVector& shares, PackedState& values) const {
  const auto first = 2 * static_cast<std::size_t>(model_.joints());
  model_.set_friction(shares, {values.data() + first, values.size() - first});
}

HeldJoints::Pull HeldJoints::pull_on(const std::vector<int>& joints, PackedState values,
                                     const Derivative& derive) const {
  // rad/s^2: a friction without any torque, of a drive that has none, counts as one that could just do this.
  constexpr double weakest = 1e-9;
  const auto count = static_cast<Eigen::Index>(joints.size());
  JointVector shares = signs_;
  const auto slopes = [&] {
    PackedState out(values.size(), 0.0);
    set(shares, values);
    derive(values, out);
    return out;
  };
  const auto accelerations = [&](const PackedState& of) {
    JointVector out(count);
    for (Eigen::Index k = 0; k < count; ++k)
      out[k] = of[static_cast<std::size_t>(model_.joints() + joints[static_cast<std::size_t>(k)])];
    return out;
  };
  for (const int joint : joints) shares[joint] = 0.0;
  Pull out{.free = slopes(), .by_share = {}, .acceleration = {}, .matrix = JointMatrix(count, count)};
  out.acceleration = accelerations(out.free);
  for (Eigen::Index k = 0; k < count; ++k) {
    double& share = shares[joints[static_cast<std::size_t>(k)]];
    share = 1.0;
    PackedState& more = out.by_share.emplace_back(slopes());
    share = 0.0;
    for (std::size_t i = 0; i < more.size(); ++i) more[i] -= out.free[i];
    out.matrix.col(k) = accelerations(more);
    out.matrix(k, k) -= weakest;
  }
  return out;
}

void HeldJoints::decide(const PackedState& values, int slipping, const Derivative& derive) {
  std::vector<int> resting;
  for (int j = 0; j < model_.joints(); ++j) {
    const double rate = values[static_cast<std::size_t>(model_.joints() + j)];
    signs_[j] = rate > 0.0 ? 1.0 : rate < 0.0 ? -1.0 : 0.0;
    if (rate == 0.0) resting.push_back(j);
  }
  held_.clear();
  if (!resting.empty()) {
    const Pull pull = pull_on(resting, values, derive);
    // Gauss and Seidel's method for the shares, each within its bounds: it converges, since M is positive definite.
    constexpr int most = 1000;
    JointVector shares = JointVector::Zero(pull.acceleration.size());
    double moved = 1.0;
    for (int sweep = 0; sweep < most && moved > 1e-14; ++sweep) {
      moved = 0.0;
      for (Eigen::Index k = 0; k < shares.size(); ++k) {
        const double left = pull.acceleration[k] + pull.matrix.row(k).dot(shares);
        const double share = std::clamp(shares[k] - left / pull.matrix(k, k), -1.0, 1.0);
        moved = std::max(moved, std::abs(share - shares[k]));
        shares[k] = share;
      }
    }
    for (Eigen::Index k = 0; k < shares.size(); ++k) {
      const int joint = resting[static_cast<std::size_t>(k)];
      if (std::abs(shares[k]) < 1.0 && joint != slipping)
        held_.push_back(joint);
      else
        signs_[joint] = std::copysign(1.0, shares[k]);
    }
  }
}

void HeldJoints::stop(PackedState& values) const {
  for (const int joint : held_) values[static_cast<std::size_t>(model_.joints() + joint)] = 0.0;
}

void HeldJoints::hold(PackedState values, PackedState& slopes, const Derivative& derive) const {
  stop(values);
  Pull pull = pull_on(held_, std::move(values), derive);
  const JointVector found = pull.matrix.partialPivLu().solve(-pull.acceleration);
  for (std::size_t k = 0; k < held_.size(); ++k)
    for (std::size_t i = 0; i < slopes.size(); ++i)
      pull.free[i] += found[static_cast<Eigen::Index>(k)] * pull.by_share[k][i];
  stop(pull.free);
  slopes = pull.free;
}

JointVector HeldJoints::shares(PackedState values, const Derivative& derive) const {
  stop(values);
  const Pull pull = pull_on(held_, std::move(values), derive);
  const JointVector found = pull.matrix.partialPivLu().solve(-pull.acceleration);
  JointVector out = signs_;
  for (std::size_t k = 0; k < held_.size(); ++k) out[held_[k]] = found[static_cast<Eigen::Index>(k)];
  return out;
}

}  // namespace coilwright::simulation
